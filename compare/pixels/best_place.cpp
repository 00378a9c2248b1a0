#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <type_traits>
#include <vector>

#include <glassbox/base/random.h>
#include <glassbox/compare/pixels/canvas.h>

namespace glassbox {
namespace {

constexpr std::size_t kProbes = 256;    // pixels that are compared at every place
constexpr std::size_t kFinalists = 32;  // places that are compared completely

// The places of the test's corner: [first, last] in each direction.
struct Places {
  PixelPosition first, last;
};

Places places_of(const StoredImage& reference, const StoredImage& test) {
  const int x = reference.width - test.width, y = reference.height - test.height;
  return {{std::min(x, 0), std::min(y, 0)}, {std::max(x, 0), std::max(y, 0)}};
}

std::uint32_t probe_steps(int a, int b) {
  return std::uint32_t(std::abs(a - b));
}
// Cut, so that a few NaN do not decide.
std::uint32_t probe_steps(float a, float b) {
  constexpr std::uint32_t kFar = 1u << 24;  // a factor of four
  return std::min(ulp_distance(a, b, true), kFar);
}

// Both pictures, and how they lie on each other at a place.
template <class Sample>
struct Overlay {
  Overlay(const StoredImage& reference, const StoredImage& test)
      : a(std::get<std::vector<Sample>>(reference.samples)),
        b(std::get<std::vector<Sample>>(test.samples)),
        a_width(reference.width),
        b_width(test.width),
        channels(std::size_t(reference.channels)),
        width(std::min(reference.width, test.width)),
        height(std::min(reference.height, test.height)) {}

  // The largest difference of a channel in pixel (x, y) of the overlap, in steps, for the test's
  // corner at `place`.
  std::uint32_t steps(PixelPosition place, int x, int y) const {
    const Sample* in_a = at(a, a_width, std::max(place.x, 0) + x, std::max(place.y, 0) + y);
    const Sample* in_b = at(b, b_width, std::max(-place.x, 0) + x, std::max(-place.y, 0) + y);
    std::uint32_t largest = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      largest = std::max(largest, probe_steps(in_a[c], in_b[c]));
    }
    return largest;
  }

  // Whether the pixel of the smaller picture is like the one on its right.
  bool is_plain(PixelPosition p) const {
    if (p.x + 1 >= width) return true;
    const Sample* pixel = a.size() < b.size() ? at(a, a_width, p.x, p.y) : at(b, b_width, p.x, p.y);
    return std::equal(pixel, pixel + channels, pixel + channels);
  }

  const std::vector<Sample>&a, &b;
  int a_width, b_width;
  std::size_t channels;
  int width, height;  // of the overlap

private:
  const Sample* at(const std::vector<Sample>& samples, int row_width, int x, int y) const {
    return samples.data() + (std::size_t(y) * std::size_t(row_width) + std::size_t(x)) * channels;
  }
};

// Pixels of the overlap spread at random. Half of them are drawn several times, until one is found
// where the smaller picture is not plain: a plain background fits everywhere.
template <class Sample>
std::vector<PixelPosition> probes_in(const Overlay<Sample>& overlay) {
  constexpr int kDraws = 16;
  Random random(1);
  const auto draw = [&]() -> PixelPosition {
    const auto x = int(random.integer(0, overlay.width - 1));
    return {x, int(random.integer(0, overlay.height - 1))};
  };
  std::vector<PixelPosition> probes;
  for (std::size_t i = 0; i < kProbes; ++i) {
    PixelPosition probe = draw();
    for (int again = 1; i % 2 == 1 && again < kDraws && overlay.is_plain(probe); ++again) {
      probe = draw();
    }
    probes.push_back(probe);
  }
  return probes;
}

struct Candidate {
  std::uint64_t steps = 0;  // the sum over pixels
  PixelPosition place;
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return std::tuple(a.steps, a.place.y, a.place.x) < std::tuple(b.steps, b.place.y, b.place.x);
  }
};

constexpr auto kNoLimit = std::numeric_limits<std::uint64_t>::max();

// The places at which the probes differ least. A place is given up as soon as it is worse than the
// worst of the best so far, or as bad: of two such places, the earlier one is better.
template <class Sample>
std::vector<Candidate> finalists(const Overlay<Sample>& overlay, const Places& places) {
  const std::vector<PixelPosition> probes = probes_in(overlay);
  std::vector<Candidate> best;  // a heap with the worst on top
  for (int y = places.first.y; y <= places.last.y; ++y) {
    for (int x = places.first.x; x <= places.last.x; ++x) {
      Candidate candidate{0, {x, y}};
      const auto limit = best.size() < kFinalists ? kNoLimit : best.front().steps;
      for (std::size_t i = 0; i < probes.size() && candidate.steps < limit; ++i) {
        candidate.steps += overlay.steps(candidate.place, probes[i].x, probes[i].y);
      }
      if (best.size() == kFinalists && !(candidate < best.front())) continue;
      best.push_back(candidate);
      std::push_heap(best.begin(), best.end());
      if (best.size() <= kFinalists) continue;
      std::pop_heap(best.begin(), best.end());
      best.pop_back();
    }
  }
  return best;
}

// The sum over all pixels of the overlap; stops where it is above the limit.
template <class Sample>
std::uint64_t steps_at(const Overlay<Sample>& overlay, PixelPosition place, std::uint64_t limit) {
  std::uint64_t steps = 0;
  for (int y = 0; y < overlay.height && steps <= limit; ++y) {
    for (int x = 0; x < overlay.width; ++x) steps += overlay.steps(place, x, y);
  }
  return steps;
}

}  // namespace

PixelPosition best_place(const StoredImage& reference, const StoredImage& test) {
  return std::visit(
      [&](const auto& samples) {
        using Sample = typename std::decay_t<decltype(samples)>::value_type;
        const Overlay<Sample> overlay(reference, test);
        Candidate best{kNoLimit, {}};
        for (Candidate one : finalists(overlay, places_of(reference, test))) {
          one.steps = steps_at(overlay, one.place, best.steps);
          best = std::min(best, one);
        }
        return best.place;
      },
      reference.samples);
}

}  // namespace glassbox
