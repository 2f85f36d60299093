#!/bin/sh
# The command itself: files in and out, refusals, exit codes.  commands.sh HALFWAY_CHECK XSD_FOLDER SCHEMA HALFWAY
set -eu
check=$1 xsd=$2 schema=$3 halfway=$4
ask() { "$check" check "$@"; }
# shellcheck source=reports/tests/commands.sh
. "$(dirname "$0")/../../tests/commands.sh"

# A healthy joint.
"$check" check --command "'$check' subject conformal" --junit j.xml --markdown m.md --badge b.json --ctest >said 2>told || fail "conformal fails: $(cat said)"
grep -q '^your joint is conformal (' said || fail "conformal is not told"
grep -q 'CTestMeasurement type="numeric/double" name="failed">0<' said || fail "no measurements"
grep -q '"message": "conformal, ' b.json || fail "badge"
grep -q '^| ok | ' m.md || fail "markdown"
if command -v xmllint >/dev/null; then xmllint --noout --schema "$xsd/junit-10.xsd" j.xml 2>/dev/null || fail "junit.xml"; fi

# Our own eval says hello, and its tangent is looked at.
"$check" check --command "'$halfway' eval" --fields '{"formulation": "helicoidal"}' >said 2>told || fail "eval fails: $(cat said)"
grep -q '^your joint is helicoidal (' said || fail "eval is not told"
grep -q '^  ok  *level3/tangent' said || fail "no tangent: $(cat said)"

# Twenty lines of Python that take no ends and one stiffness each.
adapter=$(dirname "$schema")/../../formulations/examples/check/adapter.py
if command -v python3 >/dev/null; then
  "$check" check --command "python3 '$adapter'" >said 2>told || fail "the adapter fails: $(cat said)"
  grep -q '^your joint is attached_a (' said || fail "the adapter is not told: $(cat said)"
  grep -q '^  left out *level2/ends' said || fail "ends were asked of the adapter"
fi

# Defects: exit code 1, a file each, a page for the maintainer; expected ones are none.
refused 1 'FAIL' --command "'$check' subject bullet_6dof" --out failures
for name in level3.moment_balance level3.body_order level3.loop_one; do
  [ -s "failures/$name.md" ] || fail "no failures/$name.md"
done
grep -q 'Cause: Each body gets the force at its own anchor' failures/level3.moment_balance.md || fail "no cause"
grep -q '"repeat"' failures/level3.moment_balance.json || fail "no command to repeat"
printf 'level3/*  # known\nlevel2/tensoriality\nlevel4/range\n' >known
"$check" check --command "'$check' subject bullet_6dof" --expected known >said 2>told || { cat said; fail "expected failures fail"; }
printf 'level3/objectivity\n' >known
refused 1 'UNEXPECTED PASS' --command "'$check' subject conformal" --expected known

# Answers from a file are those of the program.
"$check" check --questions questions.jsonl >/dev/null
"$check" subject jolt_6dof <questions.jsonl >answers.jsonl
refused 1 'your joint is jolt_6dof' --answers answers.jsonl
grep -q 'FAIL             level3/body_order' said || fail "answers: order"

# Vectors for the tests of others: every line by its schema, the same numbers in both forms.
"$check" check --questions vectors.jsonl --joint invariant >/dev/null
"$check" check --questions vectors.csv --joint invariant >/dev/null
[ "$(wc -l <vectors.csv)" -eq $(($(wc -l <vectors.jsonl) + 1)) ] || fail "rows of the table"
if /usr/bin/python3 -c 'import jsonschema' 2>/dev/null; then
  /usr/bin/python3 - "$schema" vectors.jsonl <<'PY' || fail "vectors are not by their schema"
import json, jsonschema, sys
schema = json.load(open(sys.argv[1]))
for line in open(sys.argv[2]):
    jsonschema.validate(json.loads(line), schema)
PY
fi

# Bad input, in words.
refused 2 'no joint is called' --questions v.jsonl --joint nobody
refused 2 '--command' --questions ''
refused 2 'quote' --command "'open"
refused 2 'is no JSON object' --command "'$check' subject conformal" --fields '[1]'
refused 2 'is no id of a check' --command "'$check' subject conformal" --expected said
printf '{"id":"level1/identity/001"}\nnot json\n' >bad.jsonl
refused 2 'bad.jsonl, line 2' --answers bad.jsonl
refused 2 'no-such-program' --command ./no-such-program
refused 1 'LOST' --command 'false' --timeout 1
echo "all done"
