# CMake includes this file into the project of a user on whose machine no library of Glassbox can be
# found but zlib. The lines are those of cmake/glassbox-config.cmake.in.
foreach(package glm tl-expected fmt nlohmann_json PNG TBB TinyGLTF PkgConfig)
  set(CMAKE_DISABLE_FIND_PACKAGE_${package} ON)
endforeach()
