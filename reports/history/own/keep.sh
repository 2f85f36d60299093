#!/bin/sh
# Keeps reports of this project's own commits in history.jsonl, which .ci/run compares with and README's dashboard
# shows. It builds and measures each commit in a worktree of its own (minutes a commit) and is started by hand.
set -eu

usage() {
  cat <<'TEXT'
usage: reports/history/own/keep.sh [COMMIT ...]
       reports/history/own/keep.sh --report FOLDER

  COMMIT           build it, run its report, keep that; default: the commits of commits.txt. One that is
                   kept is passed over, and an interrupted run goes on where it was. build/own can go
                   afterwards: git worktree remove --force build/own/COMMIT
  --report FOLDER  keep a report that is there, such as build/ci/report: of a commit, without changes
TEXT
}

say() { printf 'keep: %s\n' "$*" >&2; }
fail() { say "$*"; exit 1; }

own=$(cd "$(dirname "$0")" && pwd)
kept=$own/history.jsonl
list=$own/commits.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The commit that a report says it is of.
commit_of() { sed -n 's/^ *"commit": "\([^"]*\)".*/\1/p' "$1/results.json" | head -n 1; }

# The name that commits.txt gives a commit, by its first seven digits.
name_of() { sed -n "s/^$(printf %.7s "$1")[0-9a-f]* *//p" "$list"; }

is_kept() { [ -f "$kept" ] && grep -q "^{\"commit\":\"$(printf %.7s "$1")" "$kept"; }

# When it was committed: measured in any order, runs stand in that of their commits.
date_of() { TZ=UTC git -C "$top" log -1 --date=format-local:%Y-%m-%dT%H:%M:%SZ --format=%cd "$1"; }

# add FOLDER: the text becomes a database, the report is added, and the text is written anew, all of it or nothing.
# Repetitions are left out: the machine was busy, and with them older lines would change with each new one.
add() {
  [ -f "$1/results.json" ] || fail "$1: no results.json in it"
  commit=$(commit_of "$1")
  case $commit in
    *+changes) fail "$1: of $commit: only a commit is kept, so that others can measure it again" ;;
    *[!0-9a-f]* | '') fail "$1/results.json: commit '$commit'; allowed: digits of a commit" ;;
  esac
  git -C "$top" cat-file -e "$commit^{commit}" 2>/dev/null || fail "$1: of $commit, which is no commit here"
  rm -f "$work"/*
  [ ! -f "$kept" ] || "$top/halfway" history import "$kept" --file "$work/own.sqlite"
  (cd "$top" && ./halfway history add "$1" --file "$work/own.sqlite" --date "$(date_of "$commit")" \
    --release "$(name_of "$commit")")
  "$top/halfway" history prune --repetitions 0 --file "$work/own.sqlite"
  "$top/halfway" history export --file "$work/own.sqlite" --out "$kept"
}

# measure COMMIT: its report, in a worktree that stays for the next try.
measure() {
  tree=$top/build/own/$(printf %.7s "$1")
  [ -d "$tree" ] || git -C "$top" worktree add --quiet --detach "$tree" "$1"
  report=$tree/out/report
  if [ ! -f "$report/results.json" ]; then
    say "$1: building and measuring"
    # A report with failures ends with 1, and is a report.
    (cd "$tree" && nice ./halfway report --out "$report") || [ -f "$report/results.json" ] || fail "$1: no report"
  fi
  add "$report"
}

case ${1:-} in
  -h | --help) usage; exit 0 ;;
esac
top=$(git -C "$own" rev-parse --show-toplevel)
if [ "${1:-}" = --report ]; then
  [ $# -eq 2 ] || { usage >&2; exit 2; }
  [ -d "$2" ] || fail "$2: no such folder"
  add "$(cd "$2" && pwd)"
  exit 0
fi
# shellcheck disable=SC2046  # a word for each commit is meant
[ $# -gt 0 ] || set -- $(sed -n 's/^\([0-9a-f][0-9a-f]*\).*/\1/p' "$list")
for named in "$@"; do
  commit=$(git -C "$top" rev-parse --verify --quiet "$named^{commit}") || fail "'$named' is no commit here"
  if is_kept "$commit"; then say "$named is kept"; else measure "$commit"; fi
done
