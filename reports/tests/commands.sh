# shellcheck shell=sh disable=SC2034
# Sourced by tests of commands, which define ask ARGUMENT...: a folder of their own to work in, fail, refused.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() { echo "FAILED: $*" >&2; exit 1; }
refused() {  # STATUS WORDS ARGUMENT...
  wanted=$1 words=$2 status=0
  shift 2
  ask "$@" >said 2>&1 || status=$?
  [ $status -eq "$wanted" ] || { cat said; fail "$* ended with $status, not $wanted"; }
  grep -qF -- "$words" said || { cat said; fail "$* does not say '$words'"; }
}
refused_in_one_line() {
  refused "$@"
  [ "$(wc -l <said)" -eq 1 ] || { cat said; fail "$* says more than one line"; }
}
