#!/bin/sh
# Pipes requests through the real program: one answer a line, flushed at once, exit 0 at the end.
# Usage: pipe.sh PROGRAM
set -u
program=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
fail() { echo "pipe: $1" >&2; exit 1; }

valid='{"id":1,"formulation":"invariant","kind":"angular","law":{"type":"linear","K":[[1,0,0],[0,2,0],[0,0,3]]},"a":{"x":[0,0,0],"q":[1,0,0,0]},"b":{"x":[0,0,0],"q":[0.8,0.6,0,0]}}'

# Good, bad, empty, too long (17 MiB), good without a line end.
{
  printf '%s\n' "$valid" 'not JSON' ''
  head -c 17825792 /dev/zero | tr '\0' ' '
  printf '\n%s' "$valid"
} > "$folder/in"
"$program" eval < "$folder/in" > "$folder/out" || fail "exit code $? at the end of input"
lines=$(wc -l < "$folder/out")
[ "$lines" -eq 5 ] || fail "5 lines in, $lines lines out"
sed -n 1p "$folder/out" | grep -q '^{"id":1,"strain":\[.*\],"loads":\[.*\]}$' || fail "line 1 has no answer"
sed -n 2p "$folder/out" | grep -q '"malformed_json"' || fail "line 2 is not refused"
sed -n 3p "$folder/out" | grep -q '"empty_line"' || fail "line 3 is not refused"
sed -n 4p "$folder/out" | grep -q '"line_too_long"' || fail "line 4 is not refused"
[ "$(sed -n 1p "$folder/out")" = "$(sed -n 5p "$folder/out")" ] || fail "line 5 differs from line 1"

"$program" eval < /dev/null > "$folder/out" || fail "exit code $? without input"
[ -s "$folder/out" ] && fail "an answer without a request"

# An answer must come while the input is still open: otherwise this waits until ctest's timeout.
mkfifo "$folder/to" "$folder/from" || fail "cannot make a pipe"
"$program" eval < "$folder/to" > "$folder/from" &
exec 3> "$folder/to" 4< "$folder/from"
for i in 1 2; do
  printf '%s\n' "$valid" >&3
  read -r reply <&4 || fail "no answer to request $i"
  case $reply in '{"id":1,"strain"'*) ;; *) fail "answer $i is $reply" ;; esac
done
exec 3>&-
wait $! || fail "exit code $? after the pipe was closed"

# Bad commands: one line on stderr, exit 2.
for arguments in "" "bend" "run" "run no_such_scene" "run c1 --formulation invarient" "run no_such.toml"; do
  # shellcheck disable=SC2086  # the words are meant to be split
  "$program" $arguments > "$folder/out" 2> "$folder/err"
  code=$?
  [ "$code" -eq 2 ] || fail "'halfway $arguments' exits with $code instead of 2"
  [ "$(wc -l < "$folder/err")" -eq 1 ] || fail "'halfway $arguments' does not complain in one line"
done
