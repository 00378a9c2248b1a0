# `ninja -C build/release packages` makes a Debian package and an archive of the files that
# `cmake --install` installs. The archive runs wherever it is unpacked. Both are written to
# build/release. tests/chroots/package.sh installs them on a bare machine.

# These names distinguish files and versions. A package works only on the Debian version on which it
# was built, because it names the libraries of that version.
cmake_host_system_information(RESULT system QUERY DISTRIB_INFO)
set(system "${system_ID}${system_VERSION_ID}")  # for example debian12
string(REPLACE "debian" "deb" release "${system}")

set(CPACK_PACKAGE_NAME glassbox)
set(CPACK_PACKAGE_CONTACT "The Glassbox authors")
set(CPACK_DEBIAN_PACKAGE_CONFLICTS glassbox-students)
if(GLASSBOX_STUDENT)
  # This package has no solutions, no hidden checks and no grading. Its name differs from the other
  # package's, so that nobody mistakes one for the other.
  set(CPACK_PACKAGE_NAME glassbox-students)
  set(CPACK_DEBIAN_PACKAGE_CONFLICTS glassbox)
endif()
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "software rasterizer you can see through")
set(CPACK_PACKAGE_DESCRIPTION "The viewing pipeline from object space to pixels, on the CPU alone: every stage is one file,
every number has a stated error, and the pictures are the same bytes on every machine.
The program, its labs, and the C++ library.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR "DEB;TGZ")
set(CPACK_PACKAGE_FILE_NAME ${CPACK_PACKAGE_NAME}-${PROJECT_VERSION}-${system}-${CMAKE_SYSTEM_PROCESSOR})

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)  # for example glassbox_0.1.0-deb12_amd64.deb
set(CPACK_DEBIAN_PACKAGE_RELEASE ${release})
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
# dpkg-shlibdeps finds the libraries with which the program is linked. The other packages are those
# that `glassbox lab check` and similar commands need: the compiler, the headers that students'
# files include, and the sandbox.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++, libc6-dev, libglm-dev, libexpected-dev, bubblewrap")
# find_package(glassbox) and the projects of `lab start` need these packages, too (what
# cmake/glassbox-config.cmake.in looks for), and charts need gnuplot. apt installs them as well,
# except with --no-install-recommends.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "cmake, ninja-build, pkg-config, libfmt-dev, nlohmann-json3-dev, libpng-dev, libdeflate-dev, libtbb-dev, \
zlib1g-dev, libtinygltf-dev, libstb-dev, libhwy-dev, gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gdb, man-db, bash-completion")
include(CPack)

# cpack alone would first build everything, including the tests.
add_custom_target(packages
  COMMAND ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  DEPENDS glassbox_program glassbox_matchers ${archives}
  USES_TERMINAL VERBATIM)
