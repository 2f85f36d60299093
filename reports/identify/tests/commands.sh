#!/bin/sh
# The command itself: files in and out, refusals, exit codes, written scenes solved.
#   commands.sh HALFWAY_IDENTIFY HALFWAY SAMPLES
set -eu
identify=$1 halfway=$2 samples=$3
ask() { "$identify" identify "$@"; }
reports=$(cd "$(dirname "$0")/../.." && pwd)
# shellcheck source=reports/tests/commands.sh
. "$(dirname "$0")/../../tests/commands.sh"

# Every sample becomes a scene that is solved.
for sample in "$samples"/*.csv; do
  name=$(basename "$sample" .csv)
  "$identify" identify "$sample" >said 2>told || { cat told; fail "$name"; }
  grep -q '^  stiffness about axes' said || fail "$name: no stiffness in the summary"
  [ "$(wc -l <said)" -le 16 ] || fail "$name: a summary of $(wc -l <said) lines"
  tail -n 1 said | grep -qE "^wrote $name.toml \([a-z0-9_]+\) and out/identify/$name/index.html\$" || fail "$name: $(tail -n 1 said)"
  "$halfway" run "$name.toml" --format csv --out run >ran 2>&1 || { cat ran; fail "$name.toml is not solved"; }
  grep -qE '^\[1/1\] [a-z0-9_= .]+: converged$' ran || { cat ran; fail "$name.toml: not one law, or not solved"; }
done

# The scene of the tapered rod turns as the curve does at its largest load, the last of the case about axes 2 and 3.
expected=$(awk '/^#/ {is_it = /about 2 and 3/} is_it && /^-?[0-9]/ {last = $0} END {print last}' "$samples/tapered_rod.csv")
ends=$(tail -n 1 run/tapered_rod/curve.csv)
awk -v a="$expected" -v b="$ends" 'BEGIN {split(a, x, ","); split(b, y, ","); for (i = 0; i < 3; ++i) {d = x[4 + i] - y[4 + i]; if (d < 0) d = -d; if (!(d < 1e-4)) exit 1}}' ||
  fail "the scene ends at $ends, the curve at $expected"

# For programs: JSON on standard output, and nothing else.
"$identify" identify "$samples/frustum.csv" --json --out f.toml >f.json 2>told || fail "--json"
grep -q '"schema": "halfway-identify-1"' f.json || fail "no schema"
[ "$(head -c 1 f.json)" = '{' ] && [ "$(tail -c 2 f.json)" = '}' ] || fail "--json prints more than JSON"
[ ! -s told ] || fail "--json says on stderr: $(cat told)"

"$identify" identify "$samples/../../../reference/data/fe/linear_frustum_top.json" --law neo_hooke --out fe.toml >said 2>told || { cat told; fail "a result of finite elements"; }
grep -q '^  xi of moments         2-3: 0\.44[78]' said || { cat said; fail "xi of the frustum"; }

# What a person may get wrong.
refused_in_one_line 2 'no.csv: cannot be read' no.csv
refused_in_one_line 2 'it is a folder' .
refused_in_one_line 2 'is there already; allowed: --force' "$samples/frustum.csv"
refused_in_one_line 2 "is no scene's name" "$samples/frustum.csv" --out scene.txt
refused_in_one_line 1 'cannot' "$samples/frustum.csv" --out /proc/no/such/folder/x.toml
printf 'm_x [N],theta_x [rad]\n1,1\n' >unit.csv
refused_in_one_line 2 'unit.csv:1: m_x [N]: is in N, which is no N m' unit.csv
printf 'm_x [N m],theta_x [rad]\n1,0.1\n' >few.csv
refused_in_one_line 2 'few.csv: 1 measured numbers for 1 unknowns' few.csv
head -c 3000 "$identify" >program.csv
refused_in_one_line 2 'program.csv:1: ' program.csv
[ ! -e few.toml ] && [ ! -e unit.toml ] || fail "a refused file left a scene"
if find . -name '*.part' | grep -q .; then fail "a temporary file is left"; fi

# One case about one axis is no mistake: what it tells, and what not.
printf 'm_x [N m],theta_x [deg]\n1,5.73\n2,11.45\n3,17.2\n4,22.91\n' >one.csv
"$identify" identify one.csv >said 2>told || { cat told; fail "one.csv"; }
grep -q 'not identified .*stiffness about axis 2.*no case turns the joint about it' said || { cat said; fail "one.csv does not say what is open"; }
grep -q '^# NOT IDENTIFIED, assumed below: stiffness about axis 2' one.toml || fail "one.toml does not mark what is assumed"
"$halfway" run one.toml --format csv --out run >ran 2>&1 || { cat ran; fail "one.toml is not solved"; }

# The page opens offline, and has the residuals and no mark of its template left.
page=out/identify/frustum/index.html
grep -q '<circle' "$page" || fail "the page has no residuals"
grep -qF 'xi of moments' "$page" || fail "the page does not say xi"
if grep -qE '@[A-Z]+@|src="|href="http|<script' "$page"; then fail "the page is not whole: $(grep -noE '@[A-Z]+@|src="|href="http|<script' "$page" | head -n 3)"; fi

# By its schema: every sample, a joint that does not turn, one case alone, curved laws; and spoilt ones are not.
printf 'f_x [N],f_y [N],u_x [mm],u_y [mm]\n-20,-1,-2.01,-0.2\n-10,-3,-0.99,-0.59\n10,1,1.02,0.21\n20,3,1.98,0.6\n30,9,3.01,1.79\n' >moved.csv
awk 'BEGIN {print "m_x [N m],theta_x [rad]"; for (i = -8; i <= 8; ++i) if (i) {x = i / 40; printf "%.6f,%.6f\n", 10 * x + 400 * x * x * x + 0.0005 * (i % 3), x}}' >curved.csv
for data in "$samples"/*.csv one.csv moved.csv curved.csv; do
  name=$(basename "$data" .csv)
  "$identify" identify "$data" --json --force --out "$name.toml" >"$name.json" 2>told || { cat told; fail "--json of $name"; }
done
grep -q '"k3_about"' curved.json || fail "curved.csv has no curved law"
/usr/bin/python3 "$reports/tests/documents.py" "$reports/identify.schema.json" frustum.json block.json tapered_rod.json one.json moved.json curved.json ||
  fail "documents are not by their schema"
