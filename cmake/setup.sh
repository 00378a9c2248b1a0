# Shell functions of ./glassbox and tests/run.sh: packages and builds. Sourced with $root set to the top of the clone.
# Everything they say goes to stderr, and everything they write goes into $root/build.

say() { printf '%s\n' "$*" >&2; }

# Runs a command with its output in a log, which is shown only if it fails.
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

# show_progress WHAT LOG: until it is killed, how far the build that writes LOG has come. On a terminal a line that moves,
# elsewhere a line every ten seconds.
show_progress() {
  seconds=0
  while sleep 1 && kill -0 $$ 2>/dev/null; do
    seconds=$((seconds + 1))
    # "[12/340] Building CXX object mesh/CMakeFiles/glassbox_mesh.dir/gltf/load.cpp.o" -> "step 12 of 340: mesh/gltf/load.cpp"
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

# with_progress WHAT LOG COMMAND...: quietly, but for how far it has come.
with_progress() {
  what=$1
  shift
  : >"$1"
  show_progress "$what" "$1" 9>&- & # without the lock, which would outlast the build by a second
  watcher=$!
  status=0
  quietly "$@" || status=$?
  kill "$watcher" 2>/dev/null
  wait "$watcher" 2>/dev/null || :
  if [ -t 2 ]; then printf '\r\033[K' >&2; fi
  return $status
}

# packages_of SECTION...: their names in cmake/packages.txt, alternatives as one word, "a|b".
packages_of() {
  for section in "$@"; do
    sed -n "/^\[$section]/,/^\[/ { s/#.*//; s/[[:space:]]//g; /^\[/d; /^\$/d; p }" \
      "$root/cmake/packages.txt"
  done
}

# missing_packages SECTION...: those not installed, alternatives as one word where none of them is. Where there is no dpkg, CMake will
# say what it does not find.
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

# choose_packages WORD...: of each word "a|b" the first that apt knows, the first of all where it knows none. What apt knows is read
# by "apt-get update".
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

# install_command WORD...: what installs these packages.
install_command() {
  # shellcheck disable=SC2046  # one word a package
  echo apt-get install --no-install-recommends -y $(choose_packages "$@")
}

# install_packages SECTION...: returns 3 after naming the command where it may not install.
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

# One run at a time sets up: a second one waits here for the first.
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

# directory_of PRESET: the tests are built beside the program, from the same objects.
directory_of() {
  case $1 in
  test) echo "$root/build/release" ;;
  *) echo "$root/build/$1" ;;
  esac
}

# configure_preset PRESET: where that is not done already.
configure_preset() {
  directory=$(directory_of "$1")
  cache=$directory/CMakeCache.txt
  # A build belongs to the place where it was made.
  if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf "$directory"
  fi
  mkdir -p "$directory" || return 1
  if [ -f "$directory/build.ninja" ]; then
    # A build with the tests has the program too.
    [ "$1" = release ] || grep -qx 'BUILD_TESTING:BOOL=ON' "$cache" && return 0
  fi
  (cd "$root" && quietly "$directory/configure.log" cmake --preset "$1")
}

# needs_work PRESET TARGET: whether building it would do anything.
needs_work() {
  ! cmake --build "$(directory_of "$1")" --target "$2" -- -n 2>/dev/null </dev/null | grep -q 'no work to do'
}

# build_preset PRESET [TARGET]: configures where needed and builds.
build_preset() {
  configure_preset "$1" || return 1
  directory=$(directory_of "$1")
  with_progress "building ${2:-$1}" "$directory/build.log" \
    cmake --build "$directory" ${2:+--target "$2"}
}
