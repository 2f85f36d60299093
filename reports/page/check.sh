#!/bin/sh
# Checks the page's own code: formatting, mistakes, types, schema, the modules of data, and the page in Chromium.
#
#   check.sh [REPORT_FOLDER]
#
# Without a report the browser sees the tests' own small results; with one its index.html, and its results.json is
# held against the schema. HALFWAY_RUN=PROGRAM: pages of its runs are looked at as well as the tests' own. Without
# Chromium those tests are skipped and say so. Ends with 1 when something fails.
set -u

cd "$(dirname "$0")" || exit 1
report=""
if [ $# -gt 0 ]; then
  report=$(cd "$OLDPWD" && cd "$1" && pwd) || { echo "check: $1: no such folder" >&2; exit 1; }
fi
failed=""

step() {
  name=$1
  shift
  if "$@"; then echo "check: $name: passed"; else echo "check: $name: FAILED" >&2; failed="$failed $name"; fi
}

work=$(mktemp -d) || exit 1
trap 'rm -rf "$work"' EXIT

# The packages of the checks; the bundle's own are installed by CMake without these.
if [ ! -f node_modules/.package-lock.json ] || [ -n "$(find package-lock.json -newer node_modules/.package-lock.json)" ]; then
  npm ci --ignore-scripts --no-audit --no-fund --loglevel=error || exit 1
fi

step format npx prettier --check --log-level warn .
step lint npx eslint .
step types npx tsc
step schema node tools/schema.mjs --check
step bundle node build.mjs "$work/page.html"
step run-page cmake -DTO="$work" -P run/embed.cmake
if [ -n "$report" ]; then
  step results node tools/validate.mjs "$report/results.json" --strict
  export PAGE_UNDER_TEST="$report/index.html"
fi
PAGE_BUNDLE="$work/page.html" DASHBOARD_BUNDLE="$work/dashboard.html" RUN_BUNDLE="$work/run.html" step tests node --test --test-reporter=spec tests/*.test.mjs tests/*/*.test.mjs

[ -z "$failed" ] || { echo "check: failed:$failed" >&2; exit 1; }
