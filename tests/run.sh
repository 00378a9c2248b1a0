#!/bin/sh
# Runs the tests: ./glassbox test [--all | PART ...]. The last line is "N passed, N failed", and
# ", N skipped" if parts were left out. The exit code is 0 if nothing failed.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$(readlink -f -- "$0")")/.." && pwd -P)
. "$root/cmake/setup.sh"

fuzz_seconds=60 # for each target of --all
passed=0
failed=0
skipped=0

usage() {
  cat <<'TEXT'
usage: ./glassbox test [--all | PART ...]

Builds the tests with g++, every warning an error, and runs them; then
the format of the sources, and some tests of each folder under the
sanitizers. A run has a share of the faults that are planted in labs
and engines, of the labs that draw and of the hostile submissions:
another share every day, with some of each kind. SEED=N ./glassbox test
repeats that of day N; a run prints its seed. --all adds what needs
more tools and time: all tests with clang++, without optimisation and
under the sanitizers, ThreadSanitizer, every planted fault of the labs,
every one of the engines against every extreme case, 100,000 small
scenes by each way of drawing, thousands of pictures by each
instruction set and number of threads, a minute of each fuzzer, the
HTML pages in a browser, the pages that Doxygen makes of the headers,
what a 64-bit ARM machine draws, clang-tidy, and README's two commands
and the packages on bare Debians 12 and 13 (root only, hours).

Parts, for one of them again:
  test           all tests, g++ -O3     sanitize-some  a few, sanitized
  format         of the sources         sanitize       all, sanitized
  debug          all tests, g++ -O0     threads        ThreadSanitizer
  clang++        all tests, clang++     fuzz           a minute of each
  faults         all of the labs        api            Doxygen's pages
  mutants        all of the engines     browser        the HTML pages
  long-pages     slow lines of docs     tidy           clang-tidy
  scenes         100,000 small scenes   same-bytes     what pictures give
  arm64          the bytes of ARM       chroots        bare Debians 12, 13
  package        installed on them
TEXT
}

# count NAME STATUS counts one check that is not a Catch2 test.
count() {
  if [ "$2" = 0 ]; then
    passed=$((passed + 1))
    say "  $1: passed"
  else
    failed=$((failed + 1))
    say "  $1: FAILED"
  fi
}

skip() {
  skipped=$((skipped + 1))
  say "skipped: $*"
}

# run_suites PRESET WORDS [TARGET] builds the preset, or one target of it, and runs its suites.
run_suites() {
  say "$2: building ..."
  if ! build_preset "$1" "${3-}"; then
    count "$2: build" 1
    return 0
  fi
  say "$2: testing ..."
  directory=$(directory_of "$1")
  rm -f "$directory/Testing/Temporary/LastTest.log"
  # A test that never ends is stopped. Sanitizers slow everything down, and the longest suite takes
  # a quarter of an hour with them.
  limit=900
  if [ "$1" = sanitize ]; then limit=3600; fi
  status=0
  (cd "$directory" && ctest --output-on-failure --timeout "$limit" -j "$(getconf _NPROCESSORS_ONLN)") \
    >"$directory/test.log" 2>&1 </dev/null || status=$?
  if [ "$status" != 0 ]; then tail -n 200 "$directory/test.log" >&2; fi
  log=$directory/Testing/Temporary/LastTest.log
  if [ ! -f "$log" ]; then
    count "$2: ctest" 1
    return 0
  fi
  awk -f "$root/tests/summarise.awk" "$log" >"$directory/summary"
  # shellcheck disable=SC2046  # three numbers
  set -- "$2" $(head -n 1 "$directory/summary")
  if [ "$status" != 0 ] && [ "$3" = 0 ]; then set -- "$1" "$2" 1 "$4"; fi
  passed=$((passed + $2))
  failed=$((failed + $3))
  skipped=$((skipped + $4))
  sed '1d; s/^/  /' "$directory/summary" >&2
  say "$1: $2 passed, $3 failed, $4 skipped"
}

have() { command -v "$1" >/dev/null 2>&1; }

