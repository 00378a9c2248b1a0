# Everything comes from the system; nothing is vendored. Debian package names are in cmake/packages.txt.

# needs(NAME AT_LEAST [WORDS ...]): a package of that version or of any later one. find_package(NAME AT_LEAST) is not it: a package
# says itself which later versions it lets pass for an earlier one, and some let none (TinyGLTF's 2.9 refuses who asks for 2.7).
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
needs(Boost 1.74 CONFIG)  # Boost's own file: CMake 3.30 deprecates the one that CMake brings (policy CMP0167)
find_package(TBB REQUIRED)
needs(TinyGLTF 2.7 CONFIG)
find_package(PkgConfig REQUIRED)
pkg_check_modules(stb REQUIRED IMPORTED_TARGET stb)
pkg_check_modules(hwy REQUIRED IMPORTED_TARGET libhwy)
# Highway's NEON has the AES instructions, by a pragma that g++ does not apply to the constructors which it writes itself.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  set_property(TARGET PkgConfig::hwy APPEND PROPERTY INTERFACE_COMPILE_OPTIONS -march=armv8-a+crypto)
endif()
pkg_check_modules(libzip REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(libarchive REQUIRED IMPORTED_TARGET libarchive)
needs(Eigen3 3.4 CONFIG)
pkg_check_modules(libedit REQUIRED IMPORTED_TARGET libedit)
find_file(GLASSBOX_CHART_JS javascript/chart.js/chart.min.js PATH_SUFFIXES share REQUIRED
  DOC "Chart.js 3, which draws the charts of an HTML page")
