#!/bin/sh
# Checks files of tolerances: check_sidecars.sh FILE.fuzzy ... Each must belong to a picture beside
# it, and glassbox must be able to read it. The hook glassbox-fuzzy of .pre-commit-hooks.yaml runs this.
# Ends with 1 if something is wrong, and with 2 if there is no glassbox.
set -eu

program=${GLASSBOX_PROGRAM:-glassbox}
if ! command -v "$program" >/dev/null; then
  echo "$program: there is no such program; install Glassbox, or name it in GLASSBOX_PROGRAM" >&2
  exit 2
fi

# In this folder, a copy of a picture has no sidecar. A copy by cat may be written over, even if the
# picture may not.
alone=$(mktemp -d)
trap 'rm -rf "$alone"' EXIT

# Whether glassbox can read the file as a picture.
is_picture() {
  cat "$1" >"$alone/picture" && "$program" diff "$alone/picture" "$alone/picture" >/dev/null 2>&1
}

# check PICTURE compares it with itself. It passes unless its sidecar is refused.
check() {
  "$program" diff "$1" "$1" >/dev/null || status=1
}

status=0
for sidecar in "$@"; do
  case $sidecar in /*) ;; *) sidecar=./$sidecar ;; esac
  name=${sidecar%.fuzzy}
  found=
  # teapot.png.fuzzy belongs to teapot.png. teapot.fuzzy belongs to teapot.png and teapot.pfm, and
  # not to teapot.heat.png, whose own is teapot.heat.fuzzy.
  for picture in "$name" "$name".*; do
    case ${picture#"$name"} in .*.* | .fuzzy) continue ;; esac
    if [ ! -f "$picture" ] || ! is_picture "$picture"; then continue; fi
    found=yes
    check "$picture"
  done
  if [ -z "$found" ]; then
    echo "$sidecar: belongs to no picture that can be read; name it after its picture, or delete it" >&2
    status=1
  fi
done
exit "$status"
