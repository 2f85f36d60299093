#!/bin/sh
# Scenes as people brought them, through the real program: what `halfway run` prints, writes and returns.
# Usage: run.sh PROGRAM PROGRAM_OF_CHAINS
set -u
program=$1
field=$(dirname "$0")/field
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
fail() { echo "run: $1" >&2; exit 1; }

# holds FILE FORMULATION COLUMN VALUE TOLERANCE: the last row of that formulation, relative.
holds() {
  awk -F, -v formulation="$2" -v column="$3" -v value="$4" -v tolerance="$5" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == column) at = i }
    $1 == formulation && at { found = $at; seen = 1 }
    END { off = found / value - 1; exit !(seen && off <= tolerance && -off <= tolerance) }' "$1" ||
    fail "$2 in ${1#"$folder/"}: $3 is not $4 to $5"
}

run() { "$program" run "$@" --out "$folder" --format csv > "$folder/out" 2> "$folder/err"; }

# A soft hinge in a rigid bushing on a lever: the root of ks t = M + l (Fz cos t - Fy sin t), to 12 digits given.
run "$field/hinge_1.toml" || fail "hinge_1 exits with $?"
holds "$folder/hinge_1/curve.csv" attached_a theta_x 0.00498998272615 1e-11
holds "$folder/hinge_1/curve.csv" conformal theta_x 0.00498997239284 1e-11
holds "$folder/hinge_1/curve.csv" jointc theta_x 0.00499006539675 1e-11
run "$field/hinge_2.toml" || fail "hinge_2 exits with $?"
holds "$folder/hinge_2/curve.csv" invariant theta_x 0.04898471217198 1e-12

# Frames on both nodes, and on one, change nothing about joint axis 1 from the unstrained pose: values of C3.
for scene in critical_frames_ab critical_frame_a; do
  run "$field/$scene.toml" || fail "$scene exits with $?"
  holds "$folder/$scene/critical.csv" invariant critical_moment 830.455515962076 1e-12
  holds "$folder/$scene/critical.csv" conformal critical_moment 963.8281044582 1e-12
  holds "$folder/$scene/critical.csv" jointc critical_moment 265.1111992618 1e-12
  holds "$folder/$scene/critical.csv" attached_b critical_moment 415.227757981038 1e-12
  grep -q '^invariant .* 830.455516 ' "$folder/out" || fail "$scene: the critical moment is not printed"
done

# By arc length in turned axes: the branching is named although rounding has made it imperfect.
sed -e 's/factor_end = 200/factor_end = 1000/' -e '/^critical_axis/d' -e '/^\[\[reference/,$d' \
  "$field/critical_frames_ab.toml" > "$folder/arc.toml"
run "$folder/arc.toml" --arc --formulation invariant,jointc || fail "arc exits with $?"
grep -q '^invariant.*branching at load factor 830.455516' "$folder/out" || fail "arc: no branching of invariant"
grep -q '^jointc.*branching at load factor 265.1111993' "$folder/out" || fail "arc: no branching of jointc"
awk -F, 'NR > 2 && !($7 > 0 && $7 < 1e-9) && $1 == "invariant" { bad = 1 } END { exit bad }' "$folder/arc/curve.csv" ||
  fail "arc: a point without the error that it carries"

# A law whose soft direction the rounding of its own entries leaves to four digits: said, and no success.
printf '%s\n' 'title = "beyond"' '[joint]' 'kind = "angular"' '[joint.law]' 'type = "linear"' \
  'K = [[640000000000.36, -479999999999.52, 0], [-479999999999.52, 360000000000.64, 0], [0, 0, 1e12]]' '[[load]]' \
  'type = "fixed_moment"' 'value = [0.02, 0, 0]' '[path]' 'factor_end = 1' > "$folder/beyond.toml"
run "$folder/beyond.toml" --formulation invariant,linearized
code=$?
[ "$code" -eq 1 ] || fail "a scene beyond double precision exits with $code"
grep -q 'accurate to .* rad only, beyond double precision' "$folder/out" || fail "it is not said how accurate"

