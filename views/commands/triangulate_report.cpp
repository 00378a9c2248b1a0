#include "views/commands/triangulate_report.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/number_json.h"
#include "cli/report/table.h"
#include "cli/report/text_layout.h"
#include "views/commands/matrix_report.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/base/trig.h>

namespace glassbox::views {

namespace {

using TriangulationJson = nlohmann::ordered_json;

constexpr double kUnlikely = 3;  // standard deviations

const char* method_name(Triangulator how) {
  if (how == Triangulator::kMidpoint) return "midpoint";
  return how == Triangulator::kLinear ? "linear" : "optimal";
}

const char* method_sentence(Triangulator how) {
  if (how == Triangulator::kMidpoint) {
    return "half way between the two rays where they are closest (S2-05)";
  }
  if (how == Triangulator::kLinear) {
    return "the null vector of the four equations x (p_3 P) - p_1 P = 0 and y (p_3 P) - p_2 P = 0";
  }
  return "both pixels moved as little as possible so that their rays meet (Hartley and Sturm 1997)";
}

// The formula of the covariance, whose weights depend on the method (error_ellipsoid.h).
std::string covariance_formula(Triangulator how) {
  if (how == Triangulator::kHartleySturm) return "sigma^2 (J^T J)^-1";
  return fmt::format("sigma^2 B B^T, B = (L J)^+ L, where L has {}",
                     how == Triangulator::kLinear
                         ? "each camera's depth of the point"
                         : "the distance from each ray that a pixel makes at the point");
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Value>
double median_over(const std::vector<const LocatedPoint*>& points, const Value& value) {
  std::vector<double> values;
  for (const LocatedPoint* point : points) values.push_back(value(*point));
  return median_of(std::move(values));
}

std::optional<TriangulationMedians> medians_of(const TriangulationReport& report) {
  std::vector<const LocatedPoint*> front;
  for (const LocatedPoint& point : report.points) {
    if (point.state == PointState::kInFront) front.push_back(&point);
  }
  if (front.empty()) return std::nullopt;
  TriangulationMedians medians;
  medians.gap = median_over(front, [](const LocatedPoint& p) { return p.closest->gap; });
  medians.distance = median_over(
      front, [](const LocatedPoint& p) { return (p.point.head<3>() - p.rays[0].origin).norm(); });
  medians.residual = median_over(front, [](const LocatedPoint& p) { return p.residual(); });
  medians.angle = median_over(front, [](const LocatedPoint& p) { return p.angle; });
  medians.longest =
      median_over(front, [](const LocatedPoint& p) { return p.ellipsoid->half_axes.x(); });
  medians.shortest =
      median_over(front, [](const LocatedPoint& p) { return p.ellipsoid->half_axes.z(); });
  return medians;
}

// ---- text ----

std::string heading_line(const std::string& name, const std::string& what) {
  return wrapped(fmt::format("{:<12}", name), what);
}

std::string short_number(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value + 0.0) : "-";
}

// The state in a column of the table; empty for a point in front of both cameras.
const char* short_name(PointState state) {
  switch (state) {
    case PointState::kInFront:
      return "";
    case PointState::kBehindLeft:
      return "behind left";
    case PointState::kBehindRight:
      return "behind right";
    case PointState::kBehindBoth:
      return "behind both";
    case PointState::kNearlyParallel:
      return "nearly parallel";
    case PointState::kAtInfinity:
    case PointState::kOnBaseline:
    case PointState::kOutOfRange:
      return name_of(state);
  }
  return "";
}

std::string coordinates(const Vector3d& v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x() + 0.0, v.y() + 0.0, v.z() + 0.0);
}

Row table_row(std::size_t number, const LocatedPoint& point) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const auto& closest = point.closest;
  Row row{std::to_string(number), short_number(closest ? closest->along_left : none),
          short_number(closest ? closest->along_right : none)};
  for (int axis = 0; axis < 3; ++axis)
    row.push_back(short_number(point.has_place() ? point.point[axis] : none));
  row.push_back(short_number(closest ? closest->gap : none));
  row.push_back(short_number(point.ellipsoid ? point.ellipsoid->half_axes.x() : none));
  row.push_back(std::isfinite(point.residual()) ? fmt::format("{:.3g}", point.residual()) : "-");
  row.emplace_back(short_name(point.state));
  return row;
}

