#!/bin/sh
# make_sysroot.sh FOLDER PACKAGE...: FOLDER gets the libraries of a 64-bit ARM machine, of the Debian that this machine has. Only
# extracted, no program of them is run. Takes half a minute and the network; FOLDER is there whole or not at all.
set -eu

folder=$1
shift
release=$(. /etc/os-release && echo "$VERSION_CODENAME")
packages=$(printf '%s,' "$@")

rm -rf "$folder" "$folder.next"
mmdebstrap --architectures=arm64 --variant=extract --include="${packages%,}" "$release" "$folder.next"

# A link to /usr/lib/x means this machine's to whoever follows it here: it shall name the same file from where it stands.
find "$folder.next" -type l -lname '/*' | while read -r link; do
  ln -sfnr "$folder.next$(readlink "$link")" "$link"
done
mv "$folder.next" "$folder"
