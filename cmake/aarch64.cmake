# This toolchain file builds programs for 64-bit ARM on an x86-64 Debian, with Debian's cross
# compiler g++-aarch64-linux-gnu. The libraries for ARM are in the folder GLASSBOX_SYSROOT, whose
# path is relative to the sources. tests/arm64/make_sysroot.sh makes such a folder.
set(GLASSBOX_SYSROOT "build/arm64-root" CACHE STRING "The arm64 system whose libraries are used")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES GLASSBOX_SYSROOT)
get_filename_component(sysroot "${GLASSBOX_SYSROOT}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_LIST_DIR}/..")

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_SYSROOT "${sysroot}")
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

# CMake looks for programs on this machine, and for everything else in the folder for ARM.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_SYSROOT_DIR} "${sysroot}")
set(ENV{PKG_CONFIG_LIBDIR} "${sysroot}/usr/lib/aarch64-linux-gnu/pkgconfig:${sysroot}/usr/share/pkgconfig")

# This command runs the ARM programs that the build itself or ctest starts.
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L "${sysroot}")