# Runs the tile engine's tests under ThreadSanitizer. It must find the planted race, and no other.
run_threads() {
  say "threads: building ..."
  if ! build_preset thread test_render; then
    count "threads: build" 1
    return 0
  fi
  say "threads: testing ..."
  program=$root/build/thread/tests/render/test_render
  log=$root/build/thread/test.log
  status=0
  TSAN_OPTIONS="halt_on_error=1 exitcode=66" "$program" "[tile]" >"$log" 2>&1 </dev/null || status=$?
  if [ "$status" != 0 ]; then tail -n 100 "$log" >&2; fi
  count "threads: the tile engine" "$status"
  status=0
  TSAN_OPTIONS="halt_on_error=1 exitcode=66" "$program" "[.planted-race]" >"$log" 2>&1 </dev/null || status=$?
  if [ "$status" = 66 ]; then status=0; else status=1; fi
  count "threads: a planted race is found" "$status"
}

# Each fuzzer starts from a copy of its corpus. Its findings go to build/fuzz.
run_fuzzers() {
  have clang++ || { skip "fuzzers (no clang++)"; return 0; }
  say "fuzzers: building ..."
  if ! build_preset fuzz fuzzers; then
    count "fuzzers: build" 1
    return 0
  fi
  for fuzzer in "$root"/build/fuzz/tests/fuzz/fuzz_*; do
    [ -f "$fuzzer" ] && [ -x "$fuzzer" ] || continue
    name=${fuzzer##*/fuzz_}
    say "fuzzing $name for $fuzz_seconds s ..."
    found=$root/build/fuzz/found-$name
    mkdir -p "$found/corpus"
    status=0
    (cd "$found" && "$fuzzer" -max_total_time="$fuzz_seconds" -timeout=20 -rss_limit_mb=2048 \
      corpus "$root/tests/fuzz/corpus/$name") >"$found/log" 2>&1 </dev/null || status=$?
    if [ "$status" != 0 ]; then tail -n 40 "$found/log" >&2; fi
    count "fuzz $name" "$status"
  done
}

# Tests the pages of diff --html and inspect in Chromium. playwright-core, which drives Chromium,
# goes to build/browser, and so do the screenshots.
run_browser() {
  have chromium || locked install_packages browser || true
  { have node && have npm; } || locked install_packages node || true
  for command in chromium node npm; do
    have "$command" || { skip "browser (no $command)"; return 0; }
  done
  build_preset test || { count "browser: build" 1; return 0; }
  say "browser: testing ..."
  directory=$root/build/browser
  mkdir -p "$directory"
  cp "$root"/tests/browser/* "$directory"
  if ! (cd "$directory" && npm install --no-audit --no-fund) >"$directory/npm.log" 2>&1 </dev/null; then
    tail -n 5 "$directory/npm.log" >&2
    skip "browser (npm could not install playwright-core)"
    return 0
  fi
  status=0
  (cd "$directory" && CHROMIUM=$(command -v chromium) node run.mjs "$root/build/release/app/glassbox" pages) \
    >"$directory/log" 2>&1 </dev/null || status=$?
  if [ "$status" != 0 ]; then tail -n 60 "$directory/log" >&2; fi
  count "browser" "$status"
}

# The sources have a format that clang-format 14 and 19 both leave unchanged. 14 is the default of
# Debian 12, and 19 is the default of Debian 13.
check_format() {
  checked=
  for formatter in clang-format-14 clang-format-19 clang-format; do
    have "$formatter" || continue
    version=$("$formatter" --version | sed -n 's/.* version \([0-9]*\)\..*/\1/p')
    case $version in 14 | 19) ;; *) continue ;; esac
    case " $checked " in *" $version "*) continue ;; esac
    checked="$checked $version"
    status=0
    find "$root" \( -path "$root/build" -o -path "$root/.git" \) -prune -o \
      \( -name '*.h' -o -name '*.cpp' \) -exec "$formatter" --dry-run -Werror {} + >&2 || status=$?
    count "format, by clang-format $version" "$status"
  done
  [ -n "$checked" ] || skip "format (no clang-format 14 or 19)"
}

