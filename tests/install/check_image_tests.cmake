# This file configures tests/install/image_tests, which calls glassbox_add_image_test, against the
# installed package, and runs its tests: without golden images, with approval, with what differs. It
# then makes wrong calls. check_install.cmake includes it.
set(source "${work}/image tests")
set(build "${work}/image tests build")
file(REMOVE_RECURSE ${source} ${build})
file(COPY ${clone}/tests/install/image_tests/ DESTINATION ${source})

function(configure)
  run(${CMAKE_COMMAND} -S ${source} -B ${build} -G ${generator} -D CMAKE_PREFIX_PATH=${prefix} ${ARGN})
endfunction()

# run_ctest(ENVIRONMENT... EXPECT NUMBER OF FAILURES, TEXT...) runs all tests. The output has each text.
function(run_ctest)
  cmake_parse_arguments(PARSE_ARGV 0 RUN "" "" "EXPECT")
  list(POP_FRONT RUN_EXPECT failures)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env ${RUN_UNPARSED_ARGUMENTS} ${CMAKE_CTEST_COMMAND} --output-on-failure
    WORKING_DIRECTORY ${build} OUTPUT_VARIABLE output ERROR_VARIABLE output)
  foreach(says "${failures} tests failed out of 4" ${RUN_EXPECT})
    string(FIND "${output}" "${says}" at)
    if(at EQUAL -1)
      message(FATAL_ERROR "ctest with ${RUN_UNPARSED_ARGUMENTS} does not say '${says}':\n${output}")
    endif()
  endforeach()
endfunction()

configure()
file(MAKE_DIRECTORY "${build}/a folder/out")
run_ctest(EXPECT 4 "there is no golden image ${source}/golden/cube.png yet" "page: ${build}/golden-failures/cube.html"
  "run the test again with GLASSBOX_APPROVE=1")
run_ctest(GLASSBOX_APPROVE=1 CI=true EXPECT 4 "CI is set")
if(EXISTS ${source}/golden)
  message(FATAL_ERROR "golden images were approved with CI set")
endif()
run_ctest(GLASSBOX_APPROVE=1 EXPECT 0)
foreach(picture cube "my picture" tolerant options)
  expect_file("${source}/golden/${picture}.png")
endforeach()
run_ctest(EXPECT 0)
run_ctest(GLASSBOX_PROGRAM=/nowhere EXPECT 4 "/nowhere cannot compare" "GLASSBOX_PROGRAM")

# Another picture fails, except where it is allowed to differ.
configure("-DBACKGROUND=1,0,0")
run_ctest(EXPECT 2 "pixels differ, by up to 255/255, in 1 region; first (0, 0)" "heat map: ${build}/golden-failures/cube.heat.png"
  "heat map: ${build}/a folder/what fails/a folder/and a name.heat.png")
foreach(trace "golden-failures/cube.html" "golden-failures/cube.heat.png" "a folder/what fails/a folder/and a name.html")
  expect_file("${build}/${trace}")
endforeach()
run_ctest(GLASSBOX_FAILURES=${build}/elsewhere EXPECT 2 "page: ${build}/elsewhere/cube.html")
run_ctest(GLASSBOX_APPROVE=1 EXPECT 0)
run_ctest(EXPECT 0)
if(EXISTS "${build}/golden-failures/cube.html")
  message(FATAL_ERROR "the test passes, and the page of its failure is still there")
endif()

