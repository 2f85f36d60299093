#!/bin/sh
# The commands themselves: files in and out, refusals, exit codes, written scenes solved.
#   commands.sh HALFWAY_IMPORT HALFWAY SAMPLES
set -eu
import=$1 halfway=$2 samples=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
fail() { echo "FAILED: $*" >&2; exit 1; }
refused() {  # STATUS WORDS COMMAND ARGUMENT...
  wanted=$1 words=$2 status=0
  shift 2
  "$import" "$@" >said 2>&1 || status=$?
  [ $status -eq "$wanted" ] || { cat said; fail "$* ended with $status, not $wanted"; }
  grep -qF -- "$words" said || { cat said; fail "$* does not say '$words'"; }
}
imported() {  # ARGUMENT...
  "$import" import "$@" >said 2>told || { cat told; fail "import $*"; }
}

# Every sample that holds its law becomes scenes, and each scene is solved with that law alone.
for sample in drake.sdf opensim_old.osim opensim_new.osim chrono.json mbdyn.mbd; do imported "$samples/$sample"; done
imported "$samples/drake.urdf" --out urdf.toml
imported "$samples/chrono.yaml" --out yaml.toml
for sample in straight.bus bushing.adm bush.bdf; do imported "$samples/$sample" --as field_a; done
scenes=0
for scene in *.toml; do
  "$halfway" run "$scene" --format csv --out run >ran 2>&1 || { cat ran; fail "$scene is not solved"; }
  grep -qE '^\[1/1\] [a-z_]+: converged$' ran || { cat ran; fail "$scene: not one law, or not solved"; }
  grep -q '^# EXAMPLE LOAD: the file holds none' "$scene" || fail "$scene does not mark its load"
  grep -q '^# line [0-9]*: ' "$scene" || fail "$scene does not say where its numbers are from"
  scenes=$((scenes + 1))
done
[ "$scenes" -eq 15 ] || fail "$scenes scenes, not 15"

# What is said: on stderr, what was lost with its line; on stdout the file.
rm drake.toml
imported "$samples/drake.sdf"
[ "$(cat said)" = 'wrote drake.toml' ] || fail "stdout: $(cat said)"
grep -qF 'lost: drake:bushing_torque_damping = 0.4 0.5 0.6 (line 23): a scene has no damping' told || fail "what was lost: $(cat told)"
grep -qF 'line 22: drake:bushing_torque_stiffness = 20 30 70' told || fail "where from: $(cat told)"

# Nothing is replaced unasked, and nothing is left half.
echo precious >drake.toml
refused 2 'drake.toml: is there already; allowed: --force' import "$samples/drake.sdf"
[ "$(cat drake.toml)" = precious ] || fail "drake.toml was replaced"
imported "$samples/drake.sdf" --force
grep -q '^title' drake.toml || fail "--force did not replace"
mkdir taken.toml
refused 2 'taken.toml: is a folder' import "$samples/drake.sdf" --out taken.toml --force
refused 1 'cannot' import "$samples/drake.sdf" --out /proc/no/such/folder/x.toml
refused 2 'is no scene'"'"'s name' import "$samples/drake.sdf" --out scene.txt
# Of several, none is written where one cannot be.
rm opensim_new-*.toml
echo precious >opensim_new-L2_ground.toml
refused 2 'is there already' import "$samples/opensim_new.osim"
[ ! -e opensim_new-L1_L2.toml ] || fail "one of two was written"
rm opensim_new-L2_ground.toml
if find . -name '*.part' | grep -q .; then fail "a temporary file is left"; fi

# Several bushings.
refused 2 'holds 2 bushings; allowed: --name with it: L1_L2, L2_ground' import "$samples/opensim_new.osim" --out one.toml
imported "$samples/opensim_new.osim" --name L2_ground --out one.toml
grep -q '^stiffness = \[100, 100, 100, 5, 5, 5\]$' one.toml || fail "--name"
refused 2 '--name L9: no bushing of' import "$samples/opensim_new.osim" --name L9

