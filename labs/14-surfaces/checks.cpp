// The expected answers of lab 14: cells from the table of views/polygons, lists from sorting again
// after each change, weights from exact rational numbers, bands from extended precision (long
// double).
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include <glassbox/base/rounding.h>

#include "exact/number.h"
#include "labs/14-surfaces/borders.h"
#include "labs/14-surfaces/generators.h"
#include "labs/framework/lab.h"

namespace glassbox::labs {

namespace {

using namespace lab_14;
using exact::Rational;

// ---- cells ----

std::vector<double> listed_polygons(unsigned inside) {
  std::vector<double> all;
  for (const auto& polygon : borders_in_cell(inside)) {
    all.insert(all.end(), polygon.begin(), polygon.end());
    all.push_back(-1);
  }
  return all;
}

std::string corners_text(unsigned inside) {
  std::string text;
  for (int corner = 0; corner < 8; ++corner) {
    if ((inside >> corner & 1) != 0) text += fmt::format(" {}", corner);
  }
  return text.empty() ? " none" : text;
}

Case expect_cell(const CellCase& input) {
  return {.where = input.what,
          .restated = "corners inside:" + corners_text(input.inside) +
                      "; the edges of each polygon, with -1 after them" +
                      extreme_case_command(input.what),
          .expected = {numbers("edges of the polygons", listed_polygons(input.inside))}};
}

// BEGIN HIDDEN
Case expect_cells(const CellsCase& input) {
  Case made{
      .where = input.what,
      .restated =
          "the edges of each polygon, with -1 after them, for sixteen sets of inside corners"};
  for (unsigned inside = input.first; inside < input.first + 16; ++inside)
    made.expected.push_back(
        numbers(fmt::format("edges for corners {}", inside), listed_polygons(inside)));
  return made;
}
// END HIDDEN

// ---- edges ----

// The bound: two differences and a quotient round, 3 u (u = 2^-53 is the unit roundoff). The clamp
// that keeps the answer 2^-10 away from both ends does not round. Ours has three roundings of long
// double. Where long double is double they are as large, and a right answer is within 6 u of ours.
Case expect_crossing(const EdgeCase& input) {
  double share = 0.5;
  if (!std::isinf(input.from) && !std::isinf(input.to)) {
    using Long = long double;
    const Long exact = (Long(input.level) - Long(input.from)) / (Long(input.to) - Long(input.from));
    share = std::clamp(double(exact), kMinStep, 1 - kMinStep);
  }
  return {.where = input.what,
          .restated = fmt::format("values {} and {} at the ends, level {}", input.from, input.to,
                                  input.level) +
                      extreme_case_command(input.what),
          .expected = {numbers("share", {share}, 8 * unit_roundoff<double> * share)}};
}

// ---- layered images ----

Case expect_edits(const EditCase& input) {
  std::map<int, std::vector<Covered>> there;
  Layers layers(input.pixels);
  const auto rebuild = [&] {
    layers.assign(input.pixels, {});
    for (const auto& [id, covered] : there) {
      for (const Covered& c : covered) layers[c.pixel].push_back({c.distance, id});
    }
    for (auto& here : layers) {
      std::ranges::stable_sort(here, [](const lab_14::Sample& a, const lab_14::Sample& b) {
        return std::pair(a.distance, a.id) < std::pair(b.distance, b.id);
      });
    }
  };
  std::vector<double> seen, counts, ids, distances;
  std::string text = fmt::format("{} pixels", input.pixels);
  for (const Edit& edit : input.edits) {
    if (edit.comes)
      there[edit.id] = edit.covered;
    else
      there.erase(edit.id);
    rebuild();
    for (const auto& here : layers) seen.push_back(here.empty() ? -1 : here.front().id);
    if (text.size() > 600) continue;
    text += fmt::format("\npolygon {} {}:", edit.id, edit.comes ? "comes" : "goes");
    for (const Covered& c : edit.covered)
      text += fmt::format(" pixel {} at {}", c.pixel, c.distance);
  }
  rebuild();
  for (const auto& here : layers) {
    counts.push_back(double(here.size()));
    for (const lab_14::Sample& s : here) {
      ids.push_back(s.id);
      distances.push_back(s.distance);
    }
  }
  return {.where = input.what,
          .restated = text + extreme_case_command(input.what),
          .expected = {numbers("ids seen", seen), numbers("samples of each pixel", counts),
                       numbers("ids", ids), numbers("distances", distances)}};
}

// ---- views ----

using Exact3 = std::array<Rational, 3>;

Exact3 exact_vector(const lab_14::Vector& v) {
  return {Rational(v[0]), Rational(v[1]), Rational(v[2])};
}
Rational volume_of_exact(const Exact3& a, const Exact3& b, const Exact3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}
Rational dot_of_exact(const Exact3& a, const Exact3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct ExactWeights {
  std::array<double, 3> weights{};
  double bound = 0;
};

// The weights by Cramer's rule: a quotient of two determinants each. A determinant has an error of
// at most 5 u times the sum of the sizes of its terms, which is at most 6 / sqrt(27) < 1.2 for unit
// vectors (the permanent of a matrix with rows of unit length), so 6 u. A weight w then has the
// error 6 u (1 + |w|) / |det|. A weight w is divided by a sum s >= w: the quotient has the errors
// of w and of the three weights in s, divided by s. For s <= 1 that is at most 4 times 12 u /
// (|det| s), for s > 1 at most 4 times 12 u / |det|; 64 u is allowed.
ExactWeights exact_weights(const ViewCase& input) {
  const Exact3 v = exact_vector(input.direction);
  std::array<Exact3, 3> views;
  for (std::size_t i = 0; i < 3; ++i) views[i] = exact_vector(input.views[i]);
  const Rational volume = volume_of_exact(views[0], views[1], views[2]);
  std::array<Rational, 3> w;
  Rational sum(0);
  ExactWeights exact;
  exact.bound = 64 * unit_roundoff<double> / std::abs(double(volume));
  for (std::size_t i = 0; i < 3; ++i) {
    w[i] = volume_of_exact(v, views[(i + 1) % 3], views[(i + 2) % 3]) / volume;
    if (w[i].sign() < 0 || !input.sees[i]) w[i] = Rational(0);
    sum += w[i];
  }
  if (sum.sign() > 0) {
    for (std::size_t i = 0; i < 3; ++i) exact.weights[i] = double(w[i] / sum);
    exact.bound /= std::min(1.0, double(sum));
    return exact;
  }
  exact.bound = 0;
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!input.sees[i]) continue;
    const auto near = [&](std::size_t k) { return dot_of_exact(views[k], v); };
    if (!nearest || near(i) > near(*nearest)) nearest = i;
  }
  if (nearest) exact.weights[*nearest] = 1;
  return exact;
}

Case expect_weights(const ViewCase& input) {
  const ExactWeights exact = exact_weights(input);
  std::string text = fmt::format("direction ({}, {}, {})", input.direction[0], input.direction[1],
                                 input.direction[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const lab_14::Vector& view = input.views[i];
    text += fmt::format("\nview {}: ({}, {}, {}), which {} the polygon", i, view[0], view[1],
                        view[2], input.sees[i] ? "sees" : "does not see");
  }
  return {.where = input.what,
          .restated = text + extreme_case_command(input.what),
          .expected = {numbers("weights", {exact.weights[0], exact.weights[1], exact.weights[2]},
                               exact.bound)}};
}

// ---- bands ----

using Long = long double;

std::vector<Long> long_mean(const Pixels& pixels) {
  std::vector<Long> mean(pixels.front().size(), 0);
  for (const auto& x : pixels) {
    for (std::size_t i = 0; i < x.size(); ++i) mean[i] += Long(x[i]);
  }
  for (Long& each : mean) each /= Long(pixels.size());
  return mean;
}

double largest_value(const Pixels& pixels) {
  double most = 0;
  for (const auto& x : pixels) {
    for (const double value : x) most = std::max(most, std::abs(value));
  }
  return most;
}

// The bound: a sum of n terms rounds by up to n u of the sum of their sizes, which is at most n
// times the largest entry on the diagonal (Cauchy-Schwarz). A mean that has an error d, at most n u
// of the largest value, adds d^2 to an entry.
Case expect_statistics(const BandCase& input) {
  const std::vector<Long> mean = long_mean(input.pixels);
  const std::size_t bands = mean.size();
  const auto n = double(input.pixels.size());
  std::vector<double> means, covariance;
  double most = 0;
  for (const Long each : mean) means.push_back(double(each));
  for (std::size_t i = 0; i < bands; ++i) {
    for (std::size_t j = 0; j < bands; ++j) {
      Long sum = 0;
      for (const auto& x : input.pixels) sum += (Long(x[i]) - mean[i]) * (Long(x[j]) - mean[j]);
      covariance.push_back(double(sum / Long(input.pixels.size())));
      if (i == j) most = std::max(most, covariance.back());
    }
  }
  const double u = unit_roundoff<double>, off = n * u * largest_value(input.pixels);
  return {.where = input.what,
          .restated = fmt::format("{} pixels of {} bands", input.pixels.size(), bands) +
                      extreme_case_command(input.what),
          .expected = {numbers("mean", means, 2 * off), matrix("covariance", int(bands), covariance,
                                                               8 * n * u * most + 4 * off * off)}};
}

// The bound for a pixel x with the mean m: dot products of up to 7 bands and a sum over k
// components round by less than 32 u of |x - m|. Each of the k additions to the mean rounds by u of
// a number that is at most |x - m| larger than the mean; the mean may be u larger than the largest
// absolute value, and our answer is rounded, too.
Case expect_reconstruction(const BandCase& input) {
  const std::vector<double>& mean = input.mean;
  const lab_14::Matrix& vectors = input.vectors;
  std::vector<double> all;
  Long error = 0, spread = 0, farthest = 0;
  for (const auto& x : input.pixels) {
    std::vector<Long> reconstructed(mean.begin(), mean.end());
    for (std::size_t c = 0; c < input.k; ++c) {
      Long along = 0;
      for (std::size_t i = 0; i < x.size(); ++i)
        along += Long(vectors[c][i]) * (Long(x[i]) - Long(mean[i]));
      for (std::size_t i = 0; i < x.size(); ++i) reconstructed[i] += along * Long(vectors[c][i]);
    }
    Long from_mean = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      error += (Long(x[i]) - reconstructed[i]) * (Long(x[i]) - reconstructed[i]);
      from_mean += (Long(x[i]) - Long(mean[i])) * (Long(x[i]) - Long(mean[i]));
      all.push_back(double(reconstructed[i]));
    }
    spread += from_mean;
    farthest = std::max(farthest, std::sqrt(from_mean));
  }
  const auto n = Long(input.pixels.size());
  const double u = unit_roundoff<double>;
  const double most = largest_value(input.pixels);
  const double bound = 64 * u * double(farthest) + (double(input.k) + 2) * u * most;
  // A residual, the pixel minus its approximation, has in each band the same rounding error as the
  // approximation, `bound`. So as a vector, which is at most |x - m| long, it has the error `off`,
  // and its square has the error off (2 |x - m| + off).
  const double off = std::sqrt(double(mean.size())) * bound;
  const double of_error = 256 * u * double(spread / n) + off * (2 * double(farthest) + off);
  return {.where = input.what,
          .restated = fmt::format("{} pixels of {} bands, {} components", input.pixels.size(),
                                  mean.size(), input.k) +
                      extreme_case_command(input.what),
          .expected = {matrix("reconstructed bands", int(mean.size()), all, bound),
                       numbers("mean square error", {double(error / n)}, of_error)}};
}

}  // namespace

