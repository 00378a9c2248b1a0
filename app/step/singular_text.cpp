// Stage 6 of a stepped triangle as the slides first draw it: with a projection that keeps no depth.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "app/step/number_text.h"
#include "app/step/stage_texts.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/rounding.h>
#include <glassbox/matrices/decimal.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/divide.h>

namespace glassbox::app {

namespace {

// (x, y, z)/w in double.
glm::dvec3 divided(const Transform<Clip, EyeLeft>& m, const Point<Eye, double>& eye) {
  const Point<EyeLeft, double> left(eye.x, eye.y, -eye.z);
  const Point<Clip, double> p = m * left;
  return {p.x / p.w, p.y / p.w, p.z / p.w};
}

std::string point_text(const glm::dvec3& p) {
  return fmt::format("({}, {}, {})", short_number(p.x, 9), short_number(p.y, 9),
                     short_number(p.z, 9));
}

// Divides x_s and y_s (the point on the view plane) by half the window's width and height, and says
// by how many ulps the results differ from the NDC of the drawn vertex.
std::string against_ndc(const View& view, const glm::dvec3& p, const TracedCorner& corner) {
  const NdcVertex ndc = divide(ClipVertex{corner.clip, {}});
  const double d = p.z;
  const std::array<double, 2> over{p.x / (d / view.clip_from_eye.at(0, 0)),
                                   p.y / (d / view.clip_from_eye.at(1, 1))};
  const std::uint64_t ulps = std::max(ulp_distance(float(over[0]), ndc.position.x),
                                      ulp_distance(float(over[1]), ndc.position.y));
  return fmt::format("divided by the half sides ({}, {}): NDC's x and y{}",
                     short_number(over[0], 9), short_number(over[1], 9),
                     ulps == 0 ? std::string(", the same floats") : " to " + counted(ulps, "ulp"));
}

// Whether the window is centred on the gaze of an eye at the origin.
bool is_centred(const View& view) {
  const auto& m = view.clip_from_eye;
  return m.at(0, 2) == 0 && m.at(0, 3) == 0 && m.at(1, 2) == 0 && m.at(1, 3) == 0;
}

template <class Lines>
std::string corners_text(const SteppedTriangle& stepped, const StepTarget& target,
                         const Lines& lines) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    const TracedCorner& corner = stepped.triangle->corners[k];
    if (!target.wants(k) || !(corner.clip.w > 0)) continue;
    std::string heading = fmt::format("     vertex {}  ", k);
    for (const std::string& line : lines(corner)) {
      text += wrapped(heading, line);
      heading.assign(heading.size(), ' ');
    }
  }
  return text;
}

}  // namespace

std::string singular_text(const SteppedTriangle& stepped, const StepTarget& target) {
  const View& view = stepped.chosen.view;
  if (!view.perspective) {
    const Transform<Clip, EyeLeft> m = drop_depth();
    return sentence(
               "without depth, as the slides draw a parallel view, T_ort = diag(1, 1, 0, 1):") +
           corners_text(stepped, target,
                        [&](const TracedCorner& corner) {
                          return std::vector{point_text(divided(m, corner.eye))};
                        }) +
           sentence("z is lost, so no surface that is drawn with this matrix can hide another");
  }
  const double d = view.near;
  const Transform<Clip, EyeLeft> m = singular_projection(d);
  std::string text =
      sentence(fmt::format("without depth, as in the slides' first projection, onto the view plane "
                           "z = d = {} (the near plane; z along the gaze), divided by w:",
                           short_number(d, 9)));
  text += matrix_rows(m.columns, kIndent, 9);
  std::uint64_t ulps = 0;
  text += corners_text(stepped, target, [&](const TracedCorner& corner) {
    const glm::dvec3 p = divided(m, corner.eye);
    const glm::dvec3 other = divided(simple_perspective(d), corner.eye);
    ulps = std::max({ulps, ulp_distance(p.x, other.x), ulp_distance(p.y, other.y)});
    std::vector<std::string> lines{point_text(p)};
    if (is_centred(view)) lines.push_back(against_ndc(view, p, corner));
    return lines;
  });
  return text +
         sentence(fmt::format("the other form of this matrix, the identity except for a last row "
                              "of (0, 0, 1/d, 0), gives the same up to {} in double",
                              counted(ulps, "ulp"))) +
         sentence(
             "z_s is d at every vertex: the matrix has rank 3 and keeps no depth, so a picture can "
             "be drawn, but no surface can hide another");
}

}  // namespace glassbox::app
