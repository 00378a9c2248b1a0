# All libraries come from the system; the project contains none. cmake/packages.txt has the names of
# the Debian packages.

# needs(NAME AT_LEAST [WORDS ...]) finds a package of this version or any later one.
# find_package(NAME AT_LEAST) does not do this: a package decides itself which later versions it
# accepts for an earlier one. Some accept none (TinyGLTF 2.9 refuses a request for 2.7).
macro(needs name at_least)
  find_package(${name} REQUIRED ${ARGN})
  if(${name}_VERSION VERSION_LESS ${at_least})
    message(FATAL_ERROR "Glassbox needs ${name} ${at_least} or later; ${${name}_DIR} has ${${name}_VERSION}.")
  endif()
endmacro()

find_package(glm REQUIRED)
find_package(tl-expected REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(PNG REQUIRED)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
# This uses Boost's own file, because CMake 3.30 deprecates CMake's file (policy CMP0167).
needs(Boost 1.74 CONFIG)
find_package(TBB REQUIRED)
needs(TinyGLTF 2.7 CONFIG)
find_package(PkgConfig REQUIRED)
pkg_check_modules(libdeflate REQUIRED IMPORTED_TARGET libdeflate)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET stb)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET libhwy)
# Highway enables the AES instructions of NEON with a pragma. g++ does not apply the pragma to the
# constructors that it generates.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  set_property(TARGET PkgConfig::hwy APPEND PROPERTY INTERFACE_COMPILE_OPTIONS -march=armv8-a+crypto)
endif()
pkg_check_modules(libzip REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(libarchive REQUIRED IMPORTED_TARGET libarchive)
needs(Eigen3 3.4 CONFIG)
pkg_check_modules(libedit REQUIRED IMPORTED_TARGET libedit)
find_file(GLASSBOX_CHART_JS javascript/chart.js/chart.min.js PATH_SUFFIXES share REQUIRED
  DOC "Chart.js 3, which draws the charts of an HTML page")