# The linear analysis alone reaches every load: that is no success of a path.
printf '%s\n' 'title = "too much"' 'formulations = ["jointc", "linearized"]' '[joint]' 'kind = "angular"' '[joint.law]' \
  'type = "linear"' 'K = [100, 200, 300]' '[[load]]' 'type = "fixed_moment"' 'value = [3e4, 1e4, 2e4]' '[path]' \
  'factor_end = 1' > "$folder/fold.toml"
run "$folder/fold.toml" && fail "nothing but the linear analysis arrives, and the exit code is 0"
grep -q 'fold\|half a turn\|pole' "$folder/out" || fail "no cause is named"

# The slender rod beside the joints of C3: a kept value of 80-bit Taylor series.
run c3_buckling --formulation invariant --rod || fail "c3_buckling --rod exits with $?"
holds "$folder/c3_buckling/curve.csv" rod theta_z 2.62995874622906 1e-12
run c6_compression_shear --rod && fail "a rod was drawn beside forces"
grep -q -- '--rod' "$folder/err" || fail "the refusal does not name --rod"

# No load at all: nothing moves, and that is an answer.
run "$field/no_load.toml" || fail "no_load exits with $?"
awk -F, 'NR > 1 && ($4 != 0 || $5 != 0 || $6 != 0) { bad = 1 } END { exit bad || NR < 100 }' "$folder/no_load/curve.csv" ||
  fail "something moves without a load"

# More than a turn: each law says why it stops, or goes on.
run "$field/full_turn.toml" || fail "full_turn exits with $?"
grep -q '^invariant.*phi reaches pi' "$folder/out" || fail "full_turn: invariant does not name half a turn"
grep -q '^quaternion.*a fold' "$folder/out" || fail "full_turn: quaternion does not name its fold"
grep -q '^conformal .*  converged$' "$folder/out" || fail "full_turn: conformal stops"

# Two joints in parallel, as somebody wrote them; a linkage that a load would move: named, and no success.
run "$field/two_joints.toml" || fail "two_joints exits with $?"
holds "$folder/two_joints/curve.csv" invariant theta_y 0.025 1e-14
run four_bar || fail "four_bar exits with $?"
holds "$folder/four_bar/curve.csv" invariant rocker.theta_z 0.67513153293703165 1e-12
"$program" run four_bar --out "$folder" > "$folder/out" 2>&1 || fail "four_bar in all formats exits with $?"
for file in curve.csv curve.json curve.svg; do [ -s "$folder/four_bar/$file" ] || fail "a mechanism: no $file"; done
grep -q '>rocker.theta_z (rad)<' "$folder/four_bar/curve.svg" || fail "an axis of a mechanism's chart has no unit"
sed -e 's/^\[\[motion\]\]/[[load]]/' -e 's/^name = "drive"//' -e 's/^type = "rotation"/type = "fixed_force"/' \
  -e 's/^axis = "z"//' -e 's/^value = 1.57.*/value = [1, 0, 0]\npoint = [0, 1, 0]/' -e 's/, "drive.m_z"//' \
  -e '/^\[\[reference/,$d' "$field/../../../reference/scenes/mechanisms/four_bar.toml" > "$folder/loose.toml"
run "$folder/loose.toml" --formulation invariant && fail "a linkage that a load moves arrives"
grep -q 'a load works on a direction without stiffness, .* of body' "$folder/out" || fail "loose: no direction is named"
run four_bar --arc && fail "--arc of a mechanism is not refused"
grep -q -- '--arc' "$folder/err" || fail "the refusal of a mechanism does not name --arc"

