# These shell functions of tests/chroots make a bare Debian, and run commands in it. The file is
# sourced after cmake/setup.sh, with $root set to the top of the clone.

# Prints why no chroot can be made here, or nothing if one can.
why_no_chroots() {
  if [ "$(id -u)" != 0 ]; then
    echo "only root may make them"
  elif ! command -v mmdebstrap >/dev/null 2>&1; then
    echo "no mmdebstrap"
  elif ! unshare --mount --pid --fork true 2>/dev/null; then
    echo "no namespaces for processes and mounts here"
  fi
}

# bare_chroot SUITE DIRECTORY [PACKAGE,...] makes a chroot with Debian's essential packages, apt,
# and the named packages. It removes what was there before.
bare_chroot() {
  rm -rf --one-file-system "$2" || return 1
  mkdir -p "$(dirname "$2")"
  quietly "$2.log" mmdebstrap --mode=root --variant=apt --include="ca-certificates${3:+,$3}" "$1" "$2"
}

# in_chroot DIRECTORY COMMAND runs a command as root, with /proc and the devices that mmdebstrap
# makes, and without /dev/pts, as in many containers. The command's mounts and processes end with
# it.
in_chroot() {
  unshare --mount --pid --fork --kill-child --mount-proc --root="$1" /usr/bin/env -i \
    HOME=/root LANG=C.UTF-8 TERM=dumb PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    /bin/sh -c "$2" </dev/null
}

# with_times copies lines, and puts before each the seconds since the start.
with_times() {
  begun=$(date +%s)
  while IFS= read -r line; do
    printf '%6d s  %s\n' $(($(date +%s) - begun)) "$line"
  done
}

# without_steps removes lines about the progress of a build from lines with times.
without_steps() {
  grep -v '^ *[0-9]* s    building '
}

# clone_into DIRECTORY makes the checked-out commit available, as a user clones it.
clone_into() {
  git clone -q --no-hardlinks "$root" "$1/root/glassbox"
}

# keep_packages DIRECTORY SUITE builds the packages in the clone of the chroot, and keeps them with
# the name of their commit.
keep_packages() {
  kept=$root/build/chroots/$2-packages
  in_chroot "$1" 'cd /root/glassbox && root=$PWD && . cmake/setup.sh && install_packages needed package &&
    build_preset release packages' >&2 || return 1
  rm -rf "$kept"
  mkdir -p "$kept"
  mv "$1"/root/glassbox/build/release/glassbox*.deb "$1"/root/glassbox/build/release/glassbox*.tar.gz "$kept" || return 1
  git -C "$root" rev-parse HEAD >"$kept/commit"
}
