#!/bin/sh
# make_sysroot.sh FOLDER PACKAGE... fills FOLDER with the libraries of a 64-bit ARM machine, from
# the Debian version of this machine. It only extracts them, and runs none of their programs. It
# takes half a minute and needs the network. FOLDER is complete or does not exist.
set -eu

folder=$1
shift
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
packages=$(printf '%s,' "$@")

rm -rf "$folder" "$folder.next"
mmdebstrap --architectures=arm64 --variant=extract --include="${packages%,}" "$release" "$folder.next"

# On this machine, a link to /usr/lib/x leads to this machine's /usr/lib/x. The link is changed so
# that it leads to the file in FOLDER.
find "$folder.next" -type l -lname '/*' | while read -r link; do
  ln -sfnr "$folder.next$(readlink "$link")" "$link"
done
mv "$folder.next" "$folder"
