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
# Half of the next request must not keep an answer back.
printf '%s\n%.20s' "$valid" "$valid" >&3
read -r reply <&4 || fail "no answer before the next request is whole"
printf '%s\n' "$valid" | tail -c +21 >&3
read -r rest <&4 || fail "no answer to a request in two pieces"
[ "$rest" = "$reply" ] || fail "a request in two pieces is answered $rest"
exec 3>&-
wait $! || fail "exit code $? after the pipe was closed"

# Many lines at once, and many poses in a line: every one has its answer, in their order.
block=$(printf '%s' "$valid" | sed 's/,"a":.*/,"a":{"x":[0,0,0],"q":[1,0,0,0]},"poses":[{"b":{"x":[0,0,0],"q":[0.8,0.6,0,0]}},{"b":{"x":[0,0,0],"q":[0.6,0.8,0,0]}}]}/')
awk -v line="$valid" -v block="$block" 'BEGIN { for (i = 1; i <= 2000; ++i) { text = i % 2 ? line : block; sub(/"id":1/, "\"id\":" i, text); print text } }' |
  "$program" eval > "$folder/out" || fail "exit code $? after 2000 lines"
awk '!index($0, "{\"id\":" NR ",\"strain\":" (NR % 2 ? "[" : "[[")) { bad = 1 } END { exit bad || NR != 2000 }' "$folder/out" ||
  fail "2000 lines are not answered in their order"

# Shared out among threads, from a file or a pipe, they are the same.
awk -v line="$valid" -v block="$block" 'BEGIN { for (i = 1; i <= 9000; ++i) { text = i % 3 ? line : block; if (i % 7 == 0) text = "no JSON " i; sub(/"id":1/, "\"id\":" i, text); print text } }' > "$folder/in"
"$program" eval --threads 1 < "$folder/in" > "$folder/out" || fail "exit code $? of one thread"
[ "$(wc -l < "$folder/out")" -eq 9000 ] || fail "one thread does not answer 9000 lines"
"$program" eval --threads 4 < "$folder/in" | cmp -s - "$folder/out" || fail "four threads answer otherwise than one"
dd bs=1000 < "$folder/in" 2> "$folder/err" | "$program" eval --threads 3 | cmp -s - "$folder/out" || fail "three threads answer a pipe otherwise than one"
"$program" eval --threads 0 < "$folder/in" > "$folder/out" 2> "$folder/err" && fail "no thread is taken for some"

"$program" eval --help | grep -q '^  poses ' || fail "eval --help does not name poses"

# Bad commands: one line on stderr, exit 2.
for arguments in "" "bend" "run" "run no_such_scene" "run c1 --formulation invarient" "run no_such.toml"; do
  # shellcheck disable=SC2086  # the words are meant to be split
  "$program" $arguments > "$folder/out" 2> "$folder/err"
  code=$?
  [ "$code" -eq 2 ] || fail "'halfway $arguments' exits with $code instead of 2"
  [ "$(wc -l < "$folder/err")" -eq 1 ] || fail "'halfway $arguments' does not complain in one line"
done
"$program" bend 2>&1 | grep -q "unknown command 'bend'" || fail "an unknown command is not named"
"$program" run mount 2>&1 | grep -q "did you mean" && fail "a suggestion for what is like nothing"

# Streams that take nothing: exit 1, whatever was lost; nothing crashes.
printf '%s\n' 'title = "a \u001b[31m b"' '[joint]' 'kind = "angular"' '[joint.law]' 'type = "linear"' 'K = [1, 2, 3]' \
  '[[load]]' 'type = "fixed_moment"' 'value = [0, 0, 1]' '[path]' 'factor_end = 1' > "$folder/scene.toml"
run="run $folder/scene.toml --formulation invariant --format svg --out $folder/results"
for arguments in list --help --version "$run"; do
  # shellcheck disable=SC2086
  "$program" $arguments > /dev/full 2> /dev/null
  [ $? -eq 1 ] || fail "'halfway $arguments' into a full device does not exit with 1"
  # shellcheck disable=SC2086
  "$program" $arguments 2> /dev/null >&-
  [ $? -eq 1 ] || fail "'halfway $arguments' without standard output does not exit with 1"
done
printf '%s\n' "$valid" | "$program" eval > /dev/full 2> /dev/null
[ $? -eq 1 ] || fail "eval into a full device does not exit with 1"
# shellcheck disable=SC2086
"$program" $run > /dev/null 2> /dev/full
[ $? -eq 1 ] || fail "run with a full standard error does not exit with 1"
# shellcheck disable=SC2086
"$program" $run > /dev/null 2>&-
[ $? -eq 1 ] || fail "run without standard error does not exit with 1"

# Control characters of a title reach neither terminal nor drawing.
# shellcheck disable=SC2086
"$program" $run > "$folder/out.txt" 2>&1 || fail "run exits with $?"
escape=$(printf '\033')
grep -q "$escape" "$folder/out.txt" "$folder/results/scene/curve.svg" && fail "a control character came through"
grep -q 'a .u001b' "$folder/out.txt" || fail "a control character is not shown"

# An output folder that is a file: refused before the work, nothing printed.
: > "$folder/file"
"$program" run "$folder/scene.toml" --out "$folder/file" > "$folder/out.txt" 2> /dev/null
[ $? -eq 2 ] || fail "a file for a folder is not refused with 2"
[ -s "$folder/out.txt" ] && fail "work began before its folder was tried"

# A file of dots stays inside the folder of results.
cp "$folder/scene.toml" "$folder/...toml"
"$program" run "$folder/...toml" --formulation invariant --format csv --out "$folder/dots/in" > /dev/null 2>&1 || fail "dots"
[ "$(ls -A "$folder/dots")" = in ] || fail "a file named ...toml writes outside its folder"

# A hinge: solved where no load works on it, refused by name where one does.
sed -e 's/K = .*/K = [0, 2, 3]/' "$folder/scene.toml" > "$folder/hinge.toml"
"$program" run "$folder/hinge.toml" --formulation conformal --out "$folder/results" 2>&1 | grep -q ' converged' || fail "hinge"
sed -e 's/K = .*/K = [1, 2, 0]/' "$folder/scene.toml" > "$folder/free.toml"
"$program" run "$folder/free.toml" --out "$folder/results" 2>&1 | grep -q 'direction without stiffness, free: rotation about joint axis 3' || fail "free hinge"
"$program" run "$folder/hinge.toml" --formulation conformal --out "$folder/results" 2>&1 | grep -q 'note: joint.law leaves free: rotation about joint axis 1' || fail "name of the hinge"

# The same among curves: flat everywhere is free, flat at rest alone is play; a preload works on a hinge as a load does.
curves='type = "per_axis"\naxis = [{ k1 = 0 }, { negative = 1, positive = 2 }, { x = [-1, 0, 1], y = [-3, 0, 4] }]'
sed -e "s/^type = \"linear\"/$curves/" -e '/^K = /d' "$folder/scene.toml" > "$folder/curves.toml"
"$program" run "$folder/curves.toml" --formulation conformal --out "$folder/results" 2>&1 | grep -q ' converged' || fail "hinge among curves"
sed -e 's/k1 = 0/x = [-1, 1], y = [2, 2]/' "$folder/curves.toml" > "$folder/flat.toml"
"$program" run "$folder/flat.toml" --out "$folder/results" 2>&1 | grep -q 'preload works on a direction without stiffness, free: rotation about joint axis 1' || fail "preloaded hinge"
