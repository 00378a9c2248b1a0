#!/bin/sh
# Makes the golden images anew. Usage: make.sh PROGRAM [FILE...]; without FILE, all of them. The file zlib-version has to name the
# zlib that PROGRAM compresses them with (docs/diff.md).
set -eu
program=$(realpath "$1")
shift
cd "$(dirname "$0")"
tab=$(printf '\t')
grep -v '^#' commands.txt | while IFS="$tab" read -r file arguments; do
  case " ${*:-$file} " in
    *" $file "*)
      # shellcheck disable=SC2086  # the arguments are words without blanks in them
      "$program" $arguments -o "$file" </dev/null || [ $? = 1 ] ;; # 1: diff found the difference to show
  esac
done
