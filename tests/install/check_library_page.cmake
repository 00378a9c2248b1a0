# This file builds README's program, exactly as printed there, against the installed package, with
# README's CMake lines. The program must print README's numbers and write the picture that the
# program renders. Without the scene it must say so. check_install.cmake includes this file.
file(READ ${clone}/docs/library.md page)

# block_of_readme(LANGUAGE RESULT) returns the text of README's only block in that language.
function(block_of_page language result)
  string(FIND "${page}" "\n```${language}\n" begin)
  string(FIND "${page}" "\n```${language}\n" last REVERSE)
  if(begin EQUAL -1 OR NOT begin EQUAL last)
    message(FATAL_ERROR "docs/library.md needs one block of ${language}")
  endif()
  string(SUBSTRING "${page}" ${begin} -1 text)
  string(REGEX REPLACE "^\n```${language}\n" "" text "${text}")
  string(FIND "${text}" "```" end)
  string(SUBSTRING "${text}" 0 ${end} text)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

set(house ${work}/library_page)
file(REMOVE_RECURSE ${house})
block_of_page(cpp program)
block_of_page(cmake lines)
block_of_page(text numbers)
file(WRITE ${house}/house.cpp "${program}")
file(WRITE ${house}/CMakeLists.txt "${lines}")
run(${CMAKE_COMMAND} -S ${house} -B ${house}/build -G ${generator}
  -D CMAKE_PREFIX_PATH=${prefix} -D CMAKE_CXX_COMPILER=${compiler} "-DCMAKE_CXX_FLAGS=${flags} ${strict}")
run(${CMAKE_COMMAND} --build ${house}/build)

# run_house(EXPECTED EXIT CODE, EXPECTED TEXT) runs README's program.
function(run_house expected prints)
  execute_process(COMMAND ${house}/build/house WORKING_DIRECTORY ${house} RESULT_VARIABLE result OUTPUT_VARIABLE output)
  if(NOT result EQUAL expected OR NOT output STREQUAL prints)
    message(FATAL_ERROR "the page's program ended with ${result}, expected ${expected}, and printed\n${output}instead of\n${prints}")
  endif()
endfunction()

run_house(1 "examples/house.gltf: there is no such file; check the path, or name a built-in scene: \
teapot, cube, sphere, forest, room, checker, thicket, f-glyph, depth-ladder\n")
file(COPY ${clone}/examples DESTINATION ${house})
run_house(0 "${numbers}")
run(${prefix}/bin/glassbox render ${house}/examples/house.gltf --size 640x360 -o ${house}/expected.png)
run(${prefix}/bin/glassbox diff ${house}/expected.png ${house}/house.png)
message("docs/library.md: all as the page says")
