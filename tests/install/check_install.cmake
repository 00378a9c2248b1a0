# Called by tests/install/CMakeLists.txt with build, consumer, clone, example, work, compiler, flags,
# strict, generator.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGV}\nended with ${result}:\n${output}")
  endif()
  message("${output}")
endfunction()

set(prefix "${work}/a prefix")
file(REMOVE_RECURSE ${prefix} ${work}/consumer-build)
run(${CMAKE_COMMAND} --install ${build} --prefix ${prefix})
run(${prefix}/bin/glassbox --version)
foreach(file man/man1/glassbox.1 bash-completion/completions/glassbox zsh/site-functions/_glassbox
    fish/vendor_completions.d/glassbox.fish)
  file(SIZE ${prefix}/share/${file} size)  # an error where it is not there
  if(size LESS 1000)
    message(FATAL_ERROR "${file} has ${size} bytes")
  endif()
endforeach()
run(bash -n ${prefix}/share/bash-completion/completions/glassbox)
run(${CMAKE_COMMAND} -S ${consumer} -B ${work}/consumer-build -G ${generator}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_CXX_FLAGS=${flags})
run(${CMAKE_COMMAND} --build ${work}/consumer-build)
run(${work}/consumer-build/consumer ${work}/consumer.png)
include(${CMAKE_CURRENT_LIST_DIR}/check_readme.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/check_golden.cmake)
