// The instruction sets that the vectorised code can be compiled for. Pictures are the same with all
// of them, byte for byte.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace glassbox {

// kScalar: plain C++, for every processor.
enum class Target { kScalar, kSse4, kAvx2, kAvx512, kNeon };

// The targets that were compiled and that this processor supports, the best one last. Never empty.
std::vector<Target> available_targets();
Target best_target();

std::string_view name_of(Target target);  // "avx512"
std::optional<Target> target_named(std::string_view name);

}  // namespace glassbox