std::string table_text(const TriangulationReport& report, std::size_t rows) {
  const std::size_t shown = std::min(rows, report.points.size());
  if (shown == 0) return "";
  std::vector<Row> lines{{"match", "t_l", "t_r", "X", "Y", "Z", "gap", "+-", "px", "named"}};
  for (std::size_t i = 0; i < shown; ++i) lines.push_back(table_row(i + 1, report.points[i]));
  std::string text = "\n" + table(lines, 0);
  if (shown < report.points.size()) {
    text += fmt::format("  ({} more; --rows, --json and --points-out FILE.csv have them)\n",
                        report.points.size() - shown);
  }
  return text +
         wrapped(
             "  ",
             "t_l, t_r: distances along the rays to where they are closest, with the gap there; "
             "X, Y, Z: the point in the world; +-: the longest half axis of its ellipsoid; px: "
             "the residual, both reprojection errors together");
}

std::string counts_text(const TriangulationReport& report) {
  std::string text;
  for (const PointState state : kPointStates) {
    if (report.count(state) == 0 && state != PointState::kInFront) continue;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", report.count(state), name_of(state));
    if (state == PointState::kNearlyParallel && report.parallel_behind > 0) {
      text += fmt::format(" (of these {} behind a camera)", report.parallel_behind);
    }
  }
  return text;
}

std::string medians_text(const TriangulationReport& report) {
  if (!report.medians) return "no point is in front of both cameras";
  const TriangulationMedians& m = *report.medians;
  return fmt::format(
      "of the points in front of both cameras: distance {:.4g}, gap {:.3g}, residual {:.3g} px, "
      "angle of the rays {:.3g} deg, half axes {:.3g} (longest) and {:.3g} (shortest)",
      m.distance, m.gap, m.residual, degrees_from_radians(m.angle), m.longest, m.shortest);
}

std::string why_text(const TriangulationReport& report) {
  std::string text;
  const auto add = [&](std::size_t count, const std::string& what) {
    if (count > 0) text += wrapped("  - ", what);
  };
  add(report.count(PointState::kBehindLeft) + report.count(PointState::kBehindRight) +
          report.count(PointState::kBehindBoth),
      "behind a camera: the rays are closest where the camera does not look, so the match or the "
      "cameras are wrong");
  add(report.count(PointState::kNearlyParallel),
      "rays nearly parallel: their angle is below three of its standard deviations, so the point "
      "may be at any distance beyond some limit; first order does not describe its error");
  add(report.count(PointState::kAtInfinity),
      "at infinity: the rays are parallel to within rounding, so only a direction is known");
  add(report.count(PointState::kOnBaseline),
      "on the baseline: a ray goes through both camera centres, so the other ray does not say how "
      "far away the point is");
  add(report.count(PointState::kOutOfRange), "out of range: a number is too large for a double");
  return text;
}

std::string ellipsoid_text(const ErrorEllipsoid& ellipsoid) {
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    text += fmt::format("{}{:.4g} along {}", axis == 0 ? "" : ", ", ellipsoid.half_axes[axis],
                        coordinates(ellipsoid.axes.col(axis)));
  }
  return text;
}

std::string match_in_full(const TriangulationInput& input, const TriangulationReport& report,
                          std::size_t number) {
  const Match& match = input.pair.matches[number - 1];
  const LocatedPoint& point = report.points[number - 1];
  std::string text = fmt::format("\nmatch {}: {}\n", number, name_of(point.state));
  const auto line = [&](const char* name, const std::string& what) {
    text += wrapped(fmt::format("  {:<10}", name), what);
  };
  line("pixels", fmt::format("left ({:.8g}, {:.8g}), right ({:.8g}, {:.8g})", match.left.x(),
                             match.left.y(), match.right.x(), match.right.y()));
  line("left ray",
       coordinates(point.rays[0].origin) + " + t_l " + coordinates(point.rays[0].direction));
  line("right ray",
       coordinates(point.rays[1].origin) + " + t_r " + coordinates(point.rays[1].direction));
  line("angle",
       fmt::format("of the rays {:.6g} deg, standard deviation {:.3g} deg",
                   degrees_from_radians(point.angle), degrees_from_radians(point.angle_sigma)));
  if (point.closest) {
    line("closest", fmt::format("t_l = {:.8g}, t_r = {:.8g}, gap {:.4g}", point.closest->along_left,
                                point.closest->along_right, point.closest->gap));
  }
  if (point.has_place()) line("point", coordinates(point.point.head<3>()));
  if (point.state == PointState::kAtInfinity) {
    line("direction", coordinates(point.point.head<3>().normalized()));
  }
  line("errors", fmt::format("left {} px, right {} px", short_number(point.reprojection_errors[0]),
                             short_number(point.reprojection_errors[1])));
  if (point.ellipsoid) line("half axes", ellipsoid_text(*point.ellipsoid));
  return text;
}