# run_long NAME SUITE TAG WHAT [FOLDER] runs cases that take too long for the daily tests. SUITE is
# in tests/FOLDER.
run_long() {
  build_preset test "test_$2" || { count "$1: build" 1; return 0; }
  say "$1: running ..."
  log=$root/build/$1.log
  status=0
  "$(directory_of test)/tests/${5:-$2}/test_$2" "$3" >"$log" 2>&1 </dev/null || status=$?
  if [ "$status" != 0 ]; then tail -n 60 "$log" >&2; fi
  count "$1: $4" "$status"
}

# Doxygen must make the library's pages (docs/api.md) without a warning. They must contain the
# headers' comments, and no link may be broken.
run_doxygen() {
  have doxygen || { skip "API pages (no doxygen)"; return 0; }
  say "API pages: writing ..."
  rm -rf "$root/build/api"
  log=$root/build/doxygen.log
  status=0
  (cd "$root" && doxygen docs/Doxyfile) >"$log" 2>&1 </dev/null || status=$?
  pages=$root/build/api
  grep -q 'One way of looking at a scene' "$pages/structglassbox_1_1View.html" >>"$log" 2>&1 || status=1
  grep -ho 'href="[^"#:]*"' "$pages"/*.html | sed 's/^href="//; s/"$//' | sort -u >"$root/build/api-links"
  while read -r link; do
    [ -e "$pages/$link" ] || { echo "linked, but not there: $link" >>"$log"; status=1; }
  done <"$root/build/api-links"
  if [ "$status" != 0 ]; then tail -n 60 "$log" >&2; fi
  count "API pages" "$status"
}

# The program is cross-compiled for 64-bit ARM and run by qemu. It must give the same bytes as on
# this machine (docs/building.md).
run_arm64() {
  locked install_packages arm64 || true
  for command in aarch64-linux-gnu-g++ qemu-aarch64-static mmdebstrap; do
    have "$command" || { skip "arm64 (no $command)"; return 0; }
  done
  sysroot=$root/build/arm64-root
  if [ ! -d "$sysroot" ]; then
    say "arm64: fetching its libraries ..."
    # The libraries are for ARM, and the programs are for this machine.
    # shellcheck disable=SC2046  # one word a package
    if ! "$root/tests/arm64/make_sysroot.sh" "$sysroot" \
      $(packages_of needed tests | grep -E '^lib|-dev$|^catch2$') >"$root/build/arm64-root.log" 2>&1 </dev/null; then
      tail -n 5 "$root/build/arm64-root.log" >&2
      skip "arm64 (mmdebstrap cannot run here: no network, or not allowed)"
      return 0
    fi
  fi
  say "arm64: building ..."
  build_preset release glassbox_program || { count "arm64: build of this machine's program" 1; return 0; }
  for target in glassbox_program test_render; do
    build_preset arm64 "$target" || { count "arm64: build of $target" 1; return 0; }
  done
  say "arm64: comparing ..."
  directory=$root/build/arm64
  log=$directory/compare.log
  status=0
  "$root/tests/arm64/compare.sh" "$directory/compared" "$root/build/release/app/glassbox" \
    qemu-aarch64-static -L "$sysroot" "$directory/app/glassbox" >"$log" 2>&1 </dev/null || status=$?
  tail -n 60 "$log" >&2
  count "arm64: the same bytes" "$status"
  status=0
  SEEDS=0-999 qemu-aarch64-static -L "$sysroot" "$directory/tests/render/test_render" "[.small-scenes]" \
    >"$log" 2>&1 </dev/null || status=$?
  if [ "$status" != 0 ]; then tail -n 60 "$log" >&2; fi
  count "arm64: 1,000 small scenes" "$status"
}

# These checks find bugs, and none is about style: .clang-tidy.
run_tidy() {
  have clang-tidy || { skip "clang-tidy (there is no such program)"; return 0; }
  say "clang-tidy: reading ..."
  directory=$(directory_of tidy)
  configure_preset tidy || { count "clang-tidy: configure" 1; return 0; }
  log=$directory/tidy.log
  status=0
  find "$root" \( -path "$root/build" -o -path "$root/.git" -o -path "$root/tests" -o -path "$root/labs/[0-9]*" \) -prune \
    -o -name '*.cpp' -print0 | xargs -0 -n 4 -P "$(getconf _NPROCESSORS_ONLN)" \
    clang-tidy --quiet -p "$directory" >"$log" 2>/dev/null || status=$?
  if [ "$status" != 0 ]; then grep -E 'warning:|error:' "$log" | sort -u | head -n 60 >&2; fi
  count "clang-tidy" "$status"
}

# run_in_chroots PART SCRIPT runs a script of tests/chroots for each Debian version that is known to
# work.
run_in_chroots() {
  . "$root/tests/chroots/chroot.sh"
  why=$(why_no_chroots)
  if [ -n "$why" ]; then
    skip "$1 ($why)"
    return 0
  fi
  for suite in bookworm trixie; do
    status=0
    "$root/tests/chroots/$2.sh" "$suite" || status=$?
    count "$1: $suite" "$status"
  done
}

plain="test format sanitize-some"
all="test format debug clang++ sanitize threads faults mutants scenes same-bytes fuzz browser long-pages api arm64 tidy chroots package"

run_part() {
  case $1 in
  test) run_suites test "g++ -O3" ;;
  format) check_format ;;
  sanitize-some) run_suites sanitize-some "sanitizers, some tests of each folder" test_sanitized ;;
  debug) run_suites debug "g++ -O0" ;;
  clang++) if have clang++; then run_suites clang "clang++ -O3"; else skip "clang++ -O3 (no clang++)"; fi ;;
  sanitize) run_suites sanitize "sanitizers" ;;
  threads) run_threads ;;
  # The daily tests run a share of these: one in eight of the labs' faults, one in 56 of the mutants
  # of their solutions, and one in three or four of the cases that need a program of their own.
  faults)
    run_long faults all_labs "[.faults]" "all that are planted in the labs" labs/framework
    run_long faults-mutation all_labs "[.mutation]" "every mutant of the solutions" labs/framework
    run_long faults-drawn lab_drawings "[.faults]" "every lab draws and is measured" labs/drawing
    run_long faults-graded lab_grading "[.faults]" "every hostile kind in every sandbox" labs/grading
    ;;
  # Each fault is tried with every extreme case. (The daily tests try one fault in four, and only
  # with the case that is named for it.)
  mutants) run_long mutants mutants "[.page]" "the page is what comes of it" ;;
  # This part draws all small scenes, and the daily tests draw the first of them.
  scenes) run_long scenes render "[.small-scenes]" "100,000 small ones" ;;
  # This part uses more scenes than the daily tests, for everything that is computed from pictures.
  same-bytes) run_long same-bytes same_bytes "[.same-bytes]" "thousands of pictures in every way" ;;
  fuzz) run_fuzzers ;;
  browser) run_browser ;;
  long-pages) run_long long-pages docs "[.long]" "the lines of docs that take long" ;;
  api) run_doxygen ;;
  arm64) run_arm64 ;;
  tidy) run_tidy ;;
  # These parts run README's two commands, and install the packages in place of them.
  chroots) run_in_chroots chroots fresh ;;
  package) run_in_chroots package package ;;
  esac
}

is_part() {
  case " $all $plain " in *" $1 "*) ;; *) return 1 ;; esac
}

parts=
for word in "$@"; do
  case $word in
  --all) parts=$all ;;
  --help | -h)
    usage
    exit 0
    ;;
  *)
    is_part "$word" || { usage >&2; exit 2; }
    parts="$parts $word"
    ;;
  esac
done

# SEED decides which share of the planted faults this run has (tests/support/daily_share.h).
SEED=${SEED:-$(($(date +%s) / 86400))}
case $SEED in *[!0-9]* | ??????????????????*)
  say "SEED is '$SEED', which is not a number of 1 to 17 digits: give one, or none"
  exit 2
  ;;
esac
export SEED
say "planted faults: the share of SEED=$SEED"

locked install_packages needed tests || exit
if [ -n "$parts" ]; then
  locked install_packages needed tests all || say "going on without what is missing"
fi
for part in ${parts:-$plain}; do run_part "$part"; done

if [ "$skipped" = 0 ]; then
  echo "$passed passed, $failed failed"
else
  echo "$passed passed, $failed failed, $skipped skipped"
fi
[ "$failed" = 0 ] && [ "$passed" -gt 0 ]
