#include "app/info/info_stiffness.h"

#include <fmt/format.h>

#include "app/options/picture_options.h"
#include "app/study/stiffness/report.h"

#include <glassbox/render/trace/numbering.h>

#include "study/stiffness/stiffness.h"

namespace glassbox::app {

namespace {

// Four microseconds each.
constexpr std::uint64_t kMostTriangles = 200'000;

}  // namespace

std::vector<std::string> stiffness_of_framed(const Scene& scene) {
  const std::uint64_t triangles = count_triangles(scene);
  if (triangles > kMostTriangles) {
    return {
        fmt::format("how exact the usual view is was not asked, because of {} triangles; "
                    "glassbox study stiffness does it",
                    triangles)};
  }
  const PictureOptions usual;
  const Result<ChosenView> chosen = choose_view(scene, usual);
  if (!chosen) return {};
  return stiffness_warnings(
      scene, study::stiffness_of(scene, chosen->view, usual.settings, up_of(scene, usual.camera)));
}

}  // namespace glassbox::app
