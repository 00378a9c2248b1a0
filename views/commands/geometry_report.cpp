#include "views/commands/geometry.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "views/two_view/constraint.h"
#include "views/two_view/pose.h"
#include "views/two_view/residual.h"
#include "views/two_view/rotation.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/trig.h>

namespace glassbox::views {

namespace {

constexpr int kFewest = 8;

Result<void> check_matches(const views::Matches& matches) {
  if (int(matches.size()) < kFewest) {
    return fail("the matches",
                fmt::format("there are {}, but {} are needed", matches.size(), kFewest),
                "give more");
  }
  std::set<std::array<double, 4>> different;
  for (const views::Match& m : matches)
    different.insert({m.left.x(), m.left.y(), m.right.x(), m.right.y()});
  if (int(different.size()) < kFewest) {
    return fail("the matches",
                fmt::format("only {} of the {} are different, but {} are needed", different.size(),
                            matches.size(), kFewest),
                "leave out repeated matches, and give more");
  }
  return {};
}

Result<views::PairRequest> make_pair_request(const GeometryInput& input,
                                             const GeometryRequest& request) {
  if (request.estimator == Estimator::kFivePoint && !input.intrinsics) {
    return fail("--estimator",
                "five matches determine the cameras only if their intrinsic matrices K are known",
                "give --cameras, or --estimator 8 or 7");
  }
  const Estimator usual = input.intrinsics ? Estimator::kFivePoint : Estimator::kEightPoint;
  views::PairRequest asked{
      input.matches, input.intrinsics, request.estimator.value_or(usual), request.sigma, {}};
  asked.ransac.threshold = request.threshold.value_or(2 * request.sigma);
  asked.ransac.confidence = request.confidence;
  asked.ransac.seed = request.seed;
  return asked;
}

ResidualFacts facts_of(const std::vector<double>& residuals, const std::vector<bool>& is_inlier) {
  std::vector<double> kept;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    if (is_inlier[i]) kept.push_back(residuals[i]);
  }
  if (kept.empty()) return {};
  std::ranges::sort(kept);
  double squares = 0;
  for (const double residual : kept) squares += residual * residual;
  return {std::sqrt(squares / double(kept.size())), kept[kept.size() / 2], kept.back()};
}

// Lists the four poses that E allows. They differ from each other by half a turn or by opposite
// translations, so the one that is close to the pose of the analysis is the chosen one.
std::vector<PoseCandidate> candidates_of(const GeometryReport& report) {
  const views::RelativePose& chosen = *report.analysis.pose;
  const auto& [left, right] = *report.request.intrinsics;
  const views::Matches inliers = views::calibrated(
      views::inliers_of(report.request.matches, report.analysis.is_inlier), left, right);
  std::vector<PoseCandidate> candidates;
  for (const views::RelativePose& pose : views::poses_of(*report.essential)) {
    const bool is_chosen = (pose.rotation - chosen.rotation).norm() < 1 &&
                           pose.translation.dot(chosen.translation) > 0;
    candidates.push_back({pose, views::in_front_of_both(pose, inliers), is_chosen});
  }
  return candidates;
}

void add_geometry(GeometryReport& report) {
  const views::Matrix3d& f = *report.analysis.fundamental;
  report.epipoles = {views::epipole_left(f), views::epipole_right(f)};
  for (const views::Match& match : report.request.matches)
    report.epipolar_distances.push_back(views::epipolar_distance(f, match));
  report.sampson = facts_of(report.analysis.residuals, report.analysis.is_inlier);
  report.epipolar = facts_of(report.epipolar_distances, report.analysis.is_inlier);
  if (!report.analysis.pose) return;
  const auto& [rotation, translation] = *report.analysis.pose;
  report.essential = views::essential<double>(rotation, translation);
  report.essential_of_shift = views::essential_of_shift<double>(rotation, -rotation * translation);
  report.candidates = candidates_of(report);
}

PoseErrors errors_of(const views::RelativePose& found, const views::RelativePose& truth) {
  PoseErrors errors{degrees_from_radians(views::rotation_error(found.rotation, truth.rotation)),
                    {}};
  if (truth.translation.norm() > 0) {
    errors.direction_degrees =
        degrees_from_radians(views::direction_error(found.translation, truth.translation));
  }
  return errors;
}

// ---- the model ----

std::string why_plane(const GeometryReport& report) {
  const auto& plane = *report.analysis.plane;
  const auto& costs = report.analysis.classification;
  return fmt::format(
      "{} of {} matches agree with one homography, with {:.3g} px (rms) a coordinate; it costs "
      "{:.1f} (GRIC), and general structure {:.1f}",
      plane.on_plane, report.request.matches.size(), plane.rms, costs.cost_of_homography,
      costs.cost_of_fundamental);
}

std::string why_general(const GeometryReport& report) {
  const auto& costs = report.analysis.classification;
  std::string why = fmt::format(
      "it costs {:.1f} (GRIC), and one plane {:.1f}, whose homography agrees with {} of {} inliers",
      costs.cost_of_fundamental, costs.cost_of_homography, costs.homography.inliers,
      report.analysis.inliers);
  if (report.analysis.is_only_essential) {
    why += "; a second F is possible, but with K only one E is";
  }
  return why;
}

std::string why_general_beside_plane(const GeometryReport& report) {
  const auto& plane = *report.analysis.plane;
  return fmt::format(
      "{} of {} matches agree with one homography, but {} points beside its plane agree with the "
      "cameras, too: more than by chance",
      plane.on_plane, report.request.matches.size(), plane.solutions[0].others);
}

// How far the second pose of a plane is from the first.
std::string difference_text(const PlaneAnalysis& plane) {
  const auto& [one, other] = plane.solutions;
  const auto& a = one.found.pose;
  const auto& b = other.found.pose;
  return fmt::format("the poses differ by {:.3g} deg, and their directions of T by {:.3g} deg",
                     degrees_from_radians(views::rotation_error(a.rotation, b.rotation)),
                     degrees_from_radians(views::direction_error(a.translation, b.translation)));
}

std::string why_pose(const PlaneAnalysis& plane) {
  const auto& [one, other] = plane.solutions;
  switch (plane.evidence) {
    case PlaneEvidence::kInFront:
      return fmt::format(
          "two explain the homography: {} of its {} points are in front of both cameras in the "
          "chosen one, and {} in the other; {}",
          one.in_front, plane.on_plane, other.in_front, difference_text(plane));
    case PlaneEvidence::kOthers:
      return fmt::format(
          "two explain the homography: {} points beside the plane agree with the chosen one, and "
          "{} with the other; {}",
          one.others, other.others, difference_text(plane));
    case PlaneEvidence::kSame:
      return fmt::format(
          "two explain the homography, and refined, with {} points beside the plane, they are the "
          "same",
          one.others);
    case PlaneEvidence::kNothing:
      break;
  }
  return fmt::format(
      "two explain the homography, and nothing decides between them: {} and {} of its {} points "
      "are in front of both cameras, {} and {} points beside the plane agree, and the residuals "
      "are "
      "{:.4g} and {:.4g} px (rms); {}",
      one.in_front, other.in_front, plane.on_plane, one.others, other.others, one.rms, other.rms,
      difference_text(plane));
}

void add_model(GeometryReport& report) {
  const auto& plane = report.analysis.plane;
  if (!plane) {
    report.model = {"general", why_general(report), ""};
    return;
  }
  if (plane->evidence == PlaneEvidence::kOthers) {
    report.model = {"general", why_general_beside_plane(report), why_pose(*plane)};
    return;
  }
  report.model = {"plane", why_plane(report), why_pose(*plane)};
  if (plane->evidence == PlaneEvidence::kNothing) {
    report.second_pose = plane->solutions[1].found.pose;
  }
}

OutlierFacts outlier_facts(const std::vector<bool>& is_outlier,
                           const std::vector<bool>& is_inlier) {
  OutlierFacts facts;
  for (std::size_t i = 0; i < is_outlier.size(); ++i) {
    facts.planted += is_outlier[i];
    facts.kept += is_outlier[i] && is_inlier[i];
    facts.lost += !is_outlier[i] && !is_inlier[i];
  }
  return facts;
}

// ---- what is left out ----

void leave_out_geometry(const GeometryReport& report, std::vector<OmittedItem>& out) {
  switch (report.analysis.classification.kind) {
    case PairKind::kPureRotation:
      out.push_back({"F, E, T, epipoles",
                     "both pictures are from one point of view: a rotation alone explains the "
                     "matches, E is 0, and any direction of T would fit (C-101)"});
      break;
    case PairKind::kPlane:
      out.push_back(
          {"F, E, R, T, epipoles",
           "all points are on a plane: one homography explains the matches, and a family of F with "
           "two parameters fits them (C-102); with known cameras --estimator 5 can still find R "
           "and "
           "T"});
      break;
    case PairKind::kCritical:
      out.push_back({"F, E, R, T, epipoles",
                     "the points are on a critical surface: a second F fits as well, as for points "
                     "and camera centres on a ruled quadric (C-103)"});
      break;
    case PairKind::kGeneral:
      break;
  }
}

void leave_out_pose(const GeometryInput& input, std::vector<OmittedItem>& out) {
  if (!input.intrinsics) {
    out.push_back({"E, R, T",
                   "K is unknown without --cameras, so the viewing directions of the pixels are "
                   "unknown, and the matches determine only F"});
  }
}

void leave_out_choice(const GeometryReport& report, std::vector<OmittedItem>& out) {
  if (!report.second_pose) return;
  out.push_back({"which of two poses is right",
                 "both are possible for the points of one plane, and explain the matches equally "
                 "well (C-102); matches of a few points beside the plane decide"});
}

void leave_out_of_truth(const GeometryInput& input, const GeometryReport& report,
                        std::vector<OmittedItem>& out) {
  if (!report.analysis.pose) return;
  out.push_back({"|T|", "pictures do not show how far apart the cameras are: T has length 1"});
  const int behind = report.analysis.inliers - report.analysis.in_front;
  if (behind > 0) {
    out.push_back(
        {"the 3D points of " + counted(behind, "inlier") + " not in front of both cameras",
         "their lines of sight meet behind a camera or nowhere, because the points are too far "
         "away for the noise of their pixels"});
  }
  if (input.truth && !report.errors->direction_degrees) {
    out.push_back({"the direction's error", "the cameras are in one place"});
  }
}

int count_outside(const GeometryInput& input) {
  if (!input.pictures) return 0;
  const auto is_outside = [](const views::Vector2d& at, const Image<Rgba8>& picture) {
    return at.x() < 0 || at.y() < 0 || at.x() > picture.width || at.y() > picture.height;
  };
  return int(std::ranges::count_if(input.matches, [&](const views::Match& match) {
    return is_outside(match.left, (*input.pictures)[0]) ||
           is_outside(match.right, (*input.pictures)[1]);
  }));
}

std::vector<OmittedItem> omitted_items(const GeometryInput& input, const GeometryReport& report) {
  std::vector<OmittedItem> out;
  if (!report.has_geometry()) leave_out_geometry(report, out);
  leave_out_pose(input, out);
  leave_out_choice(report, out);
  leave_out_of_truth(input, report, out);
  if (report.samples_wanted > report.request.ransac.most_samples) {
    out.push_back({"certainty", fmt::format("{:.3g} samples are needed, but only {} were drawn: so "
                                            "few inliers may agree by chance",
                                            report.samples_wanted, report.analysis.samples)});
  }
  const int off = int(input.matches.size()) - report.analysis.inliers;
  if (off > 0) {
    out.push_back({counted(off, "match", "matches"),
                   fmt::format("outliers, whose distance from the estimate is above {:g} px",
                               report.request.ransac.threshold)});
  }
  if (const int count = count_outside(input); count > 0) {
    out.push_back({"a check that all points are inside their pictures",
                   fmt::format("{} a point outside, where noise may have moved it, and {} used too",
                               counted(count, "match has", "matches have"),
                               singular_or_plural(count, "is", "are"))});
  }
  return out;
}

}  // namespace

Result<GeometryReport> report_geometry(const GeometryInput& input, const GeometryRequest& request) {
  if (const auto legal = check_matches(input.matches); !legal) return tl::unexpected(legal.error());
  const auto asked = make_pair_request(input, request);
  if (!asked) return tl::unexpected(asked.error());
  const auto analysis = views::analyse(*asked);
  if (!analysis) return tl::unexpected(analysis.error());
  GeometryReport report;
  report.request = *asked;
  report.analysis = *analysis;
  report.samples_wanted =
      views::samples_needed(double(analysis->inliers) / double(input.matches.size()),
                            views::sample_size(asked->estimator), asked->ransac.confidence);
  if (report.has_geometry()) {
    add_model(report);
    add_geometry(report);
  }
  if (input.truth && analysis->pose) report.errors = errors_of(*analysis->pose, *input.truth);
  if (input.truth && report.second_pose)
    report.second_errors = errors_of(*report.second_pose, *input.truth);
  if (!input.is_outlier.empty())
    report.outliers = outlier_facts(input.is_outlier, analysis->is_inlier);
  report.left_out = omitted_items(input, report);
  return report;
}

}  // namespace glassbox::views
