// Lab 14: your part. student.h says what each function must do, handout.md why.
#include "student.h"

#include <limits>

namespace lab_14 {

// ---- task 14.1: the polygons of a cell ----

// BEGIN SOLUTION
static int edge_between(int a, int b) {
  for (std::size_t e = 0; e < kEdges.size(); ++e) {
    if (kEdges[e][0] == std::min(a, b) && kEdges[e][1] == std::max(a, b)) return int(e);
  }
  return -1;
}
// STUB: // your own helper functions, if you want any
// END SOLUTION

std::vector<std::vector<int>> cell_polygons(unsigned inside) {
  // BEGIN SOLUTION
  std::array<int, 12> next;
  next.fill(-1);
  const auto is_in = [&](int corner) { return (inside >> corner & 1) != 0; };
  for (const std::array<int, 4>& face : kFaces) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (is_in(face[i]) || !is_in(face[(i + 1) % 4])) continue;
      // A run of inside corners begins with corner i + 1 of the face. `last` becomes its last
      // corner.
      std::size_t last = (i + 1) % 4;
      while (is_in(face[(last + 1) % 4])) last = (last + 1) % 4;
      const int begins = edge_between(face[i], face[(i + 1) % 4]);
      const int ends = edge_between(face[last], face[(last + 1) % 4]);
      next[std::size_t(begins)] = ends;
    }
  }
  std::vector<std::vector<int>> polygons;
  for (int start = 0; start < 12; ++start) {
    std::vector<int> polygon;
    for (int at = start; next[std::size_t(at)] >= 0;) {
      polygon.push_back(at);
      at = std::exchange(next[std::size_t(at)], -1);
    }
    if (!polygon.empty()) polygons.push_back(polygon);
  }
  return polygons;
  // STUB: return {};  // on all faces, from the edge where a run begins to where it ends
  // END SOLUTION
}

// ---- task 14.2: where the surface crosses an edge ----

double crossing(double from, double to, double level) {
  // BEGIN SOLUTION
  if (std::isinf(from) || std::isinf(to)) return 0.5;
  const double share = (level - from) / (to - from);
  return std::clamp(share, kMinStep, 1 - kMinStep);
  // STUB: return NAN;  // linear interpolation, kept away from both ends
  // END SOLUTION
}

// ---- task 14.3: polygons come and go ----

void add(Layers& layers, int id, const std::vector<Covered>& covered) {
  // BEGIN SOLUTION
  for (const Covered& c : covered) {
    std::vector<Sample>& here = layers[c.pixel];
    const auto place = std::find_if(here.begin(), here.end(), [&](const Sample& s) {
      const bool is_behind = s.distance > c.distance;
      return is_behind || (s.distance == c.distance && s.id > id);
    });
    here.insert(place, Sample{c.distance, id});
  }
  // STUB: (void)layers, (void)id, (void)covered;  // each pixel's samples stay sorted
  // END SOLUTION
}

void remove(Layers& layers, int id, const std::vector<Covered>& covered) {
  // BEGIN SOLUTION
  for (const Covered& c : covered) {
    std::vector<Sample>& gone_from = layers[c.pixel];
    const auto gone = std::find_if(gone_from.begin(), gone_from.end(),
                                   [&](const Sample& s) { return s.id == id; });
    if (gone != gone_from.end()) gone_from.erase(gone);
  }
  // STUB: (void)layers, (void)id, (void)covered;  // at any place in the pixel's list
  // END SOLUTION
}

// ---- task 14.4: the three views around an eye ----

// BEGIN SOLUTION
static double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
static Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// STUB: // your own helper functions, if you want any
// END SOLUTION

std::array<double, 3> view_weights(const Vector& direction, const std::array<Vector, 3>& views,
                                   const std::array<bool, 3>& sees) {
  // BEGIN SOLUTION
  const double volume = dot(views[0], cross(views[1], views[2]));
  std::array<double, 3> w{};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector side = cross(views[(i + 1) % 3], views[(i + 2) % 3]);
    w[i] = std::max(0.0, dot(direction, side) / volume);
    if (!sees[i]) w[i] = 0;
    sum += w[i];
  }
  if (sum > 0) {
    for (double& each : w) each /= sum;
    return w;
  }
  std::size_t nearest = 3;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!sees[i]) continue;
    const bool is_nearer =
        nearest == 3 || dot(views[i], direction) > dot(views[nearest], direction);
    if (is_nearer) nearest = i;
  }
  if (nearest < 3) w[nearest] = 1;
  return w;
  // STUB: return {NAN, NAN, NAN};  // solve, set some to 0, divide by the sum; or the nearest view
  // END SOLUTION
}

// ---- task 14.5: mean and covariance ----

Statistics statistics(const Pixels& pixels) {
  // BEGIN SOLUTION
  const std::size_t bands = pixels.front().size();
  const double n = double(pixels.size());
  Statistics found{std::vector<double>(bands, 0), Matrix(bands, std::vector<double>(bands, 0))};
  for (const std::vector<double>& x : pixels) {
    for (std::size_t i = 0; i < bands; ++i) found.mean[i] += x[i] / n;
  }
  for (const std::vector<double>& x : pixels) {
    for (std::size_t i = 0; i < bands; ++i) {
      for (std::size_t j = 0; j < bands; ++j)
        found.covariance[i][j] += (x[i] - found.mean[i]) * (x[j] - found.mean[j]) / n;
    }
  }
  return found;
  // STUB: return {};  // first the mean, then the differences from it
  // END SOLUTION
}

// ---- task 14.6: pixels made of k components ----

Reconstruction reconstruct(const Pixels& pixels, const std::vector<double>& mean,
                           const Matrix& vectors, std::size_t k) {
  // BEGIN SOLUTION
  Reconstruction made;
  for (const std::vector<double>& x : pixels) {
    std::vector<double> again = mean;
    for (std::size_t c = 0; c < k; ++c) {
      double along = 0;
      for (std::size_t i = 0; i < x.size(); ++i) along += vectors[c][i] * (x[i] - mean[i]);
      for (std::size_t i = 0; i < x.size(); ++i) again[i] += along * vectors[c][i];
    }
    double square = 0;
    for (std::size_t i = 0; i < x.size(); ++i) square += (x[i] - again[i]) * (x[i] - again[i]);
    made.error += square / double(pixels.size());
    made.pixels.push_back(again);
  }
  return made;
  // STUB: return {};  // the mean, and the first k components
  // END SOLUTION
}

}  // namespace lab_14
