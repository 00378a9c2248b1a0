#!/bin/sh
# tests/chroots/package.sh SUITE takes the packages that a Debian of this name (bookworm, trixie)
# makes. It installs them on another Debian that has neither the sources nor git, and uses them
# there as a student and a programmer do. tests/chroots/fresh.sh has left the packages of this
# commit in build/chroots, or the script builds them.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.." && pwd -P)
. "$root/cmake/setup.sh"
. "$root/tests/chroots/chroot.sh"

suite=$1
chroot=$root/build/chroots/$suite
kept=$root/build/chroots/$suite-packages

if [ "$(cat "$kept/commit" 2>/dev/null)" != "$(git -C "$root" rev-parse HEAD)" ]; then
  say "package: building it on $suite ..."
  bare_chroot "$suite" "$chroot" git
  clone_into "$chroot"
  keep_packages "$chroot" "$suite"
fi

say "package: installing it on $suite ..."
bare_chroot "$suite" "$chroot"
mkdir "$chroot/root/trial"
cp "$kept"/*.deb "$kept"/*.tar.gz "$root/images/golden/readme.png" "$root/tests/chroots/trial.sh" "$chroot/root/trial"
cp -r "$root/tests/install/consumer" "$chroot/root/trial"
status=0
in_chroot "$chroot" "sh -eux /root/trial/trial.sh" >"$root/build/chroots/$suite-trial.log" 2>&1 || status=$?
if [ "$status" != 0 ]; then tail -n 60 "$root/build/chroots/$suite-trial.log" >&2; fi
rm -rf --one-file-system "$chroot"
exit "$status"
