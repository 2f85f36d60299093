#!/bin/sh
# Programs of one source whose functions lie in another order each, and so on other alignments:
#   layouts.sh SOURCE FOLDER COUNT
# compiles SOURCE once with a section for each function, then links halfway_bench COUNT times by gold, the
# sections shuffled by seeds 1, 2, ... The programs are FOLDER/1/halfway_bench and so on; those that are there stay
# while the source does.
set -eu
[ $# -eq 3 ] || { echo "usage: layouts.sh SOURCE FOLDER COUNT" >&2; exit 2; }
source=$1 count=$3
mkdir -p "$2"
folder=$(cd "$2" && pwd)
command -v ld.gold >/dev/null || { echo "layouts.sh: ld.gold is missing (Debian: binutils)" >&2; exit 1; }
build=$folder/build
order=$folder/order.txt
[ -f "$order" ] || : >"$order"
log=$folder/build.log
run() { "$@" >>"$log" 2>&1 || { echo "layouts.sh: '$*' failed; see $log" >&2; exit 1; }; }

: >"$log"
[ -f "$build/build.ninja" ] || run cmake -S "$source" --preset release -B "$build" -DCMAKE_CXX_FLAGS=-ffunction-sections \
  "-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=gold -Wl,--section-ordering-file=$order"
program=$build/bin/halfway_bench
made() { stat -c %y "$program" 2>/dev/null || echo never; }
before=$(made)
run ninja -C "$build" halfway_bench
[ "$(made)" = "$before" ] || rm -rf "$folder"/[0-9]*
seed=1
while [ "$seed" -le "$count" ]; do
  if [ ! -x "$folder/$seed/halfway_bench" ]; then
    nm --defined-only "$program" | awk '$2 ~ /^[tTwW]$/ {print ".text." $3}' | LC_ALL=C sort -u |
      awk -v seed="$seed" 'BEGIN {srand(seed)} {printf "%.9f %s\n", rand(), $0}' | LC_ALL=C sort | cut -d' ' -f2 >"$order"
    rm "$program"
    run ninja -C "$build" halfway_bench
    mkdir -p "$folder/$seed"
    cp "$program" "$folder/$seed/halfway_bench.part"
    mv "$folder/$seed/halfway_bench.part" "$folder/$seed/halfway_bench"
  fi
  seed=$((seed + 1))
done
