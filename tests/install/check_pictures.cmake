# This file runs the consumer's tests of the library's pictures, with each framework that is
# installed: without golden images, with approval, and again. check_install.cmake includes it.
foreach(framework catch2 gtest doctest)
  set(program ${work}/consumer-build/pictures_with_${framework})
  if(NOT EXISTS ${program})
    message("skipped: ${framework}, which is not installed -- the library's pictures in its tests")
    continue()
  endif()
  execute_process(COMMAND ${program} WORKING_DIRECTORY ${work}/consumer-build
    RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(expected "no[ \n]+such[ \n]+reference")
  if(NOT framework STREQUAL "doctest")
    # doctest prints the message alone. The others name each picture.
    list(APPEND expected "the picture of 7 x 5" "the picture of 6 x 4" "the picture of 3 x 2" "made[.]png")
  endif()
  foreach(says IN LISTS expected)
    if(result EQUAL 0 OR NOT output MATCHES "${says}")
      message(FATAL_ERROR "${program} ends with ${result} and does not say '${says}':\n${output}")
    endif()
  endforeach()
  run(${CMAKE_COMMAND} -E chdir ${work}/consumer-build ${CMAKE_COMMAND} -E env GLASSBOX_APPROVE=1 ${program})
  run(${CMAKE_COMMAND} -E chdir ${work}/consumer-build ${program})
endforeach()
message("the library's pictures in tests: all as it should be")
