// The code that tries calls in place of a task's function. It is no header of the tests:
// pasted_test.cpp fills in the marked lines and puts it into a student.cpp. A call is offered if it
// compiles and its result, converted or one of its members, is of the type that the task's function
// returns.
#pragma once

// Versions 14 and 19 of clang-format disagree on constraints.
// clang-format off

#include <unistd.h>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "labs/framework/choices.h"

namespace pasting {

template <class S>
  requires requires(S& s) {
    s.x;
    s.y;
    s.z;
    s.w;
  }
auto members(S& s) {
  return std::tie(s.x, s.y, s.z, s.w);
}
template <class S>
  requires(
      requires(S& s) {
        s.x;
        s.y;
        s.z;
      } && !requires(S& s) { s.w; })
auto members(S& s) {
  return std::tie(s.x, s.y, s.z);
}
template <class T, std::size_t kSize>
  requires(kSize < 9)
auto members(std::array<T, kSize>& a) {
  return std::apply([](auto&... x) { return std::tie(x...); }, a);
}
template <class T, std::size_t kSize>
  requires(kSize < 9)
auto members(const std::array<T, kSize>& a) {
  return std::apply([](auto&... x) { return std::tie(x...); }, a);
}
// MEMBERS
template <class S>
auto parts(S& s) {
  if constexpr (requires { members(s); })
    return members(s);
  else
    return std::tie(s);
}

template <class R>
struct Trial {
  std::string wanted = std::getenv("GLASSBOX_PASTED");
  bool lists = wanted.ends_with(" list");
  int number = lists ? -1 : std::atoi(wanted.c_str() + wanted.find(' ')), offered = 0;
  std::optional<std::conditional_t<std::is_void_v<R>, char, R>> answer;
  std::function<R()> right;  // the solution

  bool takes(const char* name, const char* how, const char* arguments, const char* result) {
    if (lists) std::printf("call: %s(%s%s)%s\n", name, how, arguments, result);
    return offered++ == number;
  }
  R finish() {
    if (lists) {
      std::printf("all calls\n");
      std::fflush(stdout);
      _exit(0);
    }
    if (!answer) std::abort();
    if constexpr (!std::is_void_v<R>) return std::move(*answer);
  }
};

inline bool is_on(const char* name) {
  const char* set = std::getenv("GLASSBOX_PASTED");
  static const std::string wanted = set == nullptr ? "" : set;
  return wanted.starts_with(name) && wanted[std::string(name).size()] == ' ';
}

// Whether the function is defined in the lab's own headers, and not in the library's.
inline bool is_of_lab(const char* name) {
  return std::string(name).starts_with("lab_");
}

// Offers the result as a member of the right answer. Functions of the library's own headers, such
// as one that returns its argument, are left out.
template <class R, class Call>
void offer_as_member(Trial<R>& trial, const char* name, const char* how, const char* arguments,
                     Call call) {
  using S = std::remove_cvref_t<decltype(call())>;
  using Parts = decltype(members(std::declval<R&>()));
  const auto one = [&]<std::size_t i>(std::integral_constant<std::size_t, i>) {
    using Part = std::remove_cvref_t<std::tuple_element_t<i, Parts>>;
    if constexpr (std::is_same_v<S, Part>) {
      if (trial.takes(name, how, arguments, " as a member")) {
        trial.answer = trial.right();
        std::get<i>(members(*trial.answer)) = call();
      }
    }
  };
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (one(std::integral_constant<std::size_t, k>()), ...);
  }(std::make_index_sequence<std::tuple_size_v<Parts>>());
}

