// To be included by one source of each test program that creates an OSMesa context.
#pragma once

// OSMesa never frees some memory that OSMesaMakeCurrent allocates, not even with the context: that
// leak is not ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa.so\n";
}
