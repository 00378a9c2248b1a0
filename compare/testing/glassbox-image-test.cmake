# glassbox_add_image_test(NAME name COMMAND program [argument ...] OUTPUT picture REFERENCE golden
#   [WORKING_DIRECTORY folder] [COMMAND_EXPAND_LISTS]
#   [FUZZY ranges] [THRESHOLD t] [MAX_DIFFERING n|p%] [IGNORE_ANTIALIASING] [OPTIONS option ...]
#   [FAILURES folder] [LABELS label ...])
#
# Adds a test for ctest: COMMAND makes the picture OUTPUT, and `glassbox diff` compares it with the
# golden image REFERENCE. find_package(glassbox) includes this file.
#
# NAME, COMMAND, WORKING_DIRECTORY and COMMAND_EXPAND_LISTS are those of add_test. A relative OUTPUT
# is in the working directory, which is the current build directory unless it is given. A relative
# REFERENCE is in the current source directory. FUZZY, THRESHOLD, MAX_DIFFERING and
# IGNORE_ANTIALIASING are options of `glassbox diff`; OPTIONS has others of them, as one would write
# them. Where the pictures differ, FAILURES takes a heat map and a page: by default the folder that
# the environment variable GLASSBOX_FAILURES names, or golden-failures in the working directory.
# Their names begin with NAME. Tests that share the folder must have different names: a test deletes
# what an earlier test of its name left there.
#
# GLASSBOX_APPROVE=1 in ctest's environment makes the picture the golden image. This is refused where
# CI is set.
function(glassbox_add_image_test)
  set(flags COMMAND_EXPAND_LISTS IGNORE_ANTIALIASING)
  set(values NAME OUTPUT REFERENCE WORKING_DIRECTORY FUZZY THRESHOLD MAX_DIFFERING FAILURES)
  set(lists COMMAND OPTIONS LABELS)
  cmake_parse_arguments(PARSE_ARGV 0 TEST "${flags}" "${values}" "${lists}")
  _glassbox_check_image_test()

  set(working_directory ${CMAKE_CURRENT_BINARY_DIR})
  if(DEFINED TEST_WORKING_DIRECTORY)
    _glassbox_absolute(working_directory "${TEST_WORKING_DIRECTORY}" "${CMAKE_CURRENT_BINARY_DIR}")
  endif()
  _glassbox_absolute(output "${TEST_OUTPUT}" "${working_directory}")
  _glassbox_absolute(reference "${TEST_REFERENCE}" "${CMAKE_CURRENT_SOURCE_DIR}")
  set(failures "")
  if(DEFINED TEST_FAILURES)
    _glassbox_absolute(failures "${TEST_FAILURES}" "${working_directory}")
  endif()

  set(options "${TEST_OPTIONS}")
  set(encoded_options "")
  foreach(name FUZZY THRESHOLD MAX_DIFFERING)
    if(DEFINED TEST_${name})
      string(TOLOWER "--${name}" option)
      string(REPLACE "_" "-" option "${option}")
      string(REPLACE ";" "\\;" value "${TEST_${name}}")
      list(APPEND options "${option}" "${value}")
    endif()
  endforeach()
  if(TEST_IGNORE_ANTIALIASING)
    list(APPEND options --ignore-antialiasing)
  endif()
  set(expand_lists "")
  if(TEST_COMMAND_EXPAND_LISTS)
    set(expand_lists COMMAND_EXPAND_LISTS)
  endif()
  # COMMAND_EXPAND_LISTS would take a semicolon of an option for the end of a word.
  foreach(option IN LISTS options)
    string(REPLACE "%" "%25" option "${option}")
    string(REPLACE ";" "%3B" option "${option}")
    list(APPEND encoded_options "${option}")
  endforeach()

  # The function may be called where the variables of find_package are not visible.
  get_property(program GLOBAL PROPERTY glassbox_PROGRAM)
  # "--options" and "--command" divide the words that the script reads.
  add_test(NAME "${TEST_NAME}" WORKING_DIRECTORY "${working_directory}" ${expand_lists}
    COMMAND "${CMAKE_COMMAND}" "-Dprogram=${program}" "-Dname=${TEST_NAME}" "-Doutput=${output}"
      "-Dreference=${reference}" "-Dfailures=${failures}"
      -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/glassbox-run-image-test.cmake"
      -- --options ${encoded_options} --command ${TEST_COMMAND})
  if(DEFINED TEST_LABELS)
    set_tests_properties("${TEST_NAME}" PROPERTIES LABELS "${TEST_LABELS}")
  endif()
