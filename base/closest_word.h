// The word that was probably meant by a mistyped one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glassbox {

// How many characters have to be inserted, removed, replaced or exchanged with their neighbour to
// turn a into b (optimal string alignment). Upper and lower case count as equal.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  const auto same = [](char c, char d) {
    const auto lower = [](char e) { return e >= 'A' && e <= 'Z' ? char(e - 'A' + 'a') : e; };
    return lower(c) == lower(d);
  };
  // Three rows of the table of distances are kept: row i and the two rows before it.
  std::vector<std::size_t> row(b.size() + 1), before(row), first(row);
  std::iota(row.begin(), row.end(), std::size_t(0));
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(first, before);
    std::swap(before, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = before[j - 1] + (same(a[i - 1], b[j - 1]) ? 0 : 1);
      row[j] = std::min({before[j] + 1, row[j - 1] + 1, replaced});
      const bool exchanged = i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]);
      if (exchanged) row[j] = std::min(row[j], first[j - 2] + 1);
    }
  }
  return row.back();
}

// The only one of `words` that begins with `typed`, if `typed` has at least three letters.
// Otherwise the word with the smallest edit distance, if the distance is at most a third of its
// letters, and at most two.
inline std::optional<std::string> closest_word(std::string_view typed,
                                               const std::vector<std::string>& words) {
  constexpr std::size_t kMaxEdits = 2, kLongestWord = 64, kMinPrefixLength = 3;
  if (typed.size() > kLongestWord) return std::nullopt;
  const auto begins = [typed](std::string_view word) { return word.starts_with(typed); };
  if (typed.size() >= kMinPrefixLength && std::ranges::count_if(words, begins) == 1) {
    return *std::ranges::find_if(words, begins);
  }
  std::optional<std::string> nearest;
  std::size_t fewest = kMaxEdits + 1;
  for (const std::string& word : words) {
    const std::size_t edits = edit_distance(typed, word);
    if (edits >= fewest || 3 * edits > word.size()) continue;
    fewest = edits;
    nearest = word;
  }
  return nearest;
}

}  // namespace glassbox
