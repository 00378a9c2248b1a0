// For errors of several measures that come from one computation.
#pragma once

#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace glassbox::study {

// What `make` gives, made when it is first asked for and kept; copies share it. For one thread.
template <class Make>
auto once(Make make) {
  using Made = std::invoke_result_t<Make>;
  return [make = std::move(make), made = std::make_shared<std::optional<Made>>()]() -> const Made& {
    if (!*made) *made = make();
    return **made;
  };
}

}  // namespace glassbox::study
