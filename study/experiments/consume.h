// For work that is timed and whose result nobody wants.
#pragma once

namespace glassbox::study {

// The compiler has to have the value ready here, and so cannot leave out what makes it.
template <class T>
void consume(const T& value) {
#if defined(__GNUC__) || defined(__clang__)
  asm volatile("" : : "g"(&value) : "memory");
#else
  static const volatile void* sink;
  sink = &value;
#endif
}

}  // namespace glassbox::study
