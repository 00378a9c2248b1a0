// A C++ source as words and brackets, for checks that need no more of it.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glassbox::test {

struct Token {
  std::string text;
  std::size_t line = 0;  // counted from 1
  bool after_space = false;
  bool is_word() const;
};

using Tokens = std::vector<Token>;

// Words, and other characters one by one, but for -> and ::. Comments and literals are left out.
Tokens tokens_of(std::string_view source);

// One past the bracket that closes the one at `at`.
std::size_t closed(const Tokens& tokens, std::size_t at);

// One past the body of the lambda whose captures end before `at`; `at` if it is none.
std::size_t end_of_lambda(const Tokens& tokens, std::size_t at);

}  // namespace glassbox::test
