// Whether a test can use a terminal: programs that behave differently on a terminal are given a
// pseudo-terminal.
#pragma once

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/support/skip.h"

namespace glassbox::test {

// Opens both ends of a pseudo-terminal, as script(1) and forkpty(3) do, and closes them again. In a
// chroot where /dev/pts is not mounted, the first can be opened and the second cannot.
inline bool has_pseudo_terminals() {
  const int master = ::posix_openpt(O_RDWR | O_NOCTTY);
  if (master < 0) return false;
  const char* name =
      ::grantpt(master) == 0 && ::unlockpt(master) == 0 ? ::ptsname(master) : nullptr;
  const int slave = name != nullptr ? ::open(name, O_RDWR | O_NOCTTY) : -1;
  if (slave >= 0) ::close(slave);
  ::close(master);
  return slave >= 0;
}

}  // namespace glassbox::test

// For a test case that needs a pseudo-terminal: if there is none, it ends the test case as
// SKIP_TEST does.
#define NEED_PSEUDO_TERMINAL()                                               \
  do {                                                                       \
    if (!glassbox::test::has_pseudo_terminals())                             \
      SKIP_TEST("there are no pseudo-terminals (mount devpts on /dev/pts)"); \
  } while (false)
