// Z-fighting in words: who fights where, and what to change.
#include <fmt/format.h>

#include "app/why/verdict_text.h"

#include <glassbox/base/counted.h>
#include <glassbox/render/engine/setting_names.h>
#include <glassbox/render/trace/numbering.h>

namespace glassbox {

namespace {

std::string fighter_text(const Scene& scene, std::uint32_t number) {
  const auto triangle = find_triangle(scene, number);
  if (!triangle) return fmt::format("triangle {}", number);
  return fmt::format("triangle {} ({})", number,
                     face_text(scene, triangle->instance, triangle->face));
}

std::string remedy_text(const DepthRemedy& remedy) {
  std::vector<std::string> ways;
  if (remedy.format) ways.push_back(fmt::format("--depth {}", name_of(*remedy.format)));
  if (remedy.near) ways.push_back(fmt::format("--near {:.3g}", *remedy.near));
  const std::string offset =
      fmt::format("an offset of {:.2g} or more between them along the gaze", remedy.offset);
  if (ways.empty()) return "they need " + offset + ": no depth format separates them";
  std::string text = "to separate them, give ";
  for (const std::string& way : ways) text += way + " or ";
  return text + offset;
}

}  // namespace

std::string fight_text(const Scene& scene, const View& view, DepthFormat format,
                       const DepthFight& fight) {
  const DepthRemedy remedy = remedy_of(view, format, fight);
  return fmt::format(
      "z-fighting: {} and {} have the same or nearly the same depth codes in {}({}, {}), so "
      "rounding decides which is seen. Their distances there are {:.9g} and {:.9g}, and one code "
      "of "
      "{} stands for {:.2g}. Remedy: {}.",
      fighter_text(scene, fight.first), fighter_text(scene, fight.second),
      fight.pixels == 1 ? "pixel " : fmt::format("{} pixels, such as ", fight.pixels), fight.x,
      fight.y, fight.first_distance, fight.second_distance, name_of(format), remedy.step,
      remedy_text(remedy));
}

}  // namespace glassbox
