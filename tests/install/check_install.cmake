# tests/install/CMakeLists.txt calls this file with build, consumer, clone, example, work, compiler,
# flags, strict, generator.

# The environment of the person who runs the test must not reach the programs.
foreach(variable CI GLASSBOX_APPROVE GLASSBOX_PROGRAM GLASSBOX_FAILURES)
  unset(ENV{${variable}})
endforeach()

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${result}:\n${output}")
  endif()
  # CMake warns of policies and modules that a later version no longer has.
  if(output MATCHES "CMake[A-Za-z ]* Warning")
    message(FATAL_ERROR "${ARGV}\nwarns:\n${output}")
  endif()
  message("${output}")
endfunction()

function(expect_file path)
  if(NOT EXISTS ${path})
    message(FATAL_ERROR "${path} is missing")
  endif()
endfunction()

set(prefix "${work}/a prefix")
file(REMOVE_RECURSE ${prefix} ${work}/consumer-build ${work}/components-build ${work}/cache)
run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix})
run(${prefix}/bin/glassbox --version)
foreach(file man/man1/glassbox.1 bash-completion/completions/glassbox zsh/site-functions/_glassbox
    fish/vendor_completions.d/glassbox.fish)
  file(SIZE ${prefix}/share/${file} size)  # an error if the file is missing
  if(size LESS 1000)
    message(FATAL_ERROR "${file} has ${size} bytes")
  endif()
endforeach()
run(bash -n ${prefix}/share/bash-completion/completions/glassbox)
run(${CMAKE_COMMAND} -S ${consumer} -B ${work}/consumer-build -G ${generator}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${work}/consumer-build)
run(${work}/consumer-build/consumer ${work}/consumer.png)
run(${CMAKE_COMMAND} -E env GLASSBOX_FAILURES=${work}/consumer-failures
  ${work}/consumer-build/compares ${work}/consumer.png)
# The files with which students' functions are compiled are there for every lab, with all files that
# they include, and an installed program finds them.
set(installed_labs ${prefix}/share/glassbox/labs)
foreach(part student.h student.cpp cases.h runner.cpp stages.cpp timed.cpp)
  file(GLOB of_clone RELATIVE ${clone}/labs ${clone}/labs/[0-9][0-9]-*/${part})
  file(GLOB installed RELATIVE ${installed_labs} ${installed_labs}/[0-9][0-9]-*/${part})
  if(NOT installed OR NOT installed STREQUAL of_clone)
    message(FATAL_ERROR "${part} is installed of ${installed}, and is there of ${of_clone}")
  endif()
endforeach()
file(GLOB sources ${installed_labs}/*/*.h ${installed_labs}/*/*.cpp)
foreach(source IN LISTS sources)
  get_filename_component(folder ${source} DIRECTORY)
  file(STRINGS ${source} lines REGEX "^#include (\"|<glassbox/)")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^#include [\"<](.*)[\">].*" "\\1" header "${line}")
    if(NOT EXISTS ${folder}/${header} AND NOT EXISTS ${prefix}/share/glassbox/${header} AND NOT EXISTS ${prefix}/include/${header})
      message(FATAL_ERROR "${source} includes ${header}, which is not installed")
    endif()
  endforeach()
endforeach()
run(${CMAKE_COMMAND} -E env XDG_CACHE_HOME=${work}/cache ${prefix}/bin/glassbox lab check ${installed_labs}/05-clipping)
run(${CMAKE_COMMAND} -E env XDG_CACHE_HOME=${work}/cache ${prefix}/bin/glassbox lab render ${prefix}/share/glassbox/labs/05-clipping teapot
  --size 64x36 -o ${work}/lab.png)
# find_package's components, which the project checks itself.
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/components -B ${work}/components-build -G ${generator}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${compiler})
include(${CMAKE_CURRENT_LIST_DIR}/check_pictures.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/check_library_page.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/check_golden.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/check_image_tests.cmake)