endfunction()

# Ends the configuration where a call of glassbox_add_image_test makes no sense. The program checks the
# values of its options again when the test runs; a slip is found sooner here.
macro(_glassbox_check_image_test)
  foreach(name NAME COMMAND OUTPUT REFERENCE)
    if(NOT DEFINED TEST_${name} OR "${TEST_${name}}" STREQUAL "")
      _glassbox_refuse("${name} is missing")
    endif()
  endforeach()
  if("${TEST_NAME}" MATCHES "(^|/)[.][.](/|$)")
    _glassbox_refuse("NAME has a part \"..\", so a page of that name would lie outside of the folder of failures")
  endif()
  if(DEFINED TEST_KEYWORDS_MISSING_VALUES)
    _glassbox_refuse("there is no value for ${TEST_KEYWORDS_MISSING_VALUES}")
  endif()
  foreach(word IN LISTS TEST_COMMAND)
    if(word STREQUAL "")
      _glassbox_refuse("COMMAND has an empty argument, which CMake's lists lose")
    endif()
  endforeach()
  cmake_path(GET TEST_OUTPUT EXTENSION LAST_ONLY made)
  cmake_path(GET TEST_REFERENCE EXTENSION LAST_ONLY golden)
  if(NOT "${TEST_OUTPUT}${TEST_REFERENCE}" MATCHES "[$]<" AND NOT made STREQUAL golden)
    _glassbox_refuse("OUTPUT \"${TEST_OUTPUT}\" and REFERENCE \"${TEST_REFERENCE}\" have different extensions, \
so OUTPUT could not become the reference")
  endif()
  if(DEFINED TEST_THRESHOLD AND NOT TEST_THRESHOLD MATCHES "^(0|1|0?[.][0-9]+|[01][.]0*)$|[$]<")
    _glassbox_refuse("THRESHOLD is \"${TEST_THRESHOLD}\", and a distance of colours is from 0 to 1")
  endif()
  if(DEFINED TEST_MAX_DIFFERING AND NOT TEST_MAX_DIFFERING MATCHES "^([0-9]+|[0-9]*[.]?[0-9]+%)$|[$]<")
    _glassbox_refuse("MAX_DIFFERING is \"${TEST_MAX_DIFFERING}\"; write a number of pixels, such as 12, or a share, \
such as 0.1%")
  endif()
  if(DEFINED TEST_FUZZY AND NOT TEST_FUZZY MATCHES "^[^;]+;[^;]+$|[$]<")
    _glassbox_refuse("FUZZY is \"${TEST_FUZZY}\"; write \"maxDifference=0-1;totalPixels=0-4\", in quotation marks")
  endif()
  if(DEFINED TEST_UNPARSED_ARGUMENTS)
    _glassbox_refuse("it does not know \"${TEST_UNPARSED_ARGUMENTS}\"")
  endif()
endmacro()

function(_glassbox_refuse why)
  message(FATAL_ERROR "glassbox_add_image_test(NAME ${TEST_NAME}): ${why}.")
endfunction()

# _glassbox_absolute(RESULT PATH FOLDER): a path that begins with a generator expression may be
# absolute. It is left as it is, and is relative to the folder in which the test runs.
function(_glassbox_absolute result path folder)
  if(NOT path MATCHES "^[$]<")
    cmake_path(ABSOLUTE_PATH path BASE_DIRECTORY "${folder}")
  endif()
  set(${result} "${path}" PARENT_SCOPE)
endfunction()
