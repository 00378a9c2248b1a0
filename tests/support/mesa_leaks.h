// For one source of each test program that makes a context of OSMesa.
#pragma once

// OSMesa keeps what OSMesaMakeCurrent allocates after the context is destroyed; that leak is not ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so\n";
}
