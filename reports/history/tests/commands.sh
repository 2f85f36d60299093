#!/bin/sh
# The commands as a person or a CI calls them: one message of what is wrong, exit codes, nothing half written.
# Usage: commands.sh PROGRAM
set -u
program=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
fail() { echo "commands: $1" >&2; exit 1; }
cd "$folder" || exit 1  # no repository: a commit has no subject here

mkdir report
cat > report/results.json <<'JSON'
{"schema": "halfway-results", "version": 1, "command": "./halfway report", "timings": [], "curves": [],
 "context": {"machine": "m, 1 cores", "compiler": "c", "flags": "f", "build_type": "Release", "commit": "abc1",
             "date": "2026-01-02T03:04:05Z"},
 "findings": [{"name": "a\u001b[31m", "formulation": "", "value": 2, "unit": "rad", "comparison": "at_most",
               "expected": 0, "low": 0, "high": 1, "verdict": "fail"}]}
JSON
# expect CODE PATTERN ARGUMENTS: exit code, and one line with the pattern on stderr (code 0: on stdout).
expect() {
  code=$1
  pattern=$2
  shift 2
  "$program" "$@" > stdout 2> stderr
  found=$?
  [ "$found" -eq "$code" ] || fail "'$*' exits with $found instead of $code: $(cat stderr)"
  if [ "$code" -eq 0 ]; then stream=stdout; else stream=stderr; fi
  grep -q -- "$pattern" "$stream" || fail "'$*' does not say '$pattern': $(cat $stream)"
  [ "$code" -eq 0 ] || [ "$(wc -l < stderr)" -eq 1 ] || fail "'$*' does not complain in one line"
}

expect 2 'no such file' history list
expect 0 'run 1 is abc1' history add report --title "first one"
expect 0 'run 1 is already abc1' history add report
expect 0 'first one' history list
expect 2 "date '2026-02-30'; allowed: UTC such as" history add report --date 2026-02-30
expect 0 'is abc1, 2025-01-02T00:00:00Z' history add report --date 2025-01-02T00:00:00Z --file earlier.sqlite
expect 0 'limit 1, fail' history show abc
expect 0 'limit 1, fail' history show 1 --figure '^a'
grep -q "$(printf '\033')" stdout && fail "a control character came through"
expect 2 "no run 'xyz'" history show xyz
expect 2 'no figure of this run matches' history show --figure nothing
expect 2 'is not a regular expression' history show --figure '('
expect 2 "unknown command 'bend'; allowed: history, dashboard" bend
expect 2 "unknown command 'bend'; allowed: add, list" history bend
expect 2 'no/such/results.json: cannot read' history add no/such
expect 2 'what to keep' history prune
expect 0 'kB, before' history prune --keep 5
expect 2 'x not in' history export --format x
expect 2 'jsonl has every figure' history export --figure a
expect 0 '"abc1"' history export
cp stdout lines
expect 0 '1 runs, 1 of them new' history import lines --file second.sqlite
expect 2 'none.jsonl: cannot read' history import none.jsonl --file third.sqlite
[ ! -e third.sqlite ] || fail "a history is begun without anything to keep"
: > a_file
expect 2 'cannot be a folder' history add report --file a_file/history.sqlite

printf '<p>\n<!-- halfway data -->\n</p>\n' > page.html
HALFWAY_DASHBOARD=page.html
export HALFWAY_DASHBOARD
expect 0 'wrote out/dashboard.html' dashboard
grep -q 'id="f0"' out/dashboard.html || fail "the page has no data"
expect 1 'cannot' dashboard --out a_file/page.html
HALFWAY_DASHBOARD=a_file expect 2 'must hold' dashboard --out other.html
[ ! -e other.html ] || fail "a page without its template"

for arguments in "history list" "history export" "history show" --help; do
  # shellcheck disable=SC2086  # the words are meant to be split
  "$program" $arguments > /dev/full 2> /dev/null
  [ $? -eq 1 ] || fail "'$arguments' into a full device does not exit with 1"
done
[ ! -e out/history.sqlite-wal ] || fail "something is left beside the file"
echo "commands: all as expected"
