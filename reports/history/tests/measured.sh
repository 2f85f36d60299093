#!/bin/sh
# Prints measurements that ctest takes from the output of a test; fails when there is none.
# Usage: measured.sh HISTORY_PROGRAM KEPT_HISTORY FIGURES. Exit code 77: no run is kept yet.
set -eu
kept=${HALFWAY_HISTORY:-$2}
[ -e "$kept" ] || { echo "measured: left out: $kept is not there yet"; exit 77; }
exec "$1" history export --format ctest --file "$kept" ${3:+--figure "$3"}
