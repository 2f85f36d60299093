#!/bin/sh
# Four writers at once, each killed now and then in the middle: no run that was told to be kept is lost, none is
# half there, and the file stays sound.
# Usage: kill.sh PROGRAM [KILLS]
set -u
program=$1
kills=${2:-50}
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
fail() { echo "kill: $1" >&2; exit 1; }
file=$folder/history.sqlite
figures=1000

# report NUMBER FOLDER: a report of its own commit and date.
report() {
  mkdir -p "$2"
  awk -v n="$1" -v figures="$figures" 'BEGIN {
    printf "{\"schema\":\"halfway-results\",\"version\":1,\"command\":\"./halfway report\",\"curves\":[],\"timings\":[],"
    printf "\"context\":{\"machine\":\"m, 1 cores\",\"compiler\":\"c\",\"flags\":\"f\",\"build_type\":\"Release\","
    printf "\"commit\":\"c%06d\",\"date\":\"2026-01-01T%02d:%02d:%02dZ\"},\"findings\":[", n, n / 3600, n / 60 % 60, n % 60
    for (i = 0; i < figures; ++i)
      printf "%s{\"name\":\"f%d\",\"formulation\":\"\",\"value\":%d,\"unit\":\"\",\"comparison\":\"report\",\"expected\":0,\"low\":0,\"high\":0,\"verdict\":\"pass\"}",
             i ? "," : "", i, n
    print "]}"
  }' > "$2/results.json"
}

# writer NUMBER: keeps runs until it is told to stop, each told in a file of its own once it is kept.
writer() {
  n=$(($1 * 10000))
  while [ ! -e "$folder/stop" ]; do
    n=$((n + 1))
    report "$n" "$folder/report$1"
    "$program" history add "$folder/report$1" --file "$file" > /dev/null 2> "$folder/err$1" &
    echo $! > "$folder/pid$1"
    wait $!
    code=$?
    case $code in
      0) : > "$folder/kept.$n" ;;
      137) : > "$folder/killed.$n" ;;
      *) cp "$folder/err$1" "$folder/failed" ;;
    esac
  done
}

pids=
for i in 1 2 3 4; do
  writer $i 2> /dev/null &
  pids="$pids $!"
done
done=0
tries=0
while [ "$done" -lt "$kills" ] && [ ! -e "$folder/failed" ]; do
  tries=$((tries + 1))
  [ "$tries" -lt 100000 ] || break
  sleep "0.0$((tries * 7 % 10))"  # at another moment each time
  pid=$(cat "$folder/pid$((tries % 4 + 1))" 2> /dev/null) && [ -n "$pid" ] && kill -9 "$pid" 2> /dev/null
  done=$(find "$folder" -name 'killed.*' | wc -l)
done
: > "$folder/stop"
# shellcheck disable=SC2086  # several are meant
wait $pids 2> /dev/null
[ ! -e "$folder/failed" ] || fail "a writer that was not killed failed: $(cat "$folder/failed")"
[ "$done" -ge "$kills" ] || fail "only $done of $kills writers could be killed"

# Reading verifies every checksum.
"$program" history export --file "$file" --out "$folder/all.jsonl" || fail "the file is not sound"
kept=$(find "$folder" -name 'kept.*' | wc -l)
[ "$kept" -ge 10 ] || fail "only $kept runs were kept: the writers were killed too fast"
half=0
for killed in "$folder"/killed.*; do
  grep -q "\"commit\":\"$(printf 'c%06d' "${killed##*.}")\"" "$folder/all.jsonl" && half=$((half + 1))
done
for told in "$folder"/kept.*; do
  commit=$(printf 'c%06d' "${told##*.}")
  grep -q "\"commit\":\"$commit\"" "$folder/all.jsonl" || fail "run $commit was told to be kept and is lost"
done
# Every figure of a run differs from that of any other: each run has all of its changes, or it is half there.
runs=$(grep -c '"commit"' "$folder/all.jsonl")
[ "$runs" -eq $((kept + half)) ] || fail "$runs runs, but $kept kept and $half killed when they were done"
whole=$(grep '"commit"' "$folder/all.jsonl" | grep -o '"report"' | wc -l)
[ "$whole" -eq $((runs * figures)) ] || fail "$runs runs have $whole figures instead of $((runs * figures))"
[ "$half" -lt "$kills" ] || fail "every kill came after the work: none was in the middle"

# The same check fails for a file with a wrong byte.
commit=$(grep -o '"commit":"c[0-9]*' "$folder/all.jsonl" | head -n 1 | cut -d'"' -f4)
for at in $(grep -abo "$commit" "$file" | cut -d: -f1); do  # the row, and what finds it
  printf 'x' | dd of="$file" bs=1 seek="$at" conv=notrunc 2> /dev/null
done
"$program" history export --file "$file" > /dev/null 2> "$folder/err" && fail "a wrong byte goes unseen"
grep -q 'damaged: run ' "$folder/err" || fail "a wrong byte is not named: $(cat "$folder/err")"
echo "$kept runs kept, $done writers killed ($half of them when their run was already kept)"