# A motion: a mass on a spring and a damper, in closed form; who makes energy; what a motion cannot say, by name.
run damped_oscillator --formulation invariant,fasse || fail "damped_oscillator exits with $?"
holds "$folder/damped_oscillator/curve.csv" invariant v_x 0.0050037381384377078986 1e-9
grep -q '^formulation,xi,time,u_x,' "$folder/damped_oscillator/curve.csv" || fail "the column of a motion is not the time"
grep -q 'dampers take 0.009975 J' "$folder/out" || fail "it is not said what the dampers take"
run free_pair || fail "free_pair exits with $?"
grep -q 'dampers take 3.998 to 5.582 J; off by [5-9]e-10 at most where joints have a potential' "$folder/out" || fail "README's words of free_pair"
grep -q 'makes or loses 2.7e-01 mbdyn_joint_inv; 7.4e-02 attached_b; 6.7e-02 chrono_body;' "$folder/out" || fail "README's words of free_pair"
"$program" run free_pair --formulation potential,attached_b --out "$folder" > "$folder/out" 2>&1 || fail "free_pair exits with $?"
grep -q '^  without a potential the law itself makes or loses .*attached_b$' "$folder/out" || fail "nobody makes energy"
grep -q '^Time 3 s: reached by 2 of 2' "$folder/out" || fail "the summary of a motion does not say the time"
grep -q '"over":"time"' "$folder/free_pair/index.html" || fail "the page of a motion is of a load factor"
grep -q 'time (s)' "$folder/free_pair/curve.svg" || fail "the chart of a motion is of a load factor"
run damped_oscillator --arc && fail "--arc of a motion is not refused"

# By arc length to a corner of a curve: that is the cause, and load steps go on.
printf '%s\n' 'title = "corner"' '[joint]' 'kind = "angular"' '[joint.law]' 'type = "per_axis"' '[[joint.law.axis]]' 'k1 = 10' \
  '[[joint.law.axis]]' 'k1 = 12' '[[joint.law.axis]]' 'x = [-1, -0.1, 0, 0.1, 1]' 'y = [-9, -0.1, 0, 0.1, 9]' '[[load]]' \
  'type = "fixed_moment"' 'value = [1, 0.5, 2]' '[path]' 'factor_end = 1' > "$folder/corner.toml"
run "$folder/corner.toml" --formulation invariant,conformal --arc && fail "--arc goes through a corner"
grep -q 'the curve of the rotation about joint axis 3 has a corner at 0.1' "$folder/out" || fail "the corner is not named"
run "$folder/corner.toml" --formulation invariant,conformal || fail "load steps end at a corner with $?"

# A preload on a curve that is flat at rest: it is said what leads there.
printf '%s\n' 'title = "play"' '[joint]' 'kind = "angular"' '[joint.law]' 'type = "polynomial"' 'preload = [0, 0, 1]' \
  'k1 = [1, 1, 0]' 'k3 = [0, 0, 1]' '[[load]]' 'type = "fixed_moment"' 'value = [1, 0, 0]' '[path]' 'factor_end = 1' > "$folder/play.toml"
run "$folder/play.toml" && fail "a preload on a curve without slope is solved"
grep -q 'rotation about joint axis 3, whose curve is flat at rest' "$folder/err" || fail "play is not named"

# The run ends with who agrees, and why paths end: causes in words, the same for those that share one.
says() { grep -q -- "$1" "$folder/out" || fail "the summary does not say: $1"; }
run c3_buckling || fail "c3_buckling exits with $?"
says '^Load factor 1800: reached by 14 of 18 formulations; 9 answers more than 1 % apart'
says '^ *2\.868  *0  *0\.0072111 .* attached_a, mbdyn_joint_inv, linearized$'
says '^ *1\.3648 .* invariant, exudyn_intrinsic$'
says '^  jointc ends at 258\.701: a fold'
says '^  field_a ends at 985\.845, field_b ends at 1016\.15: .*gimbal lock$'
says '^  rod4 ends at 180: rotation of .* rad is beyond .* convex'
says '^  critical moment about joint axis 1, N m: 265\.11 jointc; 415\.23 attached_b, chrono_body;'
says '^  left out: intrinsic needs a value'
sed -n '/^Load factor/,$p' "$folder/out" | grep -qi 'iteration' && fail "the summary counts iterations"
run c1_skewed_torque --formulation attached_a,mbdyn_joint_inv || fail "two equal ones exit with $?"
says 'reached by 2 of 2 formulations, which agree to 1 % of the answer'
printf '%s\n' 'title = "hard"' '[joint]' 'kind = "linear"' '[joint.law]' 'type = "polynomial"' 'k1 = [1000, 2000, 3000]' \
  'k3 = [1e6, 0, 0]' 'k5 = [0, 0, 0]' '[[load]]' 'type = "fixed_force"' 'value = [120, 0, 9]' '[path]' 'factor_end = 1' > "$folder/hard.toml"
