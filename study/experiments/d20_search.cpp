// Measures what the epipolar constraint saves: a point is searched for along its row, and in the
// whole picture (D-20).
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include <glassbox/base/random.h>
#include "study/experiment/experiment.h"
#include "study/experiments/do_not_optimize.h"

namespace glassbox::study {
namespace d20 {

constexpr int kBits = 8;  // number of bits in a pixel's word

// Random words: the left picture's pixel (x, y) equals the right one's (x - d, y), with a separate
// d for each row, which is less than a quarter of the width.
struct WordPair {
  int width = 0, height = 0, disparities = 0;
  std::vector<std::uint8_t> left, right;
  std::vector<int> of_row;

  explicit WordPair(int width_)
      : width(width_),
        height(width_ * 3 / 4),
        disparities(width_ / 4),
        left(std::size_t(width * height)),
        right(left.size()) {
    Random random(20);
    const auto word = [&] { return std::uint8_t(random.integer(0, (1 << kBits) - 1)); };
    for (int y = 0; y < height; ++y) {
      of_row.push_back(int(random.integer(0, disparities - 1)));
      for (int x = 0; x < width; ++x) right[index(x, y)] = word();
      for (int x = 0; x < width; ++x)
        left[index(x, y)] = x >= of_row.back() ? right[index(x - of_row.back(), y)] : word();
    }
  }
  std::size_t index(int x, int y) const { return std::size_t(y * width + x); }
};

struct SearchResult {
  std::size_t at = 0;  // index in the right picture
  std::int64_t compared = 0;
};

// Finds the right picture's word that differs from `word` in the fewest bits; the first one if
// there are several.
template <class Next>
SearchResult least_of(const WordPair& pair, std::uint8_t word, std::size_t first, std::size_t count,
                      Next next) {
  SearchResult result{first};
  int least = kBits + 1;
  for (std::size_t i = 0, at = first; i < count; ++i, at = next(at)) {
    const int cost = std::popcount(unsigned(word ^ pair.right[at]));
    ++result.compared;
    if (cost < least) {
      least = cost;
      result.at = at;
    }
  }
  return result;
}

using Search = SearchResult (*)(const WordPair& pair, int x, int y);

SearchResult along_row(const WordPair& pair, int x, int y) {
  const std::size_t here = pair.index(x, y);
  return least_of(pair, pair.left[here], here, std::size_t(std::min(pair.disparities, x + 1)),
                  [](std::size_t at) { return at - 1; });
}
SearchResult in_whole_picture(const WordPair& pair, int x, int y) {
  return least_of(pair, pair.left[pair.index(x, y)], 0, pair.right.size(),
                  [](std::size_t at) { return at + 1; });
}

// Calls `ask` for about `most` pixels of the left picture, at regular steps, and returns how many
// they were. Leaves out pixels at the left, for which not every disparity is possible.
template <class Ask>
int for_some(const WordPair& pair, int most, Ask ask) {
  // an odd step, so that pixels of all columns occur
  const int step = std::max(1, pair.width * pair.height / most) | 1;
  int asked = 0;
  for (int i = step / 2; i < pair.width * pair.height; i += step) {
    if (i % pair.width < pair.disparities) continue;
    ask(i % pair.width, i / pair.width);
    ++asked;
  }
  return asked;
}

double share_wrong(int width, Search search) {
  const WordPair pair(width);
  int wrong = 0;
  const int asked = for_some(pair, 4000, [&](int x, int y) {
    wrong += search(pair, x, y).at != pair.index(x - pair.of_row[std::size_t(y)], y);
  });
  return double(wrong) / asked;
}

double comparisons(int width, Search search) {
  const WordPair pair(width);
  std::int64_t compared = 0;
  for (int y = 0; y < pair.height; ++y) {
    for (int x = 0; x < width; ++x) compared += search(pair, x, y).compared;
  }
  return double(compared);
}

// The probability of a wrong result. The right word is the i-th of C candidates, each i with the
// same probability. It is missed if one of the words before it is equal, which has the probability
// 2^-kBits for each of them.
double predicted_wrong(double candidates) {
  const double same = std::exp2(-kBits);
  return 1 - (1 - std::pow(1 - same, candidates)) / (candidates * same);
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<int> widths{32, 48, 64, 96};
  if (effort == Effort::kFull) widths.insert(widths.end(), {128, 160});
  std::vector<Configuration> all;
  for (const int width : widths) {
    const double pixels = width * width * 3 / 4, disparities = width / 4;
    struct Method {
      const char* name;
      Search search;
      double candidates;
    };
    for (const Method& method : {Method{"along the row", along_row, disparities},
                                 Method{"in the whole picture", in_whole_picture, pixels}}) {
      // The number of searches in a call: so many that they make a million comparisons, but not
      // more than the picture has pixels.
      const int timed = int(std::clamp(1e6 / method.candidates, 16.0, pixels));
      const WordPair pair(width);
      const int items = for_some(pair, timed, [](int, int) {});
      all.push_back({.series = method.name,
                     .parameter = double(width),
                     .error = [=] { return share_wrong(width, method.search); },
                     .predicted_error = predicted_wrong(method.candidates),
                     .work =
                         [pair, method, timed](int) {
                           for_some(pair, timed, [&](int x, int y) {
                             do_not_optimize(method.search(pair, x, y).at);
                           });
                         },
                     .items = double(items)});
      all.push_back({.series = method.name,
                     .parameter = double(width),
                     .measure = "comparisons",
                     .error = [=] { return comparisons(width, method.search); },
                     .predicted_error = pixels * method.candidates});
    }
  }
  return all;
}

}  // namespace d20

Experiment d20_search() {
  using namespace d20;
  return {.id = "D-20",
          .name = "Matching: along the row or anywhere",
          .question =
              "How much time and how many mistakes does it save to know on which line of the other "
              "picture a point is?",
          .axis = "width of the picture",
          .axis_unit = "px",
          .error = "fraction of pixels with a wrong match",
          .reference = "the disparity with which the pair was made, below a quarter of the width",
          .theory =
              "Each of C candidates has the same 8 bits with probability p = 1/256, and the first "
              "one is taken, so the fraction 1 - (1 - (1 - p)^C)/(C p) is wrong. C is D along the "
              "row with D disparities, and W H anywhere in a picture of W x H pixels (S2-11 in "
              "docs/references.md). There are W H D and W^2 H^2 comparisons, so the time for a "
              "pixel grows like W and like W^2",
          .item = "pixel",
          .measures = {{.name = "comparisons",
                        .error = "comparisons for all pixels of the left picture",
                        .error_unit = ""}},
          .configurations = configurations};
}

}  // namespace glassbox::study
