# This file builds tests/install/golden against the installed matchers, on a machine that seems to have
# none of the libraries of Glassbox but zlib. It then goes through typical steps: no golden image
# yet, approval, a pass, a defect that is found, and approval that is refused on a server.
# check_install.cmake includes it.
set(source ${work}/golden-example)  # a copy, because golden images are kept beside the tests
set(build ${work}/golden-example-build)
file(REMOVE_RECURSE ${source} ${build})
file(COPY ${example}/ DESTINATION ${source})

run(${CMAKE_COMMAND} -S ${source} -B ${build} -G ${generator} -D CMAKE_PREFIX_PATH=${prefix}
  -D CMAKE_CXX_COMPILER=${compiler} "-DCMAKE_CXX_FLAGS=${flags} ${strict}" -D CMAKE_CXX_STANDARD=17
  -D CMAKE_PROJECT_INCLUDE=${CMAKE_CURRENT_LIST_DIR}/only_zlib.cmake)
run(${CMAKE_COMMAND} --build ${build})

set(programs "")
foreach(program with_catch2 with_gtest with_doctest)
  if(EXISTS ${build}/${program})
    list(APPEND programs ${program})
  else()
    message("skipped: ${program}, whose framework is not installed -- golden images from C++ tests")
  endif()
endforeach()
if(NOT programs)
  message(FATAL_ERROR "no framework for tests is installed, so no matcher has been tried")
endif()

# A test program must not be linked with what only the comparison needs: only with zlib, and what
# every program of the compiler and of the framework is linked with.
set(allowed "linux-vdso|ld-linux[^.]*|libz|libc|libm|libstdc[+][+]|libgcc_s|libpthread|libdl|librt|libasan|libubsan|liblsan|\
libCatch2[^.]*|libgtest[^.]*|libgmock[^.]*")
foreach(program IN LISTS programs)
  execute_process(COMMAND ldd ${build}/${program} OUTPUT_VARIABLE libraries COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "(^|\n)[ \t]*([^ \n]*/)?(${allowed})[.]so[^\n]*" "" others "${libraries}")
  string(STRIP "${others}" others)
  if(NOT others STREQUAL "" OR NOT libraries MATCHES "libz[.]")
    message(FATAL_ERROR "${program} is linked with other libraries than zlib:\n${libraries}")
  endif()
endforeach()

# run_tests(EXPECTED EXIT CODE, EXPECTED TEXT, ENVIRONMENT...) runs all programs.
function(run_tests expected says)
  foreach(program IN LISTS programs)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env ${ARGN} ${build}/${program}
      WORKING_DIRECTORY ${build} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(result EQUAL 0)
      set(outcome passes)
    else()
      set(outcome fails)
    endif()
    # The text must not name an option of glassbox diff, although glassbox diff makes the
    # comparison.
    if(NOT outcome STREQUAL expected OR NOT output MATCHES "${says}" OR output MATCHES "-[ \n]*approve")
      message(FATAL_ERROR "${program} with ${ARGN}: ${outcome}, expected that it ${expected} and says '${says}':\n${output}")
    endif()
  endforeach()
endfunction()

run_tests(fails "no[ \n]+such[ \n]+reference.*GLASSBOX_APPROVE=1" A=B)
run_tests(fails "CI[ \n]+is[ \n]+set" GLASSBOX_APPROVE=1 CI=true)
if(EXISTS ${source}/images/disc.png)
  message(FATAL_ERROR "a golden image was approved with CI set")
endif()
run_tests(passes "" GLASSBOX_APPROVE=1)
expect_file(${source}/images/disc.png)
expect_file(${source}/images/distances.pfm)
run_tests(passes "" A=B)

file(SHA256 ${source}/images/disc.png approved)
# Catch2 breaks long lines.
run_tests(fails "1[ \n]+of[ \n]+6144[ \n]+pixels[ \n]+differ,[ \n]+by[ \n]+up[ \n]+to[ \n]+1/255" PLANT_A_DEFECT=1)
foreach(trace disc.png disc.heat.png disc.html)
  expect_file(${build}/golden-failures/images/${trace})
endforeach()
run_tests(fails "CI[ \n]+is[ \n]+set" PLANT_A_DEFECT=1 GLASSBOX_APPROVE=1 CI=true)
file(SHA256 ${source}/images/disc.png kept)
if(NOT approved STREQUAL kept)
  message(FATAL_ERROR "the golden image has changed though nobody approved it")
endif()

run_tests(passes "" PLANT_A_DEFECT=1 GLASSBOX_APPROVE=1)
run_tests(passes "" PLANT_A_DEFECT=1)
run_tests(fails "different" A=B)
# A picture that equals a file of Glassbox needs no program; others say how to name one.
run_tests(passes "" PLANT_A_DEFECT=1 GLASSBOX_PROGRAM=/nowhere)
run_tests(fails "/nowhere[ \n]+cannot[ \n]+be[ \n]+started" GLASSBOX_PROGRAM=/nowhere)
message("golden-image example: all as it should be")