# try(CALL ENVIRONMENT...) configures a project with this call, and runs its test in this
# environment. It sets result and output, and step to what came last: "configures" or "runs". The
# call is where the variables of find_package are not visible.
function(try call)
  file(REMOVE_RECURSE "${build} try")
  file(WRITE "${build} try/CMakeLists.txt" "cmake_minimum_required(VERSION 3.25)\nproject(try LANGUAGES NONE)
function(find)\nfind_package(glassbox REQUIRED COMPONENTS image_tests)\nendfunction()\nfind()\nenable_testing()\nglassbox_add_image_test(${call})\n")
  set(step configures)
  execute_process(COMMAND ${CMAKE_COMMAND} -S "${build} try" -B "${build} try" -G ${generator}
    -D CMAKE_PREFIX_PATH=${prefix} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result EQUAL 0)
    set(step runs)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env ${ARGN} ${CMAKE_CTEST_COMMAND} --output-on-failure
      WORKING_DIRECTORY "${build} try" RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  endif()
  string(REGEX REPLACE "[ \n]+" " " output "${output}")  # CMake breaks long lines
  foreach(variable step result output)
    set(${variable} "${${variable}}" PARENT_SCOPE)
  endforeach()
endfunction()

# run_wrong(CALL TEXT [STEP ENVIRONMENT...]): this step ("configures" unless it is given) fails with
# this text.
function(run_wrong call says)
  set(environment ${ARGN})
  set(expected configures)
  if(environment)
    list(POP_FRONT environment expected)
  endif()
  try("${call}" ${environment})
  string(FIND "${output}" "${says}" at)
  if(result EQUAL 0 OR at EQUAL -1 OR NOT step STREQUAL expected)
    message(FATAL_ERROR "glassbox_add_image_test(${call}) ${step}, ends with ${result} and does not say '${says}':\n${output}")
  endif()
endfunction()

set(right "NAME a COMMAND true OUTPUT a.png REFERENCE b.png")
run_wrong("COMMAND true OUTPUT a.png REFERENCE b.png" "NAME is missing")
run_wrong("NAME ../a COMMAND true OUTPUT a.png REFERENCE b.png" "NAME has a part \"..\"")
run_wrong("NAME a OUTPUT a.png REFERENCE b.png" "COMMAND is missing")
run_wrong("NAME a COMMAND true REFERENCE b.png" "OUTPUT is missing")
run_wrong("NAME a COMMAND true OUTPUT a.png" "REFERENCE is missing")
run_wrong("NAME a COMMAND true OUTPUT a.pfm REFERENCE b.png" "different extensions")
run_wrong("NAME a COMMAND true \"\" OUTPUT a.png REFERENCE b.png" "an empty argument")
run_wrong("twice ${right}" "it does not know \"twice\"")
run_wrong("${right} THRESHOLD" "there is no value for THRESHOLD")
run_wrong("${right} THRESHOLD 2" "THRESHOLD is \"2\"")
run_wrong("${right} MAX_DIFFERING few" "MAX_DIFFERING is \"few\"")
run_wrong("${right} FUZZY maxDifference=0-1;totalPixels=0-4" "FUZZY is \"maxDifference=0-1\"")
# These errors are found when the test runs.
run_wrong("${right}" "the command has not written" runs)
run_wrong("NAME a COMMAND false OUTPUT a.png REFERENCE b.png" "the command ended with 1" runs)
run_wrong("NAME a COMMAND /nowhere/at-all OUTPUT a.png REFERENCE b.png" "/nowhere/at-all" runs)
run_wrong("NAME a COMMAND true OUTPUT CMakeLists.txt REFERENCE CMakeLists.txt" "OUTPUT is REFERENCE itself" runs)
run_wrong("NAME a COMMAND cmake -E touch a.png OUTPUT a.png REFERENCE b.png OPTIONS --sise" "--sise" runs)

# The options of a test count in its approval, too. An alpha that is opaque everywhere is a
# difference only with --alpha strict, and an option that does not exist approves nothing.
set(rgb "P7\nWIDTH 1\nHEIGHT 1\nDEPTH 3\nMAXVAL 126\nTUPLTYPE RGB\nENDHDR\nAAA")
set(rgba "P7\nWIDTH 1\nHEIGHT 1\nDEPTH 4\nMAXVAL 126\nTUPLTYPE RGB_ALPHA\nENDHDR\nAAA~")
file(WRITE "${build}/golden.pam" "${rgb}")
file(WRITE "${build}/made.pam" "${rgba}")
set(strict_test "NAME a COMMAND \"${CMAKE_COMMAND}\" -E copy \"${build}/made.pam\" a.pam
  OUTPUT a.pam REFERENCE \"${build}/golden.pam\" OPTIONS --alpha strict")
run_wrong("${strict_test}" "the reference is RGB, the test RGBA" runs)
run_wrong("${strict_test} --sise" "--sise" runs GLASSBOX_APPROVE=1)
file(READ "${build}/golden.pam" kept)
if(NOT kept STREQUAL rgb)
  message(FATAL_ERROR "a slip in OPTIONS has replaced the golden image")
endif()
try("${strict_test}" GLASSBOX_APPROVE=1)
file(READ "${build}/golden.pam" approved)
if(NOT result EQUAL 0 OR NOT approved STREQUAL rgba)
  message(FATAL_ERROR "with --alpha strict, approval ends with ${result} and leaves\n${approved}\n${output}")
endif()
message("image tests of ctest: all as it should be")
