// Measures lab 6 for the chart of the experiment on the arithmetic of edge functions (D-3): how
// often the student's edge function gives a pixel to the wrong triangle, and how long a pixel
// takes.
#include <cmath>
#include <memory>

#include "labs/measuring/measuring.h"
#include "study/experiments/d03_edges.h"

namespace glassbox::labs {

namespace lab_06_measured {

using study::EdgeSample;

constexpr int kSamples = 2'000'000, kTimed = 500;  // as in a quick run of the experiment
constexpr int kAtOnce = 500'000;

struct EdgeErrorRates {
  double wrong = 0, leaks = 0;
};

Result<EdgeErrorRates> measure_rates(const Ask& ask, int width) {
  Random random(3);
  double wrong = 0, leaks = 0;
  for (int done = 0; done < kSamples; done += kAtOnce) {
    std::vector<std::uint8_t> right;
    Numbers question{0};
    question.reserve(6 * std::size_t(kAtOnce) + 1);
    for (int i = 0; i < kAtOnce; ++i) {
      const EdgeSample s = study::random_edge_sample(random, width);
      right.push_back(study::right_decision(s));
      for (const int number : {s.from.x, s.from.y, s.to.x, s.to.y, s.x, s.y})
        question.push_back(number);
    }
    const auto answers = ask({question});
    if (!answers) return tl::unexpected(answers.error());
    for (std::size_t i = 0; i < right.size(); ++i) {
      const double here = number_of(answers->front(), 2 * i),
                   there = number_of(answers->front(), 2 * i + 1);
      wrong += here != double(right[i]);
      leaks += here == there;
    }
  }
  return EdgeErrorRates{wrong / kSamples, leaks / kSamples};
}

Numbers timed_triangles(int width) {
  Numbers question{double(study::kEdgeTile)};
  for (const study::TileEdges& t : study::timed_triangles(width, kTimed)) {
    for (std::size_t k = 0; k < 3; ++k)
      question.insert(question.end(), {double(t.x0[k]), double(t.y0[k])});
  }
  return question;
}

// How many pixels all timed triangles cover, computed exactly in 128 bits.
double right_pixels(int width) {
  double pixels = 0;
  for (const study::TileEdges& t : study::timed_triangles(width, kTimed)) {
    for (int y = 0; y < study::kEdgeTile; ++y) {
      for (int x = 0; x < study::kEdgeTile; ++x) {
        // The triangle may have either winding.
        bool is_right = true, is_left = true;
        for (std::size_t k = 0; k < 3; ++k) {
          const EdgeSample s{{t.x0[k], t.y0[k]},
                             {t.x0[k] + t.dx[k], t.y0[k] + t.dy[k]},
                             x * kSubpixels + kPixelCentre,
                             y * kSubpixels + kPixelCentre};
          is_right = is_right && study::right_decision(s);
          is_left = is_left && study::right_decision(s.reversed());
        }
        pixels += is_right || is_left;
      }
    }
  }
  return pixels;
}

// Whether the timed triangles cover as many pixels as they should. Errors at single pixels of edges
// are allowed here, because the chart shows them; they change the number by less than a hundredth.
Result<bool> covers_all(const Ask& ask, int width) {
  const auto answers = ask({timed_triangles(width)});
  if (!answers) return tl::unexpected(answers.error());
  double pixels = 0;
  for (std::size_t i = 0; i < std::size_t(kTimed); ++i) pixels += number_of(answers->front(), i);
  const double right = right_pixels(width);
  return std::abs(pixels - right) <= right / 100;
}

std::vector<MeasuredPoint> measured_points() {
  std::vector<MeasuredPoint> all;
  for (const int width : {1920, 7680, 32768}) {
    const auto kept = std::make_shared<std::optional<EdgeErrorRates>>();
    using Rate = double EdgeErrorRates::*;
    const auto add = [&](const char* scene, Rate rate) {
      all.push_back({"yours", double(width), scene, "",
                     [=](const Ask& ask) -> Result<double> {
                       if (!*kept) {
                         const auto found = measure_rates(ask, width);
                         if (!found) return tl::unexpected(found.error());
                         const auto works = covers_all(ask, width);
                         if (!works) return tl::unexpected(works.error());
                         const double none = number_of({}, 0);
                         *kept = *works ? *found : EdgeErrorRates{none, none};
                       }
                       return (**kept).*rate;
                     },
                     timed_triangles(width), double(kTimed) * study::kEdgeTile* study::kEdgeTile});
    };
    add("wrong decisions", &EdgeErrorRates::wrong);
    add("gaps and doubles", &EdgeErrorRates::leaks);
  }
  return all;
}

}  // namespace lab_06_measured

LabMeasure measured_06() {
  using namespace lab_06_measured;
  return {"D-3", "edge, owns_edge, covered_pixels", measured_points};
}

}  // namespace glassbox::labs
