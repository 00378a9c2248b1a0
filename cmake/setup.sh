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

# packages_of SECTION...: their names in cmake/packages.txt.
packages_of() {
  for section in "$@"; do
    sed -n "/^\[$section]/,/^\[/ { s/#.*//; s/[[:space:]]*\$//; /^\[/d; /^\$/d; p }" \
      "$root/cmake/packages.txt"
  done
}

# missing_packages SECTION...: those not installed. Where there is no dpkg, CMake will say what it does not find.
missing_packages() {
  command -v dpkg-query >/dev/null 2>&1 || return 0
  wanted=$(packages_of "$@")
  # shellcheck disable=SC2086  # one word a package
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' $wanted 2>/dev/null |
    sed -n 's/ installed$//p')
  for package in $wanted; do
    printf '%s\n' "$installed" | grep -qxF -e "$package" || printf '%s\n' "$package"
  done
}

# install_packages SECTION...: returns 3 after naming the command where it may not install.
install_packages() {
  missing=$(missing_packages "$@" | tr '\n' ' ')
  missing=${missing% }
  [ -n "$missing" ] || return 0
  command="apt-get install --no-install-recommends -y $missing"
  if [ "$(id -u)" = 0 ]; then
    become=
  elif command -v sudo >/dev/null 2>&1; then
    become=sudo
  else
    say "These packages are missing and only root may install them. Run this as root, then try again:"
    say "  apt-get update && $command"
    return 3
  fi
  say "installing $missing ..."
  for step in "apt-get update" "$command"; do
    # shellcheck disable=SC2086
    quietly "$root/build/packages.log" $become env DEBIAN_FRONTEND=noninteractive $step \
      -o DPkg::Lock::Timeout=300 && continue
    say "Install them yourself, then try again: apt-get update && $command"
    return 3
  done
}

# One run at a time sets up: a second one waits here for the first.
locked() {
  mkdir -p "$root/build" || return 1
  (
    if command -v flock >/dev/null 2>&1; then flock 9; fi
    "$@"
  ) 9>"$root/build/.lock"
}

# needs_work PRESET: whether building it would do anything.
needs_work() {
  ! cmake --build "$root/build/$1" -- -n 2>/dev/null </dev/null | grep -q 'no work to do'
}

# build_preset PRESET [TARGET]: configures where needed and builds.
build_preset() {
  directory=$root/build/$1
  cache=$directory/CMakeCache.txt
  # A build belongs to the place where it was made.
  if [ -f "$cache" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$cache"; then
    rm -rf "$directory"
  fi
  mkdir -p "$directory" || return 1
  if [ ! -f "$directory/build.ninja" ]; then
    (cd "$root" && quietly "$directory/configure.log" cmake --preset "$1") || return 1
  fi
  quietly "$directory/build.log" cmake --build "$directory" ${2:+--target "$2"}
}
