# `ninja -C build/release packages`: what `cmake --install` installs as a Debian package and as an archive that runs wherever it is
# unpacked, both in build/release. tests/chroots/package.sh installs them on a bare machine.

# What a file and a version are told apart by: a package is for the Debian that it was built on, whose libraries it names.
cmake_host_system_information(RESULT system QUERY DISTRIB_INFO)
set(system "${system_ID}${system_VERSION_ID}")  # debian12
string(REPLACE "debian" "deb" release "${system}")

set(CPACK_PACKAGE_NAME glassbox)
set(CPACK_PACKAGE_CONTACT "The Glassbox authors")
set(CPACK_DEBIAN_PACKAGE_CONFLICTS glassbox-students)
if(GLASSBOX_STUDENT)
  # Without solutions, hidden checks and grading: a name of its own, since it must never be mistaken for the other.
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

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)  # glassbox_0.1.0-deb12_amd64.deb
set(CPACK_DEBIAN_PACKAGE_RELEASE ${release})
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
# The libraries that the program is linked with, by dpkg-shlibdeps. The first of the others are what `glassbox lab check` and its
# kin start: the compiler, the headers that students' files include, the sandbox.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++, libc6-dev, libglm-dev, libexpected-dev, bubblewrap")
# What find_package(glassbox) and the projects of `lab start` need (the first words of each line of cmake/glassbox-config.cmake.in),
# and what draws charts. apt installs these too unless it is told --no-install-recommends.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "cmake, ninja-build, pkg-config, libfmt-dev, nlohmann-json3-dev, libpng-dev, libtbb-dev, \
zlib1g-dev, libtinygltf-dev, libstb-dev, libhwy-dev, gnuplot-nox | gnuplot")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gdb, man-db, bash-completion")
include(CPack)

# cpack by itself would first build all there is, the tests too.
add_custom_target(packages
  COMMAND ${CMAKE_CPACK_COMMAND} --config ${PROJECT_BINARY_DIR}/CPackConfig.cmake
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  DEPENDS glassbox_program ${archives}
  USES_TERMINAL VERBATIM)
