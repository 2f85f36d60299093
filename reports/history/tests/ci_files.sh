#!/bin/sh
# Every ./halfway command that the files for CI and the documents of the history name is there, with its options.
# Usage: ci_files.sh TOP HISTORY_PROGRAM GATE_PROGRAM
set -u
top=$1
history=$2
gate=$3
fail() { echo "ci_files: $1" >&2; exit 1; }
known=" $("$top/halfway" help | sed -n 's/^  \([a-z]*\)  .*/\1/p' | tr '\n' ' ')"

# help_of COMMAND [SUBCOMMAND]: what says which options there are; of programs that are not built here nothing.
help_of() {
  case $1 in
    history) "$history" history "$2" --help 2> /dev/null ;;
    dashboard) "$history" dashboard --help 2> /dev/null ;;
    compare | gate) "$gate" "$1" --help 2> /dev/null ;;
    *) return 1 ;;
  esac
}
# wrong COMMAND WORDS...: says what is not there; of history every subcommand of "add|list" is asked for.
wrong() {
  case $known in *" $1 "*) ;; *) echo "no command $1"; return ;; esac
  case $1 in history | dashboard | compare | gate) ;; *) return ;; esac
  if [ "$1" = history ]; then
    [ -n "${2:-}" ] || return 0
    help_of history "$2" > /dev/null || { echo "no command history $2"; return; }
  fi
  text=$(help_of "$1" "${2:-}")
  for word in "$@"; do
    case $word in
      --*) printf '%s\n' "$text" | grep -q -- "^ *${word%%[!a-z-]*}\b" || echo "no option $word" ;;
    esac
  done
}
# A line of the commands of each file: ./halfway WORDS, up to what ends a command.
commands() { grep -ho '\./halfway [a-z][^`#|;&)]*' "$@"; }

check() {
  found=$(commands "$@" | sort -u | while read -r _ words; do
    # shellcheck disable=SC2086  # the words are meant to be split
    said=$(wrong $words)
    [ -z "$said" ] || echo "'./halfway $words': $said"
  done)
  [ -z "$found" ]
}

number=$(commands "$top/.github/workflows/halfway.yml" | wc -l)
[ "$number" -ge 8 ] || fail "the workflow has $number commands"
check "$top/.github/workflows/halfway.yml" "$top/README.md" "$top/reports/history/README.md" "$top/.ci/run" || fail "$found"
# The check itself: what is not there is found.
spoilt=$(mktemp) || exit 1
trap 'rm -f "$spoilt"' EXIT
for command in 'bend x' 'history bend' 'history add --bend' 'compare a b --bend' 'dashboard --bend'; do
  echo "run: ./halfway $command" > "$spoilt"
  check "$spoilt" && fail "'$command' is not found to be wrong"
done
echo "ci_files: $number commands of the workflow, all there"