run "$folder/hard.toml" || fail "a law that grows stiffer exits with $?"
says '^Load factor 1: reached by 18 of 18 formulations, which agree to 1 % of the answer$'
says ' linearized$'  # far off, in a line of its own, and no formulation
printf '%s\n' 'title = "hinge"' '[joint]' 'kind = "angular"' '[joint.law]' 'type = "linear"' 'stiffness = [0, 10, 20]' '[[load]]' \
  'type = "fixed_moment"' 'value = [0, 5, 3]' '[path]' 'factor_end = 1' > "$folder/hinge.toml"
run "$folder/hinge.toml" --formulation attached_a,invariant || fail "a hinge exits with $?"
says '^  invariant ends at 1: a free direction'
sed -e 's/\[0, 10, 20\]/[100, 100, 100]/' -e 's/\[0, 5, 3\]/[400, 0, 0]/' "$folder/hinge.toml" > "$folder/half.toml"
run "$folder/half.toml" --formulation attached_a,invariant && fail "nobody arrives, and the exit code is 0"
says '^  attached_a ends at 0.785398, invariant ends at 0.785398: half a turn'

# The page: by default, left out on request, whole; what a file says cannot end the element that holds the data.
[ -e "$folder/c3_buckling/index.html" ] && fail "a page was written that nobody asked for"
"$program" run "$field/turned_offsets.toml" --out "$folder" > "$folder/out" 2>&1 || fail "turned_offsets exits with $?"
grep -q "^wrote $folder/turned_offsets/index.html$" "$folder/out" || fail "it is not said that a page was written"
page=$folder/turned_offsets/index.html
[ "$(grep -o '</script>' "$page" | wc -l)" -eq 2 ] || fail "the page does not have two script elements"
grep -q 'u003c/script>\\u003cscript>alert(2)' "$page" || fail "the scene's description is not in the page"
grep -q '@[A-Z_]*@' "$page" && fail "the page has a mark without its text"
"$program" run "$field/turned_offsets.toml" --format png > "$folder/out" 2> "$folder/err" && fail "a format png was not refused"
grep -q 'allowed: csv, json, svg, html' "$folder/err" || fail "the formats that are allowed are not named"

# A chain: written and drawn whole, the tip where a regular polygon closes; what it cannot do is refused by name.
printf '%s\n' 'title = "roll"' '[chain]' 'links = 20' 'length = 1' 'GJ = 1' 'EI = 1' 'EA = 1e4' 'GA = 1e4' '[[load]]' \
  'type = "follower_moment"' 'value = [0, 0, 6.283185307179586]' > "$folder/roll.toml"
run "$folder/roll.toml" && fail "the program without batches solves a chain"
grep -q 'is a chain' "$folder/err" || fail "the refusal of a chain does not say what solves it"
program=$2
"$program" run "$folder/roll.toml" --formulation invariant --out "$folder" > "$folder/out" 2> "$folder/err" ||
  fail "a chain exits with $?"
for file in curve.csv shape.csv curve.json curve.svg shape.svg index.html; do
  [ -s "$folder/roll/$file" ] || fail "a chain: no $file"
done
awk -F, 'END { r = $5 * $5 + $6 * $6 + $7 * $7; exit !(NR == 43 && r < 1e-24 && $10 > 6.2831853 && $10 < 6.2831854) }' \
  "$folder/roll/shape.csv" || fail "the last node of the chain is not back at the root, a whole turn on"
run "$folder/roll.toml" --formulation linearized && fail "the linear analysis of a chain was not refused"
grep -q 'linearized cannot run scene roll' "$folder/err" || fail "the refusal does not name the linear analysis"

# Interrupted: nothing half written is left.
sed 's/links = 20/links = 1000000/' "$folder/roll.toml" > "$folder/long.toml"
"$program" run "$folder/long.toml" --out "$folder" > "$folder/out" 2> "$folder/err" &
sleep 1
kill -INT $!
wait $! && fail "an interrupted chain exits with 0"
grep -q 'interrupted' "$folder/err" || fail "it is not said that the chain was interrupted"
find "$folder/long" -name '*.part' | grep -q . && fail "an interrupted chain leaves half a file"
exit 0
