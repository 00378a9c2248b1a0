// For work that is timed and whose result nobody wants.
#pragma once

#include <functional>
#include <utility>

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

// Work for a Configuration: `make` of each of the things, `rounds` times over.
template <class Things, class Make>
std::function<void(int)> rounds_of(int rounds, Things things, Make make) {
  return [rounds, things = std::move(things), make = std::move(make)](int) {
    for (int round = 0; round < rounds; ++round) {
      for (const auto& each : things) consume(make(each));
    }
  };
}

}  // namespace glassbox::study
