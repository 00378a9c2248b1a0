// Compares many pairs of pictures, several at the same time.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

// Compares all pairs, on up to eight threads: each thread holds two pictures in memory. The results
// are those of compare_pair, in the order of the pairs, with Comparison::seconds. `on_start` is
// called with the number of a pair before it is compared, by any thread, one call at a time.
std::vector<Comparison> compare_all(std::span<const PicturePaths> pairs,
                                    const CompareOptions& options,
                                    const std::function<void(std::size_t)>& on_start = {});

}  // namespace glassbox
