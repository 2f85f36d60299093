#!/bin/sh
# Prints measurements that ctest takes from the output of a test; fails when there is none.
# Usage: measured.sh HISTORY_PROGRAM KEPT_HISTORY FIGURES
set -eu
set -- "$1" history export --format ctest --file "${HALFWAY_HISTORY:-$2}" ${3:+--figure "$3"}
exec "$@"
