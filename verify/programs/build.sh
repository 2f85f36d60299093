#!/bin/sh
# Builds those programs that this machine has the packages of, and says of each other one what it lacks.
set -eu

usage() {
  cat <<'TEXT'
usage: verify/programs/build.sh FOLDER

Builds the adapters in FOLDER, one line each: built, or left out and why. FOLDER/programs.tsv then has
one line a case: its name, and the command that runs it; or its name, "-", and why it is left out.
Packages of Debian are not installed (README.md names them); those of npm are, below FOLDER.
CXX is the compiler; default: c++
TEXT
}

[ $# -eq 1 ] || { usage >&2; exit 2; }
case $1 in -h | --help) usage; exit 0 ;; esac
here=$(cd "$(dirname "$0")" && pwd)
top=$(cd "$here/../.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
cxx=${CXX:-c++}
table=$folder/programs.tsv
tab=$(printf '\t')
: >"$table.new"

# quoted WORD: as a shell reads it back; a plain one stays as it is.
quoted() {
  case $1 in
    *[!A-Za-z0-9_./+-]*) printf "'%s'" "$(printf %s "$1" | sed "s/'/'\\\\''/g")" ;;
    *) printf %s "$1" ;;
  esac
}

# built PROGRAM COMMAND CASE ...
built() {
  printf '%-8s built\n' "$1"
  command=$2
  shift 2
  for name in "$@"; do printf '%s\t%s %s\n' "$name" "$command" "$name" >>"$table.new"; done
}

# left_out PROGRAM REASON CASE ...
left_out() {
  printf '%-8s left out: %s\n' "$1" "$2"
  reason=$2
  shift 2
  for name in "$@"; do printf '%s\t-\t%s\n' "$name" "$reason" >>"$table.new"; done
}

# newest OBJECT SOURCE ...: nothing to do, the object is newer than its sources.
newest() {
  object=$1
  shift
  [ -e "$object" ] && [ -z "$(find "$@" "$here/build.sh" -newer "$object")" ]
}

# first_error LOG
first_error() { grep -m 1 -E 'error|cannot find|not found' "$1" | cut -c 1-160 | tr "$tab" ' '; }

# Of every C++ program: it alone includes the JSON library.
adapter() {
  newest "$folder/adapter.o" "$here/adapter.cpp" "$here/adapter.hpp" ||
    "$cxx" -std=c++17 -O1 -I"$top" -c "$here/adapter.cpp" -o "$folder/adapter.o" >"$folder/adapter.log" 2>&1
}

# has_header HEADER FLAG ...
has_header() {
  printf '#include <%s>\n' "$1" >"$folder/header.cpp"
  shift
  "$cxx" "$@" -E "$folder/header.cpp" >"$folder/header.log" 2>&1
}

# cpp PROGRAM PACKAGE HEADER "FLAGS" CASE ...: FLAGS are words for the compiler, split at blanks.
cpp() {
  program=$1 package=$2 header=$3 flags=$4
  shift 4
  if [ -n "$no_cpp" ]; then
    left_out "$program" "$no_cpp" "$@"
    return
  fi
  # shellcheck disable=SC2086
  if ! has_header "$header" -std=c++20 $flags; then
    left_out "$program" "$header is missing (Debian: $package)" "$@"
    return
  fi
  # shellcheck disable=SC2086
  if newest "$folder/$program" "$here/$program.cpp" "$folder/adapter.o" ||
    "$cxx" -std=c++20 -O1 -I"$top" "$here/$program.cpp" "$folder/adapter.o" -o "$folder/$program" $flags \
      >"$folder/$program.log" 2>&1; then
    built "$program" "$(quoted "$folder/$program")" "$@"
  else
    left_out "$program" "it does not compile: $(first_error "$folder/$program.log")" "$@"
  fi
}

# flags_of MODULE DEFAULT: what pkg-config says, or the flags where Debian has the package.
flags_of() { pkg-config --cflags --libs "$1" 2>/dev/null || printf %s "$2"; }

# Packages as in package-lock.json, once.
npm_packages() {
  command -v node >/dev/null || { echo "no node"; return 1; }
  cp "$here/package.json" "$here/package-lock.json" "$here"/*.mjs "$folder"
  if ! cmp -s "$folder/package-lock.json" "$folder/node_modules/installed.json"; then
    command -v npm >/dev/null || { echo "no npm"; return 1; }
    (cd "$folder" && npm ci --ignore-scripts --no-audit --no-fund --fetch-retries=1 --fetch-timeout=60000) \
      >"$folder/npm.log" 2>&1 ||
      { echo "npm does not install its package: $(first_error "$folder/npm.log")"; return 1; }
    cp "$folder/package-lock.json" "$folder/node_modules/installed.json"
  fi
}

# js PROGRAM PACKAGE CASE ...
js() {
  program=$1 package=$2
  shift 2
  if [ -n "$no_npm" ]; then
    left_out "$program" "$no_npm" "$@"
  elif [ ! -d "$folder/node_modules/$package" ]; then
    left_out "$program" "npm did not install $package" "$@"
  else
    built "$program" "node $(quoted "$folder/$program.mjs")" "$@"
  fi
}

no_cpp=
if ! command -v "$cxx" >/dev/null; then
  no_cpp="no compiler $cxx"
elif ! has_header nlohmann/json.hpp; then
  no_cpp="nlohmann/json.hpp is missing (Debian: nlohmann-json3-dev)"
elif ! adapter; then
  no_cpp="adapter.cpp does not compile: $(first_error "$folder/adapter.log")"
fi
# Simbody's headers are no C++20; what pkg-config asks for is older still.
cpp simbody libsimbody-dev Simbody.h \
  "$(flags_of simbody '-I/usr/include/simbody -lSimTKsimbody -lSimTKmath -lSimTKcommon') -std=c++17" simbody
cpp bullet libbullet-dev btBulletDynamicsCommon.h "$(flags_of bullet-float64 '-DBT_USE_DOUBLE_PRECISION
  -I/usr/include/bullet -lBulletDynamics-float64 -lBulletCollision-float64 -lLinearMath-float64')" \
  bullet_old bullet_old_nooffset bullet bullet_default
cpp mujoco libmujoco-dev mujoco/mujoco.h -lmujoco mujoco_chain mujoco_ball mujoco_weld mujoco_free
cpp ode libode-dev ode/ode.h "$(flags_of ode -lode)" ode_amotor ode_fixed
# Not pkg-config: Debian's file for DART asks for C++11 and for libraries that nothing here calls.
cpp dart libdart-dev dart/dynamics/BodyNode.hpp "-I/usr/include/eigen3 -ldart -lfmt" dart_free dart_ball
no_npm=$(npm_packages) || no_npm=${no_npm:-"npm failed"}
js jolt jolt-physics jolt jolt_partial
js rapier @dimforge/rapier3d-compat rapier
js physx physx-js-webidl physx_swing_twist physx_slerp
js havok @babylonjs/havok havok
rm -f "$folder/header.cpp" "$folder/header.log"
mv "$table.new" "$table"