Lab lab_14() {
  return {
      14,
      "14-surfaces",
      "Surfaces, polygons in pictures, views, components",
      {{"14.1", "The polygons of a cell", 25},
       {"14.2", "Where the surface crosses an edge", 10},
       {"14.3", "Polygons come and go", 20},
       {"14.4", "The three views around an eye", 20},
       {"14.5", "Mean and covariance", 10},
       {"14.6", "What k components have", 15}},
      {check("polygons of a cell", "14.1", "world", cells, expect_cell),
       generated_check("the polygons of any cell", "14.1", "world", generated_cells, expect_cell),
       hidden_check("cells of every kind", "14.1", "world", hidden_cells, expect_cells),
       check("where an edge is crossed", "14.2", "world", edges, expect_crossing),
       generated_check("any edge", "14.2", "world", generated_edges, expect_crossing),
       hidden_check("edges of other values", "14.2", "world", hidden_edges, expect_crossing),
       check("polygons come and go", "14.3", "depth", edits, expect_edits),
       generated_check("any polygons come and go", "14.3", "depth", generated_edits, expect_edits),
       hidden_check("other polygons come and go", "14.3", "depth", hidden_edits, expect_edits),
       check("weights of three views", "14.4", "shading", views_around, expect_weights),
       generated_check("weights of any views", "14.4", "shading", generated_views_around,
                       expect_weights),
       hidden_check("weights of other views", "14.4", "shading", hidden_views_around,
                    expect_weights),
       check("mean and covariance", "14.5", "shading", bands, expect_statistics),
       generated_check("covariance of any bands", "14.5", "shading", generated_bands,
                       expect_statistics),
       hidden_check("covariance of other bands", "14.5", "shading", hidden_bands,
                    expect_statistics),
       check("what the components have", "14.6", "shading", bands, expect_reconstruction),
       generated_check("any components", "14.6", "shading", generated_components,
                       expect_reconstruction),
       hidden_check("components of other bands", "14.6", "shading", hidden_bands,
                    expect_reconstruction)}};
}

}  // namespace glassbox::labs
