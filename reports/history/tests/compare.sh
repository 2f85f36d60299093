#!/bin/sh
# Runs of a history compared: its SQLite file, its exported text, and reports; each thing that got worse is named.
# Usage: compare.sh HISTORY_PROGRAM GATE_PROGRAM
set -u
history=$1
gate=$2
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "compare: $1" >&2; cat said err >&2; exit 1; }

# report NAME COMMIT COMPILER VALUE STEPS VERDICT: one finding with the limit 1e-12, one path.
report() {
  mkdir -p "$1"
  cat > "$1/results.json" <<JSON
{"schema": "halfway-results", "version": 1, "command": "./halfway report", "timings": [],
 "context": {"machine": "m, 1 cores", "compiler": "$3", "flags": "f", "build_type": "Release", "commit": "$2",
             "date": "2026-01-0${2#abc}T03:04:05Z"},
 "curves": [{"scene": "s", "formulation": "f", "xi": 0.5, "iterations": $5}],
 "findings": [{"name": "error", "formulation": "", "value": $4, "unit": "rad", "comparison": "at_most",
               "expected": 0, "low": 0, "high": 1e-12, "verdict": "$6"}]}
JSON
}
# expect CODE PATTERN BEFORE AFTER: exit code, and the pattern in what is said.
expect() {
  code=$1
  pattern=$2
  shift 2
  env -u GITHUB_ACTIONS -u GITLAB_CI -u TF_BUILD "$gate" compare --all "$@" > said 2> err
  found=$?
  [ "$found" -eq "$code" ] || fail "'$*' exits with $found instead of $code"
  cat said err | grep -q -- "$pattern" || fail "'$*' does not say '$pattern'"
  [ "$code" -ne 2 ] || [ "$(wc -l < err)" -eq 1 ] || fail "'$*' does not complain in one line"
}

report one abc1 g++ 1e-14 20 pass
report two abc2 clang++ 1e-14 30 pass
report three abc3 g++ 2e-14 20 pass
for name in three one two; do
  "$history" history add "$name" --file kept.sqlite > said 2> err || fail "cannot add $name"
done
"$history" history export --file kept.sqlite --out kept.jsonl > said 2> err || fail "cannot export"

for kept in kept.sqlite kept.jsonl; do
  expect 0 "changed error: 1e-14 -> 2e-14" "$kept@abc1" "$kept@abc3"
  expect 0 "three (abc3) against $kept@abc1" "$kept@abc1" three
  expect 0 "2 figures compared: 0 worse, 0 better, 0 changed" "$kept" three  # the last one by g++
  expect 0 "against $kept@abc2 (abc2)" "$kept" two                           # the last one by clang++
  expect 0 "against $kept@abc3 (abc3)" --newest "$kept" two                  # of the last commit, not made alike
  expect 2 "no run 'abc9'" "$kept@abc9" three
  report worse abc4 g++ 5e-13 20 pass
  expect 1 'REGRESSION error: 2e-14 -> 5e-13, 1.4 digits lost' "$kept" worse
  report worse abc4 g++ 2e-14 21 pass
  expect 1 'REGRESSION s/f/iterations: 20 -> 21' "$kept" worse
  report worse abc4 icpc 2e-14 99 pass  # a compiler of which nothing is kept
  expect 0 'verdicts and limits alone' "$kept" worse
  report worse abc4 icpc 2e-11 20 fail
  expect 1 'REGRESSION error: pass -> fail' "$kept" worse
done
expect 0 "against kept.sqlite@abc3" kept.sqlite@1 three # numbers are those of the file: the third was added first
expect 2 'cannot read' nowhere.jsonl@abc1 three
expect 2 ' nowhere/results.json: cannot read' nowhere three
mkdir empty
expect 2 ' empty/results.json: cannot read' empty three

# The text is append-only, and is what list, show and dashboard read too.
cp kept.jsonl before.jsonl
report four abc5 g++ 1e-14 20 pass
"$history" history add four --file kept.sqlite > said 2> err || fail "cannot add four"
"$history" history export --file kept.sqlite --out kept.jsonl > said 2> err || fail "cannot export"
head -c "$(wc -c < before.jsonl)" kept.jsonl | cmp -s - before.jsonl || fail "a later run changes the lines of earlier ones"
"$history" history list --file kept.jsonl > said 2> err || fail "list does not read the text"
[ "$(grep -c abc said)" -eq 4 ] || fail "not every run is listed"
"$history" history import kept.jsonl --file again.sqlite > said 2> err || fail "cannot import"
"$history" history export --file again.sqlite | cmp -s - kept.jsonl || fail "another text comes back"
"$history" history export --file kept.jsonl | cmp -s - kept.jsonl || fail "the text read as a file is another"
"$history" history add four --file kept.jsonl > said 2> err && fail "a run is added to a text"
# Two texts, one after the other, are the runs of both.
cat before.jsonl kept.jsonl > both.jsonl
"$history" history import both.jsonl --file both.sqlite > said 2> err || fail "cannot import two texts"
grep -q '7 runs, 4 of them new' said || fail "other runs came from two texts"
"$history" history list --file both.jsonl > said 2> err && fail "runs out of order are listed"
grep -q 'both.jsonl:6: date 2026-01-01' err || fail "the run out of order is not named"

# Without the program of the history its file is refused by name, its text is read.
mkdir alone
cp "$gate" alone/halfway-gate
gate=alone/halfway-gate
expect 0 'REGRESSION\|0 worse' kept.jsonl three
expect 2 'halfway-history is not there to read it' kept.sqlite three
echo "compare: all as expected"
