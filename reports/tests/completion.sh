#!/bin/bash
# What bash completes of ./halfway: commands, options of the program that is built, scenes, formulations.
# Usage: completion.sh TOP BUILD
set -u
top=$1
export HALFWAY_BUILD=$2
unset HALFWAY_SCENES
# shellcheck source=reports/cli/completion.bash
. "$top/reports/cli/completion.bash"
fail() { echo "completion: $1" >&2; exit 1; }

# completes "WORDS" WANTED...: the last word is open.
completes() {
  local line=$1
  shift
  read -ra COMP_WORDS <<< "$top/halfway $line"
  case $line in *' ') COMP_WORDS+=("") ;; esac
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _halfway
  for wanted in "$@"; do
    printf '%s\n' "${COMPREPLY[@]}" | grep -qxF -e "$wanted" || fail "'$line' does not complete to $wanted: ${COMPREPLY[*]}"
  done
}

completes 're' report reference
completes 'da' dashboard
completes 'run --f' --formulation --format
completes 'run --a' --arc
completes 'run four' four_bar
completes 'run damped' damped_oscillator
completes 'run bend_45_p' bend_45_polar
completes 'run c3_buckling --formulation conf' conformal
completes 'run c3_buckling --formulation invariant,conf' invariant,conformal
completes 'run c3_buckling --format svg,h' svg,html
completes 'list --' --schema --types
completes 'export c3_buckling --to m' mbdyn
completes 'run no_such_scene_'
[ "${#COMPREPLY[@]}" -eq 0 ] || fail "something is completed to a scene that is none: ${COMPREPLY[*]}"
