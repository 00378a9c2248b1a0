#include "views/commands/geometry.h"

#include <cmath>

#include <fmt/format.h>

#include "cli/report/text_layout.h"
#include "views/commands/matrix_report.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/elementary.h>
#include <glassbox/base/printable.h>

namespace glassbox::views {

namespace {

std::string heading(const std::string& name, const std::string& what) {
  return wrapped(fmt::format("{:<12}", name), what);
}

// Rounds before printing, so that a tiny negative number is not printed as -0.
std::string number(double value, int decimals) {
  const double unit = power_of_ten(decimals);
  return fmt::format("{:12.{}f}", std::round(value * unit) / unit + 0.0, decimals);
}

std::string six_decimals(double value) {
  return number(value, 6);
}

// The entries of F differ greatly in size, so they are printed with an exponent.
std::string four_digits(double value) {
  return fmt::format("{:12.3e}", value);
}

std::string vector_line(const std::string& name, const Vector3d& vector, const std::string& what) {
  return fmt::format("  {:<8}{}{}{}   {}\n", name, number(vector.x(), 6), number(vector.y(), 6),
                     number(vector.z(), 6), what);
}

// An epipole further away than kFar pixels is printed as a direction: its position would only be a
// rounding error of the direction.
std::string epipole_text(const Vector3d& epipole) {
  constexpr double kFar = 1e7;
  const views::Vector2d direction = epipole.head<2>();
  if (direction.norm() > kFar * std::abs(epipole.z())) {
    const views::Vector2d along = direction.normalized() * (direction.x() < 0 ? -1.0 : 1.0);
    // Adding 0 turns -0 into 0.
    return fmt::format("at infinity, along ({:.4f}, {:.4f})", along.x(),
                       std::round(along.y() * 1e4) / 1e4 + 0.0);
  }
  return fmt::format("({:.2f}, {:.2f})", epipole.x() / epipole.z(), epipole.y() / epipole.z());
}

std::string input_lines(const GeometryInput& input, const GeometryReport& report) {
  std::string text = printable(input.description, kTextWidth) + "\n";
  if (!input.pair_description.empty()) text += heading("pair", input.pair_description);
  if (const auto& visibility = input.visibility) {
    text +=
        heading("pixels", fmt::format("in the left picture: {} are visible in the right one, {} "
                                      "hidden there, {} outside it, {} missing; {} show nothing",
                                      visibility->seen, visibility->hidden, visibility->outside,
                                      visibility->missing, visibility->nothing));
  }
  std::string note;
  if (report.outliers) note = fmt::format(", {} of them outliers", report.outliers->planted);
  if (const auto& found = input.found) {
    text += heading("corners", fmt::format("{} in the left picture, {} in the right one ({})",
                                           found->corners[0], found->corners[1],
                                           name_of(found->settings.detector)));
    note = ": " + matching_text(*found);
  }
  return text + heading("matches", fmt::format("{}{}", input.matches.size(), note));
}

std::string estimation_lines(const GeometryReport& report) {
  const auto& [request, analysis] = std::tie(report.request, report.analysis);
  const auto& system = analysis.system;
  const auto& classification = analysis.classification;
  const bool is_undecided = analysis.samples == 0;
  std::string text = heading(
      "samples", is_undecided ? "no sample determines the cameras; all matches are tested together"
                              : fmt::format("{} drawn, {}; {}", analysis.samples,
                                            name_of(request.estimator), law_text(report)));
  std::string planted;
  if (const auto& facts = report.outliers; facts && facts->planted > 0) {
    planted = fmt::format("; {} among them by chance, {} rejected", counted(facts->kept, "outlier"),
                          counted(facts->lost, "true match", "true matches"));
  }
  text +=
      heading("inliers", fmt::format("{} of {} within {:g} px{}", analysis.inliers,
                                     request.matches.size(), request.ransac.threshold, planted));
  text += heading("equations",
                  fmt::format("rank {} (8 determine F, 9 is due to noise); condition {:.3g} raw, "
                              "{:.3g} with normalised points",
                              system.rank, system.condition_raw, system.condition_normalised));
  text += heading("pair is", kind_sentence(classification.kind));
  text +=
      heading("", fmt::format("costs (GRIC): constraint {:.1f}, homography {:.1f}, "
                              "rotation {:.1f}; eighth over ninth singular value {:.3g}",
                              classification.cost_of_fundamental, classification.cost_of_homography,
                              classification.cost_of_rotation, classification.eighth_over_ninth));
  if (const auto& model = report.model) {
    text += heading("model", model->name + ": " + model->why);
    if (!model->poses.empty()) text += heading("two poses", model->poses);
  }
  return text;
}

std::string residual_lines(const GeometryReport& report) {
  const auto line = [](const char* name, const ResidualFacts& facts) {
    return fmt::format("  {:<22}{:12.3g}{:12.3g}{:12.3g}\n", name, facts.rms, facts.median,
                       facts.largest);
  };
  return fmt::format("\n{:<24}{:>12}{:>12}{:>12}\n", "inliers' residuals, px", "rms", "median",
                     "largest") +
         line("Sampson's distance", report.sampson) + line("to epipolar lines", report.epipolar);
}

std::string matrices(const GeometryReport& report) {
  std::string text =
      "\n" + matrix_lines("F", *report.analysis.fundamental,
                          "p_r^T F p_l = 0 of pixels; Frobenius norm 1", four_digits);
  if (const auto& pose = report.analysis.pose) {
    text +=
        matrix_lines("E = R S", *report.essential, "P_r = R (P_l - T), S v = T x v", six_decimals);
    text += matrix_lines("[t]x R", *report.essential_of_shift,
                         "P_r = R P_l + t, t = -R T: as in other textbooks", six_decimals);
    text += matrix_lines("R", pose->rotation, "", six_decimals);
    text += vector_line("T", pose->translation, "the right camera, seen from the left one");
  }
  if (const auto& second = report.second_pose) {
    text +=
        matrix_lines("second R", second->rotation, "the other pose for the plane", six_decimals);
    text += vector_line("second T", second->translation, "the right camera for the second pose");
  }
  const auto& [left, right] = *report.epipoles;
  return text +
         fmt::format("  epipoles  left {}, right {}\n", epipole_text(left), epipole_text(right));
}

std::string error_text(const PoseErrors& errors) {
  std::string direction;
  if (errors.direction_degrees)
    direction = fmt::format(", direction of T by {:.3g} deg", *errors.direction_degrees);
  return fmt::format("rotation off by {:.3g} deg{}", errors.rotation_degrees, direction);
}

std::string pose_lines(const GeometryReport& report) {
  if (report.candidates.empty()) return "";
  std::string text = "\n";
  std::string counts;
  for (const PoseCandidate& one : report.candidates)
    counts += fmt::format("{}{}{}", counts.empty() ? "" : ", ", one.in_front,
                          one.is_chosen ? " (chosen)" : "");
  text += heading("four poses", "inliers in front of both cameras: " + counts);
  if (const auto& errors = report.errors) text += heading("truth", error_text(*errors));
  if (const auto& errors = report.second_errors) {
    text += heading("", "of the second pose: " + error_text(*errors));
  }
  return text;
}

std::string left_out_lines(const GeometryReport& report) {
  if (report.left_out.empty()) return "";
  std::string text = "\nleft out\n";
  for (const OmittedItem& one : report.left_out) text += wrapped("  - ", one.what + ": " + one.why);
  return text;
}

}  // namespace

std::string kind_sentence(views::PairKind kind) {
  switch (kind) {
    case views::PairKind::kGeneral:
      return "general: the epipolar constraint explains the matches, and no simpler model does";
    case views::PairKind::kPureRotation:
      return "from one point of view: a rotating camera explains the matches";
    case views::PairKind::kPlane:
      return "of a plane: one homography explains the matches";
    case views::PairKind::kCritical:
      return "of a critical surface: two matrices F explain the matches";
  }
  return "";
}

std::string law_text(const GeometryReport& report) {
  const int size = views::sample_size(report.request.estimator);
  const double share = double(report.analysis.inliers) / double(report.request.matches.size());
  return fmt::format("log(1 - {:g})/log(1 - {:.3f}^{}) = {:.1f} are needed",
                     report.request.ransac.confidence, share, size, report.samples_wanted);
}

std::string geometry_text(const GeometryInput& input, const GeometryReport& report) {
  std::string text = input_lines(input, report) + estimation_lines(report);
  if (report.has_geometry()) {
    text += residual_lines(report) + matrices(report) + pose_lines(report);
  }
  return text + left_out_lines(report);
}

}  // namespace glassbox::views
