#!/bin/sh
# tests/chroots/fresh.sh SUITE runs README's two commands on a Debian of this name (bookworm,
# trixie) that has only git. Their lines appear on standard error, each with the seconds since its
# command began. The complete output is in build/chroots. Then the script builds the packages there,
# which tests/chroots/package.sh installs. It ends with 0 if everything passed.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/../.." && pwd -P)
. "$root/cmake/setup.sh"
. "$root/tests/chroots/chroot.sh"

suite=$1
chroot=$root/build/chroots/$suite
times=$root/build/chroots/$suite-times

# run_command COMMAND runs a command in the clone. The last line of its output says how it ended.
run_command() {
  say "$suite: $1"
  {
    status=0
    in_chroot "$chroot" "cd /root/glassbox && $1" 2>&1 || status=$?
    echo "ended with $status"
  } | with_times | tee -a "$times" | without_steps >&2
  tail -n 1 "$times" | grep -q 's  ended with 0$'
}

bare_chroot "$suite" "$chroot" git
: >"$times"
clone_into "$chroot"
failed=0
run_command ./glassbox || failed=1
run_command "./glassbox test" || failed=1
if [ "$failed" = 0 ]; then keep_packages "$chroot" "$suite" || failed=1; fi
rm -rf --one-file-system "$chroot"
exit "$failed"
