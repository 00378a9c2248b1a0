# tests/debugger/CMakeLists.txt calls this file with page, program, replay, work. It checks whether
# gdb gives the answers that the page shows. With update=ON it writes gdb's answers into the page.
find_program(gdb NAMES gdb)
if(NOT gdb)
  message("skipped: gdb is not installed")
  return()
endif()

get_filename_component(name ${page} NAME)
set(answered ${work}/answered-${name})
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env --unset=DEBUGINFOD_URLS SHELL=/bin/sh ASAN_OPTIONS=detect_leaks=0
    ${gdb} -nx --batch -ex "python page = '${page}'" -x ${replay} ${program}
  OUTPUT_FILE ${answered} ERROR_VARIABLE errors RESULT_VARIABLE result TIMEOUT 300)
if(errors MATCHES "Python scripting is not supported")
  message("skipped: gdb has no Python here")
  return()
elseif(errors MATCHES "ptrace: Operation not permitted|Could not trace the inferior")
  message("skipped: gdb may not run programs here")
  return()
elseif(NOT result EQUAL 0)
  message(FATAL_ERROR "gdb ended with ${result}:\n${errors}")
endif()

if(update)
  file(COPY_FILE ${answered} ${page})
  return()
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${page} ${answered} RESULT_VARIABLE differs ERROR_QUIET)
if(differs)
  execute_process(COMMAND diff -u ${page} ${answered} OUTPUT_VARIABLE difference)
  message(FATAL_ERROR "gdb answers other than what stands in ${page}:\n${difference}${errors}")
endif()