// ---- JSON ----

template <class Vector>
TriangulationJson numbers_in(const Vector& vector) {
  TriangulationJson json = TriangulationJson::array();
  for (const double value : vector) json.push_back(finite_json(value));
  return json;
}

TriangulationJson camera_json(const PinholeCamera& camera) {
  return {{"K", matrix_json(camera.intrinsic)},
          {"R", matrix_json(camera.camera_from_world)},
          {"centre", numbers_in(camera.centre)}};
}

TriangulationJson point_json(const Match& match, const LocatedPoint& point) {
  const auto ray = [](const WorldRay& r) {
    return TriangulationJson{{"origin", numbers_in(r.origin)},
                             {"direction", numbers_in(r.direction)}};
  };
  TriangulationJson json{
      {"left", numbers_in(match.left)},
      {"right", numbers_in(match.right)},
      {"state", name_of(point.state)},
      {"in_front_of", {{"left", point.in_front[0]}, {"right", point.in_front[1]}}},
      {"left_ray", ray(point.rays[0])},
      {"right_ray", ray(point.rays[1])},
      {"angle_degrees", finite_json(degrees_from_radians(point.angle))},
      {"angle_sigma_degrees", finite_json(degrees_from_radians(point.angle_sigma))}};
  const auto& closest = point.closest;
  json["t_left"] = closest ? finite_json(closest->along_left) : nullptr;
  json["t_right"] = closest ? finite_json(closest->along_right) : nullptr;
  json["gap"] = closest ? finite_json(closest->gap) : nullptr;
  json["point"] = point.has_place() ? numbers_in(point.point.head<3>().eval()) : nullptr;
  json["direction"] = point.state == PointState::kAtInfinity
                          ? numbers_in(point.point.head<3>().normalized().eval())
                          : nullptr;
  json["reprojection_px"] = numbers_in(point.reprojection_errors);
  json["ellipsoid"] = nullptr;
  if (const auto& ellipsoid = point.ellipsoid) {
    json["ellipsoid"] = {
        {"half_axes", numbers_in(ellipsoid->half_axes)},
        {"axes",
         {numbers_in(ellipsoid->axes.col(0).eval()), numbers_in(ellipsoid->axes.col(1).eval()),
          numbers_in(ellipsoid->axes.col(2).eval())}}};
  }
  return json;
}

TriangulationJson medians_json(const TriangulationMedians& medians) {
  return {{"distance", medians.distance},
          {"gap", medians.gap},
          {"residual_px", medians.residual},
          {"angle_degrees", degrees_from_radians(medians.angle)},
          {"longest_half_axis", medians.longest},
          {"shortest_half_axis", medians.shortest}};
}

// ---- files of points ----

void add_float_bytes(std::string& bytes, double value) {
  const auto bits = std::bit_cast<std::uint32_t>(float(value));
  for (int shift = 0; shift < 32; shift += 8) bytes += char(bits >> shift & 0xffu);
}

// The colour of the left picture at a position; white beside the picture.
Rgba8 color_at(const Image<Rgba8>& picture, const Vector2d& pixel) {
  const bool is_inside =
      pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < picture.width && pixel.y() < picture.height;
  if (!is_inside) return {255, 255, 255, 255};
  return picture
      .pixels[std::size_t(pixel.y()) * std::size_t(picture.width) + std::size_t(pixel.x())];
}

std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

}  // namespace

TriangulationReport triangulation_report(const TriangulationInput& input) {
  TriangulationReport report;
  for (const Match& match : input.pair.matches) {
    report.points.push_back(locate(input.how, match, input.cameras, input.sigma));
    const LocatedPoint& point = report.points.back();
    ++report.counts[std::size_t(point.state)];
    const bool is_behind = !point.in_front[0] || !point.in_front[1];
    report.parallel_behind += point.state == PointState::kNearlyParallel && is_behind;
    report.unlikely += !(point.residual() <= kUnlikely * input.sigma);
  }
  report.medians = medians_of(report);
  return report;
}

