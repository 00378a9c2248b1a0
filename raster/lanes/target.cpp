#include <glassbox/raster/lanes/target.h>

#include <array>
#include <atomic>
#include <cstdint>

// Defines the targets of foreach_target.h, which are needed here too.
#include <glassbox/raster/lanes/compiled_targets.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <glassbox/raster/lanes/preferred_target.h>

namespace glassbox {

namespace {

struct TargetInfo {
  Target target;
  std::string_view name;
  std::int64_t highway;  // the bit of Highway's target
};

constexpr std::array<TargetInfo, 5> kKnownTargets{{{Target::kScalar, "scalar", HWY_SCALAR},
                                                   {Target::kSse4, "sse4", HWY_SSE4},
                                                   {Target::kAvx2, "avx2", HWY_AVX2},
                                                   {Target::kAvx512, "avx512", HWY_AVX3},
                                                   {Target::kNeon, "neon", HWY_NEON}}};

// The result is cached, because Highway queries the processor in every call, and on a virtual
// machine each of these instructions is handled by the host.
std::int64_t supported_targets() {
  static const std::int64_t supported = hwy::SupportedTargets() | HWY_SCALAR;
  return supported;
}

constexpr int kNoPreference = -1;
std::atomic<int> preferred = kNoPreference;

}  // namespace

std::vector<Target> available_targets() {
  const std::int64_t supported = supported_targets();
  std::vector<Target> available;
  for (const TargetInfo& known : kKnownTargets) {
    if ((known.highway & supported & GLASSBOX_LANES) != 0) available.push_back(known.target);
  }
  return available;
}

Target best_target() {
  if (const int preference = preferred; preference != kNoPreference) return Target(preference);
  return available_targets().back();
}

void prefer_target(std::optional<Target> target) {
  preferred = target ? int(*target) : kNoPreference;
}

std::string_view name_of(Target target) {
  return kKnownTargets[std::size_t(target)].name;
}

std::optional<Target> target_named(std::string_view name) {
  for (const TargetInfo& known : kKnownTargets) {
    if (known.name == name) return known.target;
  }
  return std::nullopt;
}

}  // namespace glassbox