template <class R, class Call>
void offer(Trial<R>& trial, const char* name, const char* how, const char* arguments, Call call) {
  using S = std::remove_cvref_t<decltype(call())>;
  if constexpr (std::is_void_v<R>) {
    if (trial.takes(name, how, arguments, "")) call(), trial.answer = 0;
  } else if constexpr (!std::is_void_v<S>) {
    if constexpr (std::is_convertible_v<S, R>) {
      if (trial.takes(name, how, arguments, "")) trial.answer.emplace(call());
    } else if constexpr (std::is_enum_v<R> && std::is_integral_v<S>) {
      if (trial.takes(name, how, arguments, " as an enumerator")) trial.answer = R(call());
    } else if constexpr (requires(S s) { R{s}; }) {
      if (trial.takes(name, how, arguments, " in braces")) trial.answer.emplace(R{call()});
    }
    if constexpr (requires(R& r) { members(r); }) {
      if (is_of_lab(name)) offer_as_member(trial, name, how, arguments, call);
    }
    if constexpr (requires(S s) { s.front(); }) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(std::declval<S>().front())>, R>) {
        if (trial.takes(name, how, arguments, ".front()")) trial.answer.emplace(call().front());
      }
    }
    if constexpr (requires(S& s) { members(s); }) {
      using Parts = decltype(members(std::declval<S&>()));
      [&]<std::size_t... k>(std::index_sequence<k...>) {
        const auto one = [&]<std::size_t i>(std::integral_constant<std::size_t, i>) {
          if constexpr (std::is_same_v<std::remove_cvref_t<std::tuple_element_t<i, Parts>>, R>) {
            if (trial.takes(name, how, arguments, "'s member")) {
              S s = call();
              trial.answer.emplace(std::get<i>(members(s)));
            }
          }
        };
        (one(std::integral_constant<std::size_t, k>()), ...);
      }(std::make_index_sequence<std::tuple_size_v<Parts>>());
    }
  }
}

using glassbox::labs::Choices;

#define VISIBLE(id, name, fewest, most)                                  \
  struct id {                                                            \
    static constexpr const char* text = #name;                           \
    static constexpr bool takes(std::size_t count) {                     \
      return fewest <= count && count <= most;                           \
    }                                                                    \
    template <class... A>                                                \
    static auto plain(A&... a) -> decltype(name(a...)) {                 \
      return name(a...);                                                 \
    }                                                                    \
    template <class... A>                                                \
    static auto braced(A&... a) -> decltype(name({a...})) {              \
      return name({a...});                                               \
    }                                                                    \
    template <class... A>                                                \
    static auto named(A&... a) -> decltype(name({"", a...})) {           \
      return name({"", a...});                                           \
    }                                                                    \
    template <class... A>                                                \
    static auto chosen(Choices& c, A&... a) -> decltype(name(c, a...)) { \
      return name(c, a...);                                              \
    }                                                                    \
  };

template <class V, class R, class... A>
void offer_one(Trial<R>& trial, const char* arguments, A&... a) {
  if constexpr (V::takes(sizeof...(a))) {
    if constexpr (requires { V::plain(a...); })
      offer(trial, V::text, "", arguments, [&] { return V::plain(a...); });
  }
  if constexpr (V::takes(1)) {
    if constexpr (requires { V::braced(a...); } && !requires { V::plain(a...); })
      offer(trial, V::text, "in braces: ", arguments, [&] { return V::braced(a...); });
    if constexpr (requires { V::named(a...); })
      offer(trial, V::text, "in braces after \"\": ", arguments, [&] { return V::named(a...); });
  }
  if constexpr (V::takes(1 + sizeof...(a))) {
    Choices simplest(std::vector<std::uint64_t>{});
    if constexpr (requires { V::chosen(simplest, a...); })
      offer(trial, V::text, "after choices: ", arguments,
            [&] { return V::chosen(simplest, a...); });
  }
}

// VISIBLE
template <class R, class... A>
void offer_each(Trial<R>& trial, const char* arguments, A&... a) {
  // OFFERS
}

// Offers calls with some of the members one after the other.
template <class R, class Tuple>
void offer_members(Trial<R>& trial, Tuple all) {
  constexpr std::size_t count = std::tuple_size_v<Tuple>;
  if constexpr (count <= 9) {
    const auto range = [&]<std::size_t first, std::size_t... k>(
                           std::integral_constant<std::size_t, first>, std::index_sequence<k...>) {
      offer_each(trial, "members", std::get<first + k>(all)...);
    };
    const auto from = [&]<std::size_t first, std::size_t... length>(
                          std::integral_constant<std::size_t, first> start,
                          std::index_sequence<length...>) {
      (range(start, std::make_index_sequence<length + 1>()), ...);
    };
    [&]<std::size_t... first>(std::index_sequence<first...>) {
      (from(std::integral_constant<std::size_t, first>(),
            std::make_index_sequence<count - first>()),
       ...);
    }(std::make_index_sequence<count>());
  } else {
    std::apply([&](auto&... a) { offer_each(trial, "members", a...); }, all);
  }
}

}  // namespace pasting
