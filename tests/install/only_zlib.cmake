# CMake includes this file into the project of a user on whose machine no library of Glassbox can be
# found but zlib: none that glassbox-config.cmake looks for.
file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/../../cmake/glassbox-config.cmake.in lines REGEX "^find_dependency")
list(TRANSFORM lines REPLACE "^find_dependency[(]([A-Za-z_-]+).*" "\\1" OUTPUT_VARIABLE packages)
if(NOT packages MATCHES "^ZLIB;.*;PkgConfig$")
  message(FATAL_ERROR "glassbox-config.cmake.in looks for \"${packages}\"; expected ZLIB first and PkgConfig last")
endif()
list(REMOVE_ITEM packages ZLIB)
foreach(package IN LISTS packages)
  set(CMAKE_DISABLE_FIND_PACKAGE_${package} ON)
endforeach()