std::string triangulation_text(const TriangulationInput& input, const TriangulationReport& report,
                               std::size_t rows, std::optional<std::size_t> in_full) {
  const auto& [left, right] = input.cameras;
  std::string text = printable(input.pair.description, kTextWidth) + "\n";
  if (!input.pair.pair_description.empty())
    text += heading_line("pair", input.pair.pair_description);
  text += heading_line(
      "cameras", fmt::format("left at {}, right at {}: {:.6g} apart", coordinates(left.centre),
                             coordinates(right.centre), (right.centre - left.centre).norm()));
  text += heading_line("matches",
                       fmt::format("{}; each coordinate is off by {:g} px (standard deviation)",
                                   input.pair.matches.size(), input.sigma));
  text += heading_line("method",
                       std::string(method_name(input.how)) + ": " + method_sentence(input.how));
  text += table_text(report, rows) + "\n";
  text += heading_line("points", counts_text(report)) + why_text(report);
  text += heading_line(
      "residuals",
      fmt::format("{} of {} above {:g} sigma; with right matches and the right sigma, about one in "
                  "370 is",
                  report.unlikely, report.points.size(), kUnlikely));
  text += heading_line("medians", medians_text(report));
  text += heading_line(
      "ellipsoids",
      fmt::format("one standard deviation, first order: covariance {}; J has the derivatives of "
                  "the four pixel coordinates by the point (Hartley and Zisserman, Multiple View "
                  "Geometry, 5.2.2)",
                  covariance_formula(input.how)));
  if (in_full) text += match_in_full(input, report, *in_full);
  return text;
}

TriangulationJson triangulation_json(const TriangulationInput& input,
                                     const TriangulationReport& report) {
  TriangulationJson json{{"about", input.pair.description}};
  if (!input.pair.pair_description.empty()) json["pair"] = input.pair.pair_description;
  json["cameras"] = {{"left", camera_json(input.cameras[0])},
                     {"right", camera_json(input.cameras[1])}};
  json["baseline"] = (input.cameras[1].centre - input.cameras[0].centre).norm();
  json["method"] = method_name(input.how);
  json["sigma_px"] = input.sigma;
  json["covariance"] = covariance_formula(input.how);
  for (const PointState state : kPointStates) json["counts"][name_of(state)] = report.count(state);
  json["nearly_parallel_and_behind"] = report.parallel_behind;
  json["residuals_above_3_sigma"] = report.unlikely;
  json["medians"] = report.medians ? medians_json(*report.medians) : TriangulationJson(nullptr);
  TriangulationJson matches = TriangulationJson::array();
  for (std::size_t i = 0; i < report.points.size(); ++i)
    matches.push_back(point_json(input.pair.matches[i], report.points[i]));
  json["matches"] = std::move(matches);
  return json;
}

std::string triangulation_ply(const TriangulationInput& input, const TriangulationReport& report) {
  const bool has_colors = input.pair.pictures.has_value();
  std::string vertices;
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const LocatedPoint& point = report.points[i];
    if (point.state != PointState::kInFront) continue;
    for (int axis = 0; axis < 3; ++axis) add_float_bytes(vertices, point.point[axis]);
    if (!has_colors) continue;
    const Rgba8 color = color_at(input.pair.pictures->front(), input.pair.matches[i].left);
    for (const std::uint8_t channel : {color.r, color.g, color.b}) vertices += char(channel);
  }
  return fmt::format(
             "ply\nformat binary_little_endian 1.0\ncomment made by glassbox views triangulate\n"
             "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n{}"
             "end_header\n",
             report.count(PointState::kInFront),
             has_colors ? "property uchar red\nproperty uchar green\nproperty uchar blue\n" : "") +
         vertices;
}

std::string triangulation_csv(const TriangulationInput& input, const TriangulationReport& report) {
  std::string text =
      "match,x_left,y_left,x_right,y_right,state,x,y,z,t_left,t_right,gap,angle_degrees,"
      "error_left_px,error_right_px,half_axis_1,half_axis_2,half_axis_3\n";
  const double none = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const Match& match = input.pair.matches[i];
    const LocatedPoint& point = report.points[i];
    text += fmt::format("{},{},{},{},{},{}", i + 1, match.left.x(), match.left.y(), match.right.x(),
                        match.right.y(), name_of(point.state));
    const auto add = [&](double value) { text += "," + csv_number(value); };
    for (int axis = 0; axis < 3; ++axis) add(point.has_place() ? point.point[axis] : none);
    add(point.closest ? point.closest->along_left : none);
    add(point.closest ? point.closest->along_right : none);
    add(point.closest ? point.closest->gap : none);
    add(degrees_from_radians(point.angle));
    for (const double error : point.reprojection_errors) add(error);
    for (int axis = 0; axis < 3; ++axis)
      add(point.ellipsoid ? point.ellipsoid->half_axes[axis] : none);
    text += "\n";
  }
  return text;
}

}  // namespace glassbox::views
