// A concept for the types that are numbers.
#pragma once

#include <type_traits>

namespace glassbox {

template <class T>
concept Arithmetic = std::is_arithmetic_v<T>;

}  // namespace glassbox
