#!/bin/sh
# compare.sh FOLDER PROGRAM OTHER... runs the cases of cases.sh with a program and with another one.
# The command of the other one may have several words, such as
# "qemu-aarch64-static -L root glassbox". The script compares every byte that they write into files,
# the output of `step`, and the exit codes. FOLDER is made again and keeps both results. The script
# prints which cases differ and how many are the same; its exit code is 1 if any differs.
set -eu

here=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd -P)
golden=$(CDPATH='' cd -- "$here/../../images/golden" && pwd -P)
mkdir -p "$1"
folder=$(CDPATH='' cd -- "$1" && pwd -P)
program=$2
shift 2
tab=$(printf '\t')

# run FOLDER COMMAND... runs one case. Its exit code goes to the file `code`. If its standard output
# is data, it goes to the file `printed`.
run() {
  cd "$1"
  shift
  code=0
  "$@" >said 2>complaints </dev/null || code=$?
  echo "$code" >code
  rm -f printed
  case " $* " in *" step "*) cp said printed ;; esac
  rm -f said
}

# Prints the files of a folder with the checksums of their contents.
sums() {
  (cd "$1" && find . -type f ! -name complaints -exec cksum {} + | sort)
}

for side in one other; do
  rm -rf "${folder:?}/$side"
  mkdir "$folder/$side"
  # Links are not used here, because a program that fails could write through them.
  cp -R "$golden"/* "$folder/$side"
done

"$here/cases.sh" >"$folder/cases"
same=0
different=0
while IFS="$tab" read -r name arguments; do
  # shellcheck disable=SC2086  # the arguments are words without blanks in them
  { (run "$folder/one" "$program" $arguments) && (run "$folder/other" "$@" $arguments); }
  if [ "$(sums "$folder/one")" = "$(sums "$folder/other")" ] && [ "$(cat "$folder/one/code")" -le 1 ]; then
    same=$((same + 1))
  else
    different=$((different + 1))
    echo "$name: glassbox $arguments"
    sums "$folder/one" >"$folder/sums-one"
    sums "$folder/other" >"$folder/sums-other"
    diff "$folder/sums-one" "$folder/sums-other" || :
    cat "$folder/one/complaints" "$folder/other/complaints"
  fi
  # A difference is reported only once.
  for side in one other; do
    find "$folder/$side" -type f \( -name '*-made.png' -o -name '*-staged.png' -o -name '*-scalar.png' -o -name '*-trace.*' \) -delete
  done
done <"$folder/cases"

echo "$same cases are the same, $different differ"
[ "$different" = 0 ] && [ "$same" -gt 0 ]
