#!/bin/sh
# The commands as a person calls them: exit codes, one message a line, files, an interruption.
# Usage: program.sh PROGRAM
set -u
program=$1
folder=$(mktemp -d) || exit 1
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "program: $1" >&2; cat said err >&2; exit 1; }

# fake NAME NS: three figures of NS ns, noise of 1 %, 0.05 s a run.
fake() {
  mkdir -p "$1"
  cat >"$1/halfway_bench" <<'SCRIPT'
#!/bin/sh
echo start >>"$0.starts"
sleep 0.05
for word in "$@"; do case $word in --benchmark_out=*) out=${word#*=} ;; esac; done
awk -v seed="$(wc -l <"$0.starts")" -v ns=NS 'BEGIN {
  srand(seed); print "{\"benchmarks\": ["
  for (i = 1; i <= 3; ++i)
    printf "{\"name\": \"f%d\", \"cpu_time\": %.4f, \"time_unit\": \"ns\"}%s\n", i, ns * (1 + 0.01 * rand()), i < 3 ? "," : ""
  print "]}"}' >"$out"
SCRIPT
  sed -i "s/ns=NS/ns=$2/" "$1/halfway_bench"
  chmod +x "$1/halfway_bench"
}
gate() { env -u GITHUB_ACTIONS -u GITLAB_CI -u TF_BUILD "$program" gate "$@" >said 2>err; }
starts() { wc -l <"$1/halfway_bench.starts" 2>/dev/null || echo 0; }
one_line() { [ "$(grep -c '^halfway: ' err)" -eq 1 ] && grep -q "$1" err || fail "no single message '$1'"; }

fake base 100
fake same 100
fake slow 110
gate base same || fail "exit code $? of two that are alike"
grep -q '3 figures compared: 0 worse' said || fail "no summary"

gate base slow --markdown pr.md --annotations gitlab --code-quality quality.json
[ $? -eq 1 ] || fail "a slow-down of 10 % passed"
[ "$(grep -c '^REGRESSION f[123]: time 1' said)" -eq 3 ] || fail "not one line each"
one_line '3 regressions'
grep -q '| f1 | time 1' pr.md || fail "no Markdown"
[ "$(grep -c '"fingerprint"' quality.json)" -eq 3 ] || fail "no code quality report"
[ "$(starts slow)" -eq 18 ] || fail "$(starts slow) starts and not 9 and 9 fresh ones"

# Again: from the journal. With --again: afresh.
gate base slow --annotations github
[ $? -eq 1 ] || fail "another answer from the journal"
grep -q '^::error title=f1::f1: time' said || fail "no annotation"
[ "$(starts slow)" -eq 18 ] || fail "measured again without need"
gate base slow --again && fail "another answer afresh"
[ "$(starts slow)" -eq 36 ] || fail "--again did not measure"

# Interrupted in the middle, then on from there.
fake late 100
"$program" gate base late >said 2>err &
pid=$!
while [ "$(starts late)" -lt 3 ]; do sleep 0.02; done
kill -INT "$pid"
wait "$pid"
[ $? -eq 1 ] || fail "an interruption passed"
one_line 'interrupted; the same command goes on'
gate base late || fail "exit code $? after an interruption"
[ "$(starts late)" -le 10 ] || fail "$(starts late) starts: measured twice"
grep -q 'measurements are there from before' err || fail "it did not go on"

# Reports: kept by halfway-suite, which here copies one; the later has a finding less.
report() {
  printf '#!/bin/sh\nmkdir -p "$3" && cat >"$3/results.json" <<TEXT\n%s\nTEXT\nexit 1\n' \
    "{\"schema\":\"halfway-results\",\"version\":1,\"command\":\"r\",\"context\":{\"commit\":\"c\",\"date\":\"2026-01-02T03:04:05Z\",\"machine\":\"m\",\"compiler\":\"g\",\"flags\":\"\",\"build_type\":\"r\"},\"findings\":[$2],\"timings\":[],\"curves\":[]}" >"$1/halfway-suite"
  chmod +x "$1/halfway-suite"
}
finding() { echo "{\"name\":\"$1\",\"formulation\":\"\",\"unit\":\"\",\"comparison\":\"report\",\"value\":1,\"expected\":0,\"low\":0,\"high\":0,\"verdict\":\"${2:-pass}\"}"; }
gate base same --report; [ $? -eq 1 ] || fail "there is no report, and that passed"
one_line 'no halfway-suite beside'
report base "$(finding one),$(finding two)"
report same "$(finding one)"
gate base same --report; [ $? -eq 1 ] || fail "a finding that is gone passed"
grep -q '^REGRESSION two: gone' said || fail "not named"

gate no-such-commit same; [ $? -eq 2 ] || fail "an unknown commit is no wrong input"
one_line "'no-such-commit' is no commit"
gate; [ $? -eq 2 ] || fail "nothing was compared with nothing"
one_line 'BASE is missing'
gate base same --filter '('; [ $? -eq 2 ] || fail "a wrong filter passed"
one_line 'is not a regular expression'
gate base same --pairs 3; [ $? -eq 2 ] || fail "three pairs passed"
gate base same --annotations travis; [ $? -eq 2 ] || fail "an unknown service passed"
one_line "unknown service 'travis'"
"$program" compare base same >said 2>err; [ $? -eq 2 ] || fail "a folder without a report passed"
one_line 'results.json'
printf '#!/bin/sh\nexit 9\n' >same/halfway_bench
gate base same; [ $? -eq 1 ] || fail "a program that fails passed"
one_line 'exit code 9'
exit 0
