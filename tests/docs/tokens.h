// Splits a C++ source into tokens (words and single characters), for checks that need no more.
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

// Returns words, -> and ::, and all other characters one by one. Comments and literals are left
// out.
Tokens tokens_of(std::string_view source);

// Returns the position after the bracket that closes the one at `at`.
std::size_t closed(const Tokens& tokens, std::size_t at);

// Returns the position after the body of the lambda whose captures end before `at`, or `at` if it
// is not a lambda.
std::size_t end_of_lambda(const Tokens& tokens, std::size_t at);

}  // namespace glassbox::test
