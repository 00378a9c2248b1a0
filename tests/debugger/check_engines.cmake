# Called by tests/debugger/CMakeLists.txt with root, program, work: whether debug/glassbox_gdb.py says that a run is drawn by
# the tile engine, and says nothing of the staged one. Needs no debug information: the release build will do.
find_program(gdb NAMES gdb)
if(NOT gdb)
  message("skipped: gdb is not installed")
  return()
endif()

foreach(engine tile staged)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env --unset=DEBUGINFOD_URLS SHELL=/bin/sh
      ${gdb} -nx --batch -ex "source ${root}/debug/glassbox_gdb.py" -ex "python watch_for_tile_engine()" -ex "run"
      -ex "run" --args ${program} render cube --size 64x64 --engine ${engine} -o ${work}/cube.png
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
    message(FATAL_ERROR "two runs of the tile engine, and gdb said so ${count} times:\n${said}\n${errors}")
  elseif(engine STREQUAL staged AND NOT count EQUAL 0)
    message(FATAL_ERROR "the staged engine was taken for the tile engine:\n${said}")
  endif()
endforeach()