# The law: none in the file, another one asked for, none of that name.
refused 2 'bushing 1 holds no law of rotation, on which the answer depends; allowed: --as NAME' import "$samples/bushing.adm" --out x.toml
grep -qE '^  attached_a +1\.94 +7\.76 +17\.4$' said || { cat said; fail "no table of what the candidates differ by"; }
[ ! -e x.toml ] || fail "a scene without a law was written"
refused 2 "unknown formulation 'invarient' (did you mean 'invariant'?)" import "$samples/bushing.adm" --as invarient
refused 2 "unknown formulation 'intrinsic'" import "$samples/bushing.adm" --as intrinsic
refused 2 '--as invariant: Drake SDF computes drake_rpy' import "$samples/drake.sdf" --as invariant
imported "$samples/bush.bdf" --as invariant --units mm --name 'CBUSH 101' --out mm.toml
grep -q '^stiffness = \[1000000, 2000000, 5000000, 0.02, 0.03, 0.07' mm.toml || fail "--units mm: $(cat mm.toml)"

# Files that are none: binary, long, empty, a folder, missing, unreadable names.
head -c 100000 /dev/urandom >noise
refused 2 'noise:1: the file' import noise
head -c 100000000 /dev/zero | tr '\0' 'x' >long
refused 2 'is too long; allowed: up to 16 MB' import long
rm long
: >empty
refused 2 'empty:1: the file = nothing: is empty' import empty
refused 2 'it is a folder' import .
refused 2 'cannot be read (No such file' import missing.sdf
refused 2 'cannot be read' import "$(printf 'a\nb')"
sed 's/20 30 70/20 -30 70/' "$samples/drake.sdf" >bad.sdf
refused 2 'bad.sdf:22: drake:bushing_torque_stiffness = 20 -30 70: has the negative stiffness -30; allowed: numbers >= 0' import bad.sdf
[ ! -e bad.toml ] || fail "a scene of a bad file was written"
# A stiffness that no joint can have is judged by the scene's own reader.
printf 'joint: 1, deformable hinge, 1, 2, linear elastic generic, sym, 1., 9., 0., 1., 0., 1.;\n' >indefinite.mbd
refused 2 'is indefinite' import indefinite.mbd
# Control characters of a file reach no terminal.
printf '<OpenSimDocument><BushingForce name="a&#27;[31mb"><body_1>x</body_1><body_2>y</body_2><rotational_stiffness>1 1 1</rotational_stiffness></BushingForce></OpenSimDocument>' >escape.osim
imported escape.osim
if grep -q "$(printf '\033')" told escape.toml; then fail "an escape sequence came through"; fi

# The other way, and back: the joint is the same to the last digit.
same() {  # SCENE SCENE
  for scene in "$1" "$2"; do sed -n '/^\[joint\]/,/^# EXAMPLE/p' "$scene" | grep -vE '^#|^  \[|^$|frame_' >"$scene.joint"; done
  cmp -s "$1.joint" "$2.joint" || { diff "$1.joint" "$2.joint"; fail "$1 is not $2"; }
}
"$import" export opensim_old.toml --to osim --out back.osim >said 2>told || { cat told; fail "export to osim"; }
grep -q 'not in it: loads' told || fail "what is left out is not said"
imported back.osim
same opensim_old.toml back.toml
"$import" export mbdyn-11.toml --to mbdyn --out back.mbd >said 2>told || { cat told; fail "export to mbdyn"; }
imported back.mbd --force
same mbdyn-11.toml back.toml
"$import" export straight.toml --to bus --law-only --out back.bus >said 2>told || { cat told; fail "export to bus"; }
grep -q 'not in it: formulation field_a' told || fail "the formulation is lost silently"
imported back.bus --as field_a --force
same straight.toml back.toml
refused 2 'formulation field_a: a .bus file holds no law of rotation' export straight.toml --to bus
refused 2 'offsets and frames: a .bus file has none' export bushing.toml --to bus
refused 2 "OpenSim's BushingForce computes simbody_xyz and nothing else, not drake_rpy" export drake.toml --to osim
refused 2 'MBDyn has no joint of this kind that computes drake_rpy' export drake.toml --to mbdyn
refused 2 'back.bus: is there already' export straight.toml --to bus --law-only --out back.bus
refused 2 "unknown target 'adams'" export straight.toml --to adams
refused 2 '--law-only: osim says the whole joint' export opensim_old.toml --to osim --law-only
refused 2 'no_such' export no_such --to osim
refused 2 'unknown command' convert x

# Output that cannot be written is told.
if [ -e /dev/full ]; then
  status=0
  "$import" import --help >/dev/full 2>told || status=$?
  [ $status -eq 1 ] || fail "--help to a full device ended with $status"
fi
"$import" import --help | grep -q 'drake_rpy' || fail "--help does not say what is read"
"$import" export --help | grep -q 'simbody_xyz' || fail "--help does not say what is written"
echo "imports and exports: all as promised"
