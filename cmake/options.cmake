# These options apply to everything that is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
# An archive does not wait for the archives with which it is linked.
set(CMAKE_OPTIMIZE_DEPENDENCIES ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

# If ccache is installed, compiling the same source again, in another clone or with the tests, takes
# a copy. CCACHE_HASHDIR keeps ccache from copying objects with -g between clones, whatever the
# user's own settings say: a debugger would look for their sources in the other clone.
find_program(GLASSBOX_CCACHE ccache DOC "Keeps what was compiled; empty: nothing does")
if(GLASSBOX_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env --unset=CCACHE_NOHASHDIR
    CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_HASHDIR=1 ${GLASSBOX_CCACHE})
endif()

option(GLASSBOX_WERROR "Treat warnings as errors, those of g++ 12, 14 and clang++ 14, 19: other compilers have others" OFF)
option(GLASSBOX_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(GLASSBOX_SOME_TESTS "Build only the tests that ./glassbox test runs under the sanitizers" OFF)
option(GLASSBOX_TOGETHER "Compile sources together where that is quicker" ON)
# A package from `glassbox lab package --students` is for students, however it is configured.
set(is_package OFF)
if(EXISTS ${PROJECT_SOURCE_DIR}/cmake/for-students)
  set(is_package ON)
endif()
option(GLASSBOX_STUDENT "A glassbox for students: labs without solutions, hidden checks and grading" ${is_package})
option(GLASSBOX_FUZZ "Build the libFuzzer targets (needs clang++)" OFF)

# The arithmetic contract requires IEEE operations in the written order. Contraction into FMA is
# therefore off.
add_library(glassbox_flags INTERFACE)
target_compile_options(glassbox_flags INTERFACE -ffp-contract=off)
# g++ 12 vectorises straight-line code. It then turns double(float(x)) into x if the float is used
# elsewhere too (tests/base/conversion_test.cpp). Loops do not have this problem.
target_compile_options(glassbox_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_compile_features(glassbox_flags INTERFACE cxx_std_20)

add_library(glassbox_warnings INTERFACE)
string(REGEX MATCH "^(GNU 12|GNU 14|Clang 14|Clang 19)\\." known "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
if(GLASSBOX_WERROR AND known)
  target_compile_options(glassbox_warnings INTERFACE -Werror)
endif()
# -Wconversion includes -Wsign-conversion in clang++ and not in g++. It is named here so that both
# compilers refuse the same code. g++ 12 warns of overlap inside std::string's own operator+ and
# insert (-Wrestrict).
target_compile_options(glassbox_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)

# This option is for code that runs a few times in a run of the program and is not timed. It takes
# half of the compile time of -O3, and costs one or two microseconds at run time.
add_library(glassbox_runs_once INTERFACE)
target_compile_options(glassbox_runs_once INTERFACE $<$<CONFIG:Release>:-O1>)

if(GLASSBOX_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_compile_options(${sanitizers})
  add_link_options(${sanitizers})
  # The standard library then ends the program if an empty std::optional is read, or an element that
  # is not there: the sanitizers see neither, if the memory is the program's own.
  add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()
if(GLASSBOX_SOME_TESTS)
  add_compile_definitions(GLASSBOX_FEW_TARGETS)  # see raster/lanes/compiled_targets.h
endif()
if(GLASSBOX_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "GLASSBOX_FUZZ needs libFuzzer: configure with -DCMAKE_CXX_COMPILER=clang++")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# add_part(NAME [FIRST ...] [SOURCES ...] [ONCE ...] [LINKS ...] [USES ...]) adds one folder of the
# library, glassbox::NAME. A folder that has only headers has no sources. FIRST are the sources that
# draw the first picture. They are a library of objects, which is built without waiting for the
# rest. ONCE are sources that no measurement times, for example those that read headers or write
# reports (glassbox_runs_once). LINKS are parts and other libraries that the headers include. USES
# are libraries that only the sources include.
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

# write_entries(FILE NAME PATH ...) writes FILE in the current build directory. For each path, FILE
# has a line ENTRY(name), where the regular expression NAME finds the name in the path. A source
# defines ENTRY and includes FILE. So no other file has to list them.
function(write_entries file name)
  set(entries ${ARGN})
  list(TRANSFORM entries REPLACE "${name}" "ENTRY(\\1)")
  list(JOIN entries "\n" entries)
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${file} CONTENT "${entries}\n")
endfunction()

# This many sources are compiled at a time. docs/building.md has the times for 10 and for 40.
set(GLASSBOX_BATCH 40)

# compile_together(TARGET ...) compiles several sources of a target at a time, because the shared
# headers take longer to compile than the sources themselves. Two sources of a target must therefore
# not define different things with the same name in unnamed namespaces.
function(compile_together)
  set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ${GLASSBOX_TOGETHER} UNITY_BUILD_BATCH_SIZE ${GLASSBOX_BATCH})
  foreach(target ${ARGN})
    # g++ treats included sources as headers, and warns that others would see their private types.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endforeach()
endfunction()

# compile_alone(FILE ...) is for a source that privately uses a name which another source of its
# target also uses.
function(compile_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
