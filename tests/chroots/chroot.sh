# Shell functions of tests/chroots: a Debian with nothing on it, and commands in it. Sourced with $root set to the top of the clone,
# after cmake/setup.sh.

# Says why no chroot can be made here; nothing: it can.
why_no_chroots() {
  if [ "$(id -u)" != 0 ]; then
    echo "only root may make them"
  elif ! command -v mmdebstrap >/dev/null 2>&1; then
    echo "no mmdebstrap"
  elif ! unshare --mount --pid --fork true 2>/dev/null; then
    echo "no namespaces for processes and mounts here"
  fi
}

# bare_chroot SUITE DIRECTORY [PACKAGE,...]: Debian's essential packages, apt, and those named. Whatever was there is gone.
bare_chroot() {
  rm -rf --one-file-system "$2" || return 1
  mkdir -p "$(dirname "$2")"
  quietly "$2.log" mmdebstrap --mode=root --variant=apt --include="ca-certificates${3:+,$3}" "$1" "$2"
}

# in_chroot DIRECTORY COMMAND: as root, with /proc and the devices that mmdebstrap makes, and without /dev/pts, as in many containers.
# Mounts and processes of it end with the command.
in_chroot() {
  unshare --mount --pid --fork --kill-child --mount-proc --root="$1" /usr/bin/env -i \
    HOME=/root LANG=C.UTF-8 TERM=dumb PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    /bin/sh -c "$2" </dev/null
}

# with_times: copies lines, each behind the seconds since it was started.
with_times() {
  begun=$(date +%s)
  while IFS= read -r line; do
    printf '%6d s  %s\n' $(($(date +%s) - begun)) "$line"
  done
}

# without_steps: of lines with times, those that are not about a build's progress.
without_steps() {
  grep -v '^ *[0-9]* s    building '
}

# clone_into DIRECTORY: the commit that is checked out, as a user clones it.
clone_into() {
  git clone -q --no-hardlinks "$root" "$1/root/glassbox"
}

# keep_packages DIRECTORY SUITE: builds the packages in the clone of the chroot, and keeps them with the name of their commit.
keep_packages() {
  kept=$root/build/chroots/$2-packages
  in_chroot "$1" 'cd /root/glassbox && root=$PWD && . cmake/setup.sh && install_packages needed package &&
    build_preset release packages' >&2 || return 1
  rm -rf "$kept"
  mkdir -p "$kept"
  mv "$1"/root/glassbox/build/release/glassbox*.deb "$1"/root/glassbox/build/release/glassbox*.tar.gz "$kept" || return 1
  git -C "$root" rev-parse HEAD >"$kept/commit"
}
