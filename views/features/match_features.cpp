#include "views/features/match_features.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <tbb/parallel_for.h>

namespace glassbox::views {

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

bool are_at_one_place(const Feature& a, const Feature& b) {
  const double reach = kSamePlace * std::max(a.scale, b.scale);
  return std::abs(a.x - b.x) <= reach && std::abs(a.y - b.y) <= reach;
}

// The nearest descriptor, and the distance to the nearest one at another place.
struct Nearest {
  int index = -1;  // -1: there is none
  double distance = kNever, second = kNever;
};

template <class Descriptor>
struct Described {
  const std::vector<Feature>& features;
  const std::vector<Descriptor>& descriptors;
};

template <class Descriptor>
Nearest nearest_of(const Feature& own, const Descriptor& descriptor,
                   const Described<Descriptor>& others, double search) {
  Nearest nearest;
  std::vector<double> distances(others.features.size(), kNever);
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const Feature& other = others.features[i];
    if (std::abs(other.x - own.x) > search || std::abs(other.y - own.y) > search) continue;
    distances[i] = distance(descriptor, others.descriptors[i]);
    if (distances[i] < nearest.distance) {
      nearest.index = int(i);
      nearest.distance = distances[i];
    }
  }
  if (nearest.index < 0) return nearest;
  const Feature& best = others.features[std::size_t(nearest.index)];
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (distances[i] < nearest.second && !are_at_one_place(best, others.features[i])) {
      nearest.second = distances[i];
    }
  }
  return nearest;
}

template <class Descriptor>
std::vector<Nearest> all_nearest(const Described<Descriptor>& from, const Described<Descriptor>& to,
                                 double search) {
  std::vector<Nearest> nearest(from.features.size());
  tbb::parallel_for(std::size_t(0), nearest.size(), [&](std::size_t i) {
    nearest[i] = nearest_of(from.features[i], from.descriptors[i], to, search);
  });
  return nearest;
}

// Equal descriptors at two places, with distances of 0, tell nothing.
double ratio_of(const Nearest& nearest) {
  return nearest.second > 0 ? nearest.distance / nearest.second : 1;
}

template <class Descriptor>
std::vector<FeatureMatch> all_matches(const Described<Descriptor>& left,
                                      const Described<Descriptor>& right, const MatchRules& rules) {
  const std::vector<Nearest> of_left = all_nearest(left, right, rules.search);
  std::vector<Nearest> of_right;
  if (rules.cross_check) of_right = all_nearest(right, left, rules.search);
  std::vector<FeatureMatch> matches;
  for (std::size_t i = 0; i < of_left.size(); ++i) {
    const Nearest& nearest = of_left[i];
    if (nearest.index < 0 || !(ratio_of(nearest) <= rules.ratio)) continue;
    if (rules.cross_check && of_right[std::size_t(nearest.index)].index != int(i)) continue;
    matches.push_back({int(i), nearest.index, nearest.distance, ratio_of(nearest)});
  }
  return matches;
}

std::vector<FeatureMatch> without_repetitions(const std::vector<Feature>& left,
                                              const std::vector<Feature>& right,
                                              std::vector<FeatureMatch> matches) {
  std::ranges::sort(matches, [&](const FeatureMatch& a, const FeatureMatch& b) {
    return std::tuple(left[std::size_t(a.left)].scale, a.distance, a.left) <
           std::tuple(left[std::size_t(b.left)].scale, b.distance, b.left);
  });
  std::vector<FeatureMatch> kept;
  for (const FeatureMatch& match : matches) {
    const bool is_repeated = std::ranges::any_of(kept, [&](const FeatureMatch& before) {
      return are_at_one_place(left[std::size_t(before.left)], left[std::size_t(match.left)]) &&
             are_at_one_place(right[std::size_t(before.right)], right[std::size_t(match.right)]);
    });
    if (!is_repeated) kept.push_back(match);
  }
  std::ranges::sort(kept, {}, &FeatureMatch::left);
  return kept;
}

}  // namespace

std::vector<FeatureMatch> match_features(const FeatureSet& left, const FeatureSet& right,
                                         const MatchRules& rules) {
  std::vector<FeatureMatch> matches = std::visit(
      [&](const auto& descriptors) {
        using Descriptor = typename std::decay_t<decltype(descriptors)>::value_type;
        return all_matches(Described<Descriptor>{left.features, descriptors},
                           Described<Descriptor>{right.features, std::get<std::vector<Descriptor>>(
                                                                     right.descriptors)},
                           rules);
      },
      left.descriptors);
  return without_repetitions(left.features, right.features, std::move(matches));
}

Matches positions_of(const FeatureSet& left, const FeatureSet& right,
                     const std::vector<FeatureMatch>& matches) {
  Matches positions;
  for (const FeatureMatch& match : matches) {
    const Feature &l = left.features[std::size_t(match.left)],
                  &r = right.features[std::size_t(match.right)];
    positions.push_back({{l.x, l.y}, {r.x, r.y}});
  }
  return positions;
}

}  // namespace glassbox::views
