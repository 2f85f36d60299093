#!/bin/sh
# Each program asked by `halfway check`: is it told what it is, and are its defects found, all and no others?
#   verdicts.sh HALFWAY_CHECK PROGRAMS.TSV VERDICTS.TSV
# Exit codes: 0 all were, 1 one was not, 77 no program is there.
set -eu
[ $# -eq 3 ] || { echo "usage: verdicts.sh HALFWAY_CHECK PROGRAMS.TSV VERDICTS.TSV" >&2; exit 2; }
check=$1 programs=$2 verdicts=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tab=$(printf '\t')
asked=0 wrong=0 left_out=0
while IFS="$tab" read -r name command reason; do
  if [ "$command" = - ]; then
    echo "left out  $name: $reason"
    left_out=$((left_out + 1))
    continue
  fi
  row=$(grep "^$name$tab" "$verdicts") || { echo "WRONG     $name has no row in $verdicts"; wrong=$((wrong + 1)); continue; }
  joint=$(printf '%s' "$row" | cut -f2)
  printf '%s' "$row" | cut -f3 | tr ' ' '\n' >"$folder/expected"
  asked=$((asked + 1))
  status=0
  "$check" check --command "$command" --expected "$folder/expected" >"$folder/said" 2>"$folder/told" || status=$?
  if [ $status -eq 0 ] && grep -q "^your joint is $joint (" "$folder/said"; then
    echo "ok        $name: $(sed -n 's/^your joint is //p' "$folder/said")"
  else
    echo "WRONG     $name is $joint with exactly these failures: $(printf '%s' "$row" | cut -f3)"
    cat "$folder/said" "$folder/told"
    wrong=$((wrong + 1))
  fi
done <"$programs"
echo "$asked programs asked, $wrong wrong, $left_out left out"
[ $wrong -eq 0 ] || exit 1
[ $asked -gt 0 ] || exit 77
