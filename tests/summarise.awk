# From the log of ctest: one line "passed failed skipped", then the name of each suite that failed, and each reason why tests
# were skipped.
#
# A suite counts as many tests as Catch2 says that it has, less those that said "skipped: REASON -- TEST" (tests/support/skip.h),
# which Catch2 counts as passed. What is no Catch2 suite, or ended before its summary, counts as one.
function close_test() {
  if (name == "") return
  if (ok && bad > 0) ok = 0
  if (!ok && bad == 0) bad = 1
  if (bad > 0) failures[++failure_count] = name (absent ? " (its program was not built)" : "")
  if (ok && good == 0) good = 1
  if (left_out > good) left_out = good
  passed += good - left_out
  failed += bad
  skipped += left_out
  name = ""
}
/^[0-9]+\/[0-9]+ Test: / {
  close_test()
  name = $3; good = bad = ok = absent = left_out = 0
}
/^Command: ""$/ { absent = 1 } # a program that was not built; ctest goes on to write "Test Passed."
/^All tests passed \(/ { for (i = 2; i <= NF; i++) if ($i ~ /^test$/) good += $(i - 1) }
/^test cases: / {
  for (i = 2; i <= NF; i++) {
    if ($i == "passed") good += $(i - 1)
    if ($i == "failed") bad += $(i - 1)
  }
}
/^ *skipped: / {
  sub(/^ *skipped: /, "")
  if (!((name, $0) in said)) { # a test case with sections says it in each
    said[name, $0] = 1
    left_out++
    sub(/ -- .*/, "")
    if (!($0 in tests)) reasons[++reason_count] = $0
    tests[$0]++
  }
}
# The second is said of a test that passes by what it prints (PASS_REGULAR_EXPRESSION).
/^Test (Passed\.|Pass Reason:)$/ { ok = !absent }
END {
  close_test()
  print passed + 0, failed + 0, skipped + 0
  for (i = 1; i <= failure_count; i++) print "failed: " failures[i]
  for (i = 1; i <= reason_count; i++) {
    count = tests[reasons[i]]
    print "skipped: " reasons[i] " (" count (count == 1 ? " test)" : " tests)")
  }
}
