# These shell functions install packages and build. ./glassbox and tests/run.sh source this file
# with $root set to the top of the clone. They print to stderr, and write only into $root/build.

say() { printf '%s\n' "$*" >&2; }

# Runs a command with its output in a log. The log is shown only if the command fails.
quietly() {
  log=$1
  shift
  "$@" >"$log" 2>&1 </dev/null && return 0
  status=$?
  say "failed: $*"
  tail -n 60 "$log" >&2
  say "(the whole log is in $log)"
  return $status
}

# show_progress WHAT LOG shows, until it is killed, the progress of the build that writes LOG. On a
# terminal it updates one line; otherwise it prints a line every ten seconds.
show_progress() {
  seconds=0
  while sleep 1 && kill -0 $$ 2>/dev/null; do
    seconds=$((seconds + 1))
    # The sed command turns
    # "[12/340] Building CXX object mesh/CMakeFiles/glassbox_mesh.dir/gltf/load.cpp.o"
    # into "step 12 of 340: mesh/gltf/load.cpp".
    step=$(tail -n 1 "$2" | sed -n -e 's#CMakeFiles/[^/]*\.dir/##' -e 's#\.o$##' -e 's#^\[\([0-9]*\)/\([0-9]*\)\] [^ ]*.* \([^ ]*\)$#step \1 of \2: \3#p')
    if [ -t 2 ]; then
      printf '\r\033[K%s, %s s, %s' "$1" "$seconds" "$step" | cut -c "1-$(progress_columns)" | tr -d '\n' >&2
    elif [ $((seconds % 10)) = 0 ]; then
      say "  $1, $seconds s, $step"
    fi
  done
}

progress_columns() {
  columns=$(stty size <&2 2>/dev/null | cut -d ' ' -f 2)
  [ "${columns:-0}" -gt 20 ] || columns=80
  echo $((columns + 3)) # the characters that clear the line take no room
}

# with_progress WHAT LOG COMMAND... runs a command quietly, and shows only its progress.
with_progress() {
  what=$1
  shift
  : >"$1"
  # The lock is closed here, because show_progress may outlast the build by a second.
  show_progress "$what" "$1" 9>&- &
  watcher=$!
  status=0
  quietly "$@" || status=$?
  kill "$watcher" 2>/dev/null
  wait "$watcher" 2>/dev/null || :
  if [ -t 2 ]; then printf '\r\033[K' >&2; fi
  return $status
}

# packages_of SECTION... prints the names of the packages in cmake/packages.txt. Alternatives are
# one word, "a|b".
packages_of() {
  for section in "$@"; do
    sed -n "/^\[$section]/,/^\[/ { s/#.*//; s/[[:space:]]//g; /^\[/d; /^\$/d; p }" \
      "$root/cmake/packages.txt"
  done
}

# missing_packages SECTION... prints the packages that are not installed. If no alternative of "a|b"
# is installed, it prints them as one word. Without dpkg it prints nothing, and CMake reports what
# it does not find.
missing_packages() {
  command -v dpkg-query >/dev/null 2>&1 || return 0
  wanted=$(packages_of "$@")
  # shellcheck disable=SC2046  # one word a package
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' $(printf '%s\n' "$wanted" | tr '|' ' ') 2>/dev/null |
    sed -n 's/ installed$//p')
  for package in $wanted; do
    printf '%s\n' "$package" | tr '|' '\n' | grep -qxF -e "$installed" || printf '%s\n' "$package"
  done
}

# choose_packages WORD... prints, for each word "a|b", the first package that apt knows. If apt
# knows none of them, it prints the first one. apt knows packages after "apt-get update".
choose_packages() {
  for word in "$@"; do
    chosen=${word%%|*}
    case $word in
    *"|"*)
      for package in $(printf '%s\n' "$word" | tr '|' ' '); do
        if apt-cache show "$package" >/dev/null 2>&1; then
          chosen=$package
          break
        fi
      done
      ;;
    esac
    printf '%s\n' "$chosen"
  done
}

# install_command WORD... prints the command that installs these packages.
install_command() {
  # shellcheck disable=SC2046  # one word a package
  echo apt-get install --no-install-recommends -y $(choose_packages "$@")
}

# install_packages SECTION... installs the missing packages. If it may not install, it prints the
# command and returns 3.
install_packages() {
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" = 0 ]; then
    become=
  elif command -v sudo >/dev/null 2>&1; then
    become=sudo
  else
    say "These packages are missing and only root may install them. Run this as root, then try again:"
    # shellcheck disable=SC2086  # one word a package
    say "  apt-get update && $(install_command $missing)"
    return 3
  fi
  say "asking apt for packages ..."
  for step in update install; do
    command="apt-get update"
    if [ $step = install ]; then
      # shellcheck disable=SC2086
      command=$(install_command $missing)
      say "installing ${command#* -y } ..."
    fi
    # shellcheck disable=SC2086
    quietly "$root/build/packages.log" $become env DEBIAN_FRONTEND=noninteractive $command \
      -o DPkg::Lock::Timeout=300 && continue
    # shellcheck disable=SC2086
    say "Install them yourself, then try again: apt-get update && $(install_command $missing)"
    return 3
  done
}

# Only one run at a time sets up. A second run waits here for the first.
locked() {
  mkdir -p "$root/build" || return 1
  (
    if command -v flock >/dev/null 2>&1 && ! flock -n 9; then
      say "waiting for another ./glassbox that is building ..."
      flock 9
    fi
    "$@"
  ) 9>"$root/build/.lock"
}

# directory_of PRESET prints the build folder. The tests are built beside the program, from the same
# objects.
directory_of() {
  case $1 in
  test) echo "$root/build/release" ;;
  *) echo "$root/build/$1" ;;
  esac
}

# configure_preset PRESET configures the build, unless this is already done.
configure_preset() {
  directory=$(directory_of "$1")
  cache=$directory/CMakeCache.txt
  # A build works only in the place where it was made.
  if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf "$directory"
  fi
  mkdir -p "$directory" || return 1
  if [ -f "$directory/build.ninja" ]; then
    # A build with the tests contains the program too.
    [ "$1" = release ] || grep -qx 'BUILD_TESTING:BOOL=ON' "$cache" && return 0
  fi
  (cd "$root" && quietly "$directory/configure.log" cmake --preset "$1")
}

# needs_work PRESET TARGET says whether building the target would do anything.
needs_work() {
  ! cmake --build "$(directory_of "$1")" --target "$2" -- -n 2>/dev/null </dev/null | grep -q 'no work to do'
}

# build_preset PRESET [TARGET] configures if needed, and builds.
build_preset() {
  configure_preset "$1" || return 1
  directory=$(directory_of "$1")
  with_progress "building ${2:-$1}" "$directory/build.log" \
    cmake --build "$directory" ${2:+--target "$2"}
}
