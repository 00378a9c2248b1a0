#!/bin/sh
# Makes the golden images again. Usage: make.sh PROGRAM [FILE...]. Without FILE it makes all of
# them. The file zlib-version must name the zlib with which PROGRAM compresses them (docs/diff.md).
set -eu
program=$(realpath "$1")
shift
cd "$(dirname "$0")"
tab=$(printf '\t')
grep -v '^#' commands.txt | while IFS="$tab" read -r file arguments; do
  case " ${*:-$file} " in
    *" $file "*)
      # shellcheck disable=SC2086  # the arguments are words without blanks in them
      "$program" $arguments -o "$file" </dev/null || [ $? = 1 ] ;; # 1: a difference is found
  esac
done
