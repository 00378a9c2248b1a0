# How everything is compiled.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

option(GLASSBOX_WERROR "Treat warnings as errors" OFF)
option(GLASSBOX_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)
option(GLASSBOX_FUZZ "Build the libFuzzer targets (needs clang++)" OFF)

# The arithmetic contract: IEEE operations in the written order, so no contraction into FMA.
add_library(glassbox_flags INTERFACE)
target_compile_options(glassbox_flags INTERFACE -ffp-contract=off)
# g++ 12's vectorizer of straight-line code turns double(float(x)) into x where the float is used elsewhere too
# (tests/base/conversion_test.cpp); loops are not affected.
target_compile_options(glassbox_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_compile_features(glassbox_flags INTERFACE cxx_std_20)

add_library(glassbox_warnings INTERFACE)
# g++ 12 warns of overlap inside std::string's own operator+ and insert (-Wrestrict).
target_compile_options(glassbox_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${GLASSBOX_WERROR}>:-Werror>)

if(GLASSBOX_SANITIZE)
  set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_compile_options(${sanitizers})
  add_link_options(${sanitizers})
endif()
if(GLASSBOX_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    message(FATAL_ERROR "GLASSBOX_FUZZ needs libFuzzer: configure with -DCMAKE_CXX_COMPILER=clang++")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# add_part(NAME [SOURCES ...] [LINKS ...]): one folder of the library, glassbox::NAME. A folder of headers only has no
# sources.
function(add_part name)
  cmake_parse_arguments(PART "" "" "SOURCES;LINKS" ${ARGN})
  if(PART_SOURCES)
    add_library(glassbox_${name} STATIC ${PART_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(glassbox_${name} PRIVATE $<BUILD_INTERFACE:glassbox_warnings>)
  else()
    add_library(glassbox_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(glassbox::${name} ALIAS glassbox_${name})
  set_target_properties(glassbox_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(glassbox_${name} ${scope}
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include> $<INSTALL_INTERFACE:include>)
  target_link_libraries(glassbox_${name} ${scope} glassbox_flags ${PART_LINKS})
endfunction()
