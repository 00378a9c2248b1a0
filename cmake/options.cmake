# How everything is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_OPTIMIZE_DEPENDENCIES ON)  # an archive does not wait for the archives that it is linked with
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

# A second compilation of the same source, in another clone or with the tests, is a copy where ccache is installed. What is compiled with
# -g is not copied between clones, which ccache sees to: a debugger would look for its sources in the other clone.
find_program(GLASSBOX_CCACHE ccache DOC "Keeps what was compiled; empty: nothing does")
if(GLASSBOX_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} ${GLASSBOX_CCACHE})
endif()

option(GLASSBOX_WERROR "Treat warnings as errors, those of g++ 12, 14 and clang++ 14, 19: other compilers have others" OFF)
option(GLASSBOX_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(GLASSBOX_SOME_TESTS "Build only the tests that ./glassbox test runs under the sanitizers" OFF)
option(GLASSBOX_TOGETHER "Compile sources together where that is quicker" ON)
# A package that `glassbox lab package --students` has made is for students, however it is configured.
set(is_package OFF)
if(EXISTS ${PROJECT_SOURCE_DIR}/cmake/for-students)
  set(is_package ON)
endif()
option(GLASSBOX_STUDENT "A glassbox for students: labs without solutions, hidden checks and grading" ${is_package})
option(GLASSBOX_FUZZ "Build the libFuzzer targets (needs clang++)" OFF)

# The arithmetic contract: IEEE operations in the written order, so no contraction into FMA.
add_library(glassbox_flags INTERFACE)
target_compile_options(glassbox_flags INTERFACE -ffp-contract=off)
# g++ 12's vectorizer of straight-line code turns double(float(x)) into x where the float is used elsewhere too
# (tests/base/conversion_test.cpp); loops are not affected.
target_compile_options(glassbox_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_compile_features(glassbox_flags INTERFACE cxx_std_20)

add_library(glassbox_warnings INTERFACE)
string(REGEX MATCH "^(GNU 12|GNU 14|Clang 14|Clang 19)\\." known "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
if(GLASSBOX_WERROR AND known)
  target_compile_options(glassbox_warnings INTERFACE -Werror)
endif()
# -Wsign-conversion is part of -Wconversion for clang++ and not for g++: what the one refuses, the other shall. g++ 12 warns of overlap
# inside std::string's own operator+ and insert (-Wrestrict).
target_compile_options(glassbox_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

# What runs a few times in a run of the program, and is not timed: half the compilation of -O3, for a microsecond or two.
add_library(glassbox_runs_once INTERFACE)
target_compile_options(glassbox_runs_once INTERFACE $<$<CONFIG:Release>:-O1>)

if(GLASSBOX_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_compile_options(${sanitizers})
  add_link_options(${sanitizers})
endif()
if(GLASSBOX_SOME_TESTS)
  add_compile_definitions(GLASSBOX_FEW_TARGETS)  # raster/lanes/compiled_targets.h
endif()
if(GLASSBOX_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "GLASSBOX_FUZZ needs libFuzzer: configure with -DCMAKE_CXX_COMPILER=clang++")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# add_part(NAME [FIRST ...] [SOURCES ...] [ONCE ...] [LINKS ...] [USES ...]): one folder of the library, glassbox::NAME. A folder
# of headers only has no sources. FIRST are those sources that draw the first picture: a library of objects, which is built
# without waiting for the rest. ONCE are those that nothing is timed by: what reads headers, and writes reports
# (glassbox_runs_once). LINKS are parts, and what their headers include; USES is what the sources alone include.
function(add_part name)
  cmake_parse_arguments(PART "" "" "FIRST;SOURCES;ONCE;LINKS;USES" ${ARGN})
  set(part glassbox_${name})
  set(scope PUBLIC)
  foreach(kind FIRST SOURCES ONCE)
    if(PART_${kind})
      string(TOLOWER ${part}_${kind} objects)
      add_library(${objects} OBJECT ${PART_${kind}})
      list(APPEND objects_of_part ${objects})
    endif()
  endforeach()
  if(objects_of_part)
    list(TRANSFORM objects_of_part REPLACE "(.+)" "$<TARGET_OBJECTS:\\1>" OUTPUT_VARIABLE archived)
    add_library(${part} STATIC ${archived})
  else()
    add_library(${part} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(glassbox::${name} ALIAS ${part})
  set_target_properties(${part} PROPERTIES EXPORT_NAME ${name})
  foreach(target ${part} ${objects_of_part})
    target_include_directories(${target} ${scope}
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
    target_link_libraries(${target} ${scope} glassbox_flags glm::glm tl::expected ${PART_LINKS})
  endforeach()
  foreach(objects ${objects_of_part})
    target_include_directories(${objects} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
    target_link_libraries(${objects} PRIVATE glassbox_warnings ${PART_USES})
    compile_together(${objects})
  endforeach()
  if(objects_of_part)
    target_link_libraries(${part} PRIVATE ${PART_USES})
  endif()
  if(PART_ONCE)
    target_link_libraries(${part}_once PRIVATE glassbox_runs_once)
  endif()
endfunction()

# write_entries(FILE NAME PATH ...): FILE in the current build directory has a line ENTRY(name) for each of the paths, in which the
# regular expression NAME finds it. A source defines ENTRY and includes the file: so what is one file each is named nowhere else.
function(write_entries file name)
  set(entries ${ARGN})
  list(TRANSFORM entries REPLACE "${name}" "ENTRY(\\1)")
  list(JOIN entries "\n" entries)
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${file} CONTENT "${entries}\n")
endfunction()

# How many sources are compiled at a time; docs/building.md has the times of 10 and of 40.
set(GLASSBOX_BATCH 40)

# compile_together(TARGET ...): their sources are compiled some at a time, because the headers that they share take longer to
# compile than they do. So the unnamed namespaces of two sources of a target must not have different things of the same name.
function(compile_together)
  set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ${GLASSBOX_TOGETHER} UNITY_BUILD_BATCH_SIZE ${GLASSBOX_BATCH})
  foreach(target ${ARGN})
    # g++ takes included sources for headers, whose private types others would see.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endforeach()
endfunction()

# compile_alone(FILE ...): what names something, privately, that another source of its target names too.
function(compile_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
