# Completion of ./halfway for bash: `source reports/cli/completion.bash`, then ./halfway r<TAB>.
# Commands are those of `halfway help`, options those that the programs themselves name; nothing is built for it.
# shellcheck shell=bash

# Where the program of a command is, once it has been built.
_halfway_program() {
  local bin=${HALFWAY_BUILD:-$1/build/release}/bin
  case $2 in
    list | run | eval) echo "$bin/halfway" ;;
    report | bench | reference) echo "$bin/halfway-suite" ;;
    check) echo "$bin/halfway-check" ;;
    import | export) echo "$bin/halfway-import" ;;
    compare | gate) echo "$bin/halfway-gate" ;;
    history | dashboard) echo "$bin/halfway-history" ;;
  esac
}

_halfway_scenes() {
  local scenes=${HALFWAY_SCENES:-$1/reference/scenes}
  find "$scenes" "$scenes/chains" "$scenes/mechanisms" "$scenes/motion" -maxdepth 1 -name '*.toml' 2> /dev/null |
    sed 's|.*/||; s|\.toml$||'
}

_halfway_formulations() {
  local program
  program=$(_halfway_program "$1" list)
  if [ -x "$program" ]; then "$program" list --types | cut -d' ' -f1; fi
}

# The words that may stand here, one a line.
_halfway_words() {
  local top=$1 command=$2 before=$3 word=$4 program
  if [ -z "$command" ]; then
    "$top/halfway" help | sed -n 's/^  \([a-z]\{3,\}\)  .*/\1/p'
    return
  fi
  case $before in
    --formulation) _halfway_formulations "$top"; return ;;
    --format) printf '%s\n' csv json svg html; return ;;
    --to) printf '%s\n' bus osim mbdyn; return ;;
  esac
  program=$(_halfway_program "$top" "$command")
  case $word in
    -*) if [ -x "$program" ]; then "$program" "$command" --help | grep -oE -- '--[a-z][a-z-]*' | sort -u; fi ;;
    *) case $command in run | export) _halfway_scenes "$top" ;; esac ;;
  esac
}

_halfway() {
  local word=${COMP_WORDS[COMP_CWORD]} before="" command="" top list=""
  top=$(cd "$(dirname "${COMP_WORDS[0]}")" 2> /dev/null && pwd) || return
  if [ "$COMP_CWORD" -gt 1 ]; then command=${COMP_WORDS[1]} before=${COMP_WORDS[COMP_CWORD - 1]}; fi
  # Of a list a,b,c the last name alone is open.
  case $before in --formulation | --format) case $word in *,*) list=${word%,*}, word=${word##*,} ;; esac ;; esac
  COMPREPLY=()
  while IFS= read -r found; do COMPREPLY+=("$list$found"); done < <(
    compgen -W "$(_halfway_words "$top" "$command" "$before" "$word")" -- "$word")
}

complete -o default -F _halfway halfway ./halfway
