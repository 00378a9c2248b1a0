// Helpers for timed work whose result is not needed.
#pragma once

#include <functional>
#include <utility>

namespace glassbox::study {

// Forces the compiler to compute the value, so that it cannot leave out the timed work.
template <class T>
void do_not_optimize(const T& value) {
#if defined(__GNUC__) || defined(__clang__)
  asm volatile("" : : "g"(&value) : "memory");
#else
  static const volatile void* sink;
  sink = &value;
#endif
}

// The work of a Configuration: calls `make` for each of `things`, and repeats this `rounds` times.
template <class Things, class Make>
std::function<void(int)> repeated_work(int rounds, Things things, Make make) {
  return [rounds, things = std::move(things), make = std::move(make)](int) {
    for (int round = 0; round < rounds; ++round) {
      for (const auto& each : things) do_not_optimize(make(each));
    }
  };
}

}  // namespace glassbox::study
