// Memoization: computes a value only once that several measures use.
#pragma once

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace glassbox::study {

// The result of `make`, computed on the first request and then kept; copies share it. Not
// thread-safe.
template <class Make>
auto memoize(Make make) {
  using Made = std::invoke_result_t<Make>;
  return [make = std::move(make), made = std::make_shared<std::optional<Made>>()]() -> const Made& {
    if (!*made) *made = make();
    return **made;
  };
}

}  // namespace glassbox::study
