# A toolchain file: from an x86-64 Debian, programs for 64-bit ARM, with Debian's cross compiler g++-aarch64-linux-gnu. The libraries
# of that machine are in a folder of their own, GLASSBOX_SYSROOT; tests/arm64/make_sysroot.sh makes one. Relative to the sources.
set(GLASSBOX_SYSROOT "build/arm64-root" CACHE STRING "The arm64 system whose libraries are used")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES GLASSBOX_SYSROOT)
get_filename_component(sysroot "${GLASSBOX_SYSROOT}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_LIST_DIR}/..")

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_SYSROOT "${sysroot}")
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

# Programs are this machine's, everything else is that machine's.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${sysroot}")
set(ENV{PKG_CONFIG_LIBDIR} "${sysroot}/usr/lib/aarch64-linux-gnu/pkgconfig:${sysroot}/usr/share/pkgconfig")

# What the build runs itself, and ctest.
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L "${sysroot}")
