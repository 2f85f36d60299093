#!/bin/sh
# Curves and preloads become laws of scenes: solved where the answer is a row of the file.
#   curves.sh HALFWAY_IMPORT HALFWAY SAMPLES
set -eu
import=$1 halfway=$2 samples=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "FAILED: $*" >&2; exit 1; }

"$import" import "$samples/mount.bus" --as attached_a >said 2>told || fail "$(cat told)"
grep -q '^interpolation = "akima"$' mount.toml || fail "no Akima: $(cat mount.toml)"

# Rows of the file, in SI: 200 N at 1 mm, 900 N at 2 mm; 4 N m at 10 degrees about y.
solved() {  # TYPE VALUE OUTPUT WANTED
  sed -e "s/^type = \"fixed_.*/type = \"$1\"/" -e "s/^value = .*/value = $2/" mount.toml >loaded.toml
  "$halfway" run loaded.toml --format csv --out run >ran 2>&1 || { cat ran; fail "$1 $2"; }
  awk -F, -v name="$3" -v wanted="$4" 'NR == 1 {for (i = 1; i <= NF; ++i) if ($i == name) column = i}
    {last = $column} END {exit !(column && (last - wanted) ^ 2 < (1e-9 * wanted) ^ 2)}' run/loaded/curve.csv ||
    { cat run/loaded/curve.csv; fail "$1 $2: $3 is not $4"; }
}
solved fixed_force '[200, 0, 0]' u_x 0.001
solved fixed_force '[900, 0, 0]' u_x 0.002
solved fixed_force '[0, 250, 0]' u_y 0.0005
solved fixed_moment '[0, 4, 0]' theta_y 0.17453292519943295

# A preload of the file: -10 N along y of the joint, in the written law; the scenes are solved.
"$import" import "$samples/bushing_force.adm" --as attached_a >said 2>told || fail "$(cat told)"
grep -q '^preload = \[0, -10, 0, 0, 0, 0\]$' bushing_force.toml || fail "preload: $(cat bushing_force.toml)"
"$import" import "$samples/mbdyn_prestress.mbd" --name 11 --out prestress.toml >said 2>told || fail "$(cat told)"
grep -q '^preload = \[0, 10, 0, 0, 0, 0.5\]$' prestress.toml || fail "prestress: $(cat prestress.toml)"
for scene in bushing_force prestress; do
  "$halfway" run $scene.toml --format csv --out run >ran 2>&1 || { cat ran; fail "$scene is not solved"; }
done
echo "curves and preloads: rows of the file"
