# tests/debugger/CMakeLists.txt calls this file with root, program, work. glassbox-triangle and
# glassbox-pixel must say once in a run that the tile engine draws it, and must say nothing in a run
# of the staged engine. The test removes their own breakpoints, which a program with debug
# information has, so that the runs go on to their ends. (LeakSanitizer does not work in a process
# that is debugged.)
set(engines tile staged tile staged)
set(commands "glassbox-triangle 0" "glassbox-triangle 0" "glassbox-pixel 3 4" "glassbox-pixel 3 4")
find_program(gdb NAMES gdb)
if(NOT gdb)
  message("skipped: gdb is not installed")
  return()
endif()

foreach(engine command IN ZIP_LISTS engines commands)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env --unset=DEBUGINFOD_URLS SHELL=/bin/sh ASAN_OPTIONS=detect_leaks=0
      ${gdb} -nx --batch -ex "source ${root}/debug/glassbox_gdb.py" -ex "${command}"
      -ex "python [stop.delete() for stop in gdb.breakpoints() if not isinstance(stop, TileEngineNotice)]"
      -ex "run" -ex "run"
      --args ${program} render cube --size 64x64 --engine ${engine} -o ${work}/cube.png
    OUTPUT_VARIABLE said ERROR_VARIABLE errors RESULT_VARIABLE result TIMEOUT 300)
  if(errors MATCHES "Python scripting is not supported")
    message("skipped: gdb has no Python here")
    return()
  elseif(errors MATCHES "ptrace: Operation not permitted|Could not trace the inferior")
    message("skipped: gdb may not run programs here")
    return()
  elseif(NOT result EQUAL 0 OR NOT said MATCHES "exited normally.*exited normally")
    message(FATAL_ERROR "gdb ended with ${result}:\n${said}\n${errors}")
  endif()
  string(REGEX MATCHALL "the tile engine draws this run" notices "${said}")
  list(LENGTH notices count)
  if(engine STREQUAL tile AND NOT count EQUAL 2)
    message(FATAL_ERROR "${command}: two runs of the tile engine, and gdb said so ${count} times:\n${said}\n${errors}")
  elseif(engine STREQUAL staged AND NOT count EQUAL 0)
    message(FATAL_ERROR "the staged engine was taken for the tile engine:\n${said}")
  endif()
endforeach()
