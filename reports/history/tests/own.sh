#!/bin/sh
# The history that the repository keeps of itself is what the program writes, and a spoilt figure is seen in it;
# keep.sh keeps each commit once, goes on after an interruption and refuses what nobody could measure again.
# Usage: own.sh HISTORY_PROGRAM GATE_PROGRAM FOLDER_OF_THE_HISTORY
set -u
history=$1
gate=$2
own=$3
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "own: $1" >&2; cat "$folder/said" "$folder/err" >&2; exit 1; }
compare() { env -u GITHUB_ACTIONS -u GITLAB_CI -u TF_BUILD "$gate" compare "$@" > said 2> err; }

spoilt() { # PATTERN SED: what is said of it
  sed "$2" last.jsonl > spoilt.jsonl
  cmp -s last.jsonl spoilt.jsonl && fail "'$2' spoils nothing"
  compare "$own/history.jsonl" spoilt.jsonl
  [ $? -eq 1 ] || fail "'$2' is not seen"
  [ "$(grep -c '^REGRESSION' said)" -eq 1 ] && grep -q "^REGRESSION .*$1" said || fail "'$2' is not named '$1'"
}
kept_text() {
  "$history" history list --file "$own/history.jsonl" > said 2> err || fail "cannot be read"
  runs=$(grep -c '^ *[0-9]' said)
  for commit in $(sed -n 's/^\([0-9a-f][0-9a-f]*\).*/\1/p' "$own/commits.txt"); do
    grep -q "Z  $commit" said || fail "$commit of commits.txt is not kept"
  done
  "$history" history import "$own/history.jsonl" --file own.sqlite > said 2> err || fail "cannot be imported"
  "$history" history export --file own.sqlite | cmp -s - "$own/history.jsonl" || fail "not what the program writes"

  # The last run against itself, then with one thing of it spoilt.
  "$history" history export --file "$own/history.jsonl" --run "$runs" --out last.jsonl > said 2> err || fail "no last run"
  compare "$own/history.jsonl" last.jsonl || fail "the last run is worse than itself"
  spoilt 'pass -> fail' '2s/"pass"\]/"fail"]/'
  spoilt 'limit .* -> 1$' '2s/\("at_most",[^,]*,[^,]*,\)[^,]*/\11.0/'
  spoilt ' -> ' '2s/\([0-9]\)\.0,"none"/\19.0,"none"/'
  spoilt 'gone: ' '2s/"changes":\[\[[^]]*\],/"changes":[/'
}
# Before the first run is kept there is no text, and no commit that should be in it.
if [ -e "$own/history.jsonl" ] || grep -q '^[0-9a-f]' "$own/commits.txt"; then kept_text; else echo "own: no run is kept yet"; fi

# A project of two commits, whose program is the one under test and whose report is a finding.
mkdir -p project/reports/history/own
cd project || exit 1
cp "$own/keep.sh" reports/history/own/
cat > halfway <<SCRIPT
#!/bin/sh
[ "\$1" = report ] || exec "$history" "\$@"
echo report >> "$folder/reports"
mkdir -p "\$3" && cat > "\$3/results.json" <<JSON
{"schema": "halfway-results", "version": 1, "command": "./halfway report", "timings": [], "curves": [],
 "context": {"machine": "m, 1 cores", "compiler": "c", "flags": "f", "build_type": "Release",
 "commit": "\$(git rev-parse --short=12 HEAD)\$CHANGES",
             "date": "2026-01-02T03:04:05Z"},
 "findings": [{"name": "a", "formulation": "", "value": 1, "unit": "", "comparison": "report",
               "expected": 0, "low": 0, "high": 0, "verdict": "pass"}]}
JSON
exit \${CODE:-0}
SCRIPT
chmod +x halfway
printf 'build/\nout/\n' > .gitignore
# commit DAY SUBJECT
commit() { git add -A && GIT_COMMITTER_DATE="2026-01-0$1T02:00:00+02:00" git -c user.name=n -c user.email=e commit -qm "$2"; }
git init -q . && commit 1 'the first' || fail "no repository"
echo "$(git rev-parse --short=7 HEAD) a name" > reports/history/own/commits.txt
commit 2 'the second' || fail "no second commit"
keep() { env CHANGES="${CHANGES:-}" reports/history/own/keep.sh "$@" > ../said 2> ../err; }
lines() { wc -l < reports/history/own/history.jsonl; }

# The later one first: they stand in the order of their commits.
CODE=1 keep HEAD || fail "a report with failures is none"
keep || fail "the commit of the list is not kept"
"$history" history list --file reports/history/own/history.jsonl > ../said
grep -q "1  2026-01-01T00:00:00Z  $(git rev-parse --short=12 HEAD~) .*\[a name\] the first" ../said || fail "the first commit has not its date, name and subject"
grep -q '2  2026-01-02T00:00:00Z .* the second' ../said || fail "the second is not the second"
# Interrupted after the report: that is not made again.
rm reports/history/own/history.jsonl
keep HEAD || fail "cannot go on"
[ "$(wc -l < ../reports)" -eq 2 ] || fail "a report that is there is made again"
rm -r build/own/*/out
keep HEAD || fail "a commit that is kept is no longer passed over"
[ "$(wc -l < ../reports)" -eq 2 ] || fail "measured again without need"
keep no-such-commit && fail "no commit is kept"
grep -q "'no-such-commit' is no commit here" ../err || fail "not named"
cp reports/history/own/history.jsonl ../before
CHANGES=+changes ./halfway report --out "$folder/dirty"
keep --report "$folder/dirty" && fail "a report of changes that were not committed is kept"
grep -q 'only a commit is kept' ../err || fail "does not say why"
keep --report "$folder" && fail "a folder without a report is kept"
cmp -s reports/history/own/history.jsonl ../before || fail "what was refused is written"
echo "own: ${runs:-0} runs, all as expected"
