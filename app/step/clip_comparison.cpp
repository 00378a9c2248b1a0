// Says how the clip positions that a program computed differ from those of the given matrices.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/step/number_text.h"
#include "app/step/point_step.h"
#include "cli/report/number_json.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>

namespace glassbox::app {

namespace {

std::string position_text(const glm::dvec4& p) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g}, {:.9g})", p.x, p.y, p.z, p.w);
}

std::string first_difference_text(const ClipDifference& first) {
  return wrapped("  ", fmt::format("the first difference is at point {}: your matrices give {}, "
                                   "your program gives {}",
                                   first.vertex, position_text(first.ours),
                                   position_text(first.theirs))) +
         wrapped(
             "  ",
             fmt::format(
                 "rounding and missing digits of the printed matrices explain differences up to {}",
                 position_text(first.tolerance)));
}

}  // namespace

std::string clip_comparison_text(const ClipComparison& found) {
  if (found.different == 0) {
    return wrapped("  ", fmt::format("your program's clip positions are those of your matrices, at "
                                     "all {} within rounding",
                                     counted(found.compared, "point")));
  }
  std::string text =
      wrapped("  WRONG ", fmt::format("{} of {} clip positions of your program are not those of "
                                      "your matrices",
                                      found.different, found.compared)) +
      first_difference_text(*found.first);
  for (const ClipExplanation& explanation : found.explanations) {
    text += wrapped("  explained by: ", explanation.text + " (all points agree then)");
  }
  if (!found.explanations.empty()) return text;
  if (!found.clip_from_object) {
    return text +
           wrapped("  ",
                   "none of the tried ways of using these matrices gives all of its positions");
  }
  return text +
         wrapped("  ",
                 "none of the tried ways of using these matrices gives its positions, but this "
                 "matrix gives them; give it as --proj to see what it is") +
         matrix_rows(*found.clip_from_object, "    ");
}

nlohmann::ordered_json clip_comparison_json(const ClipComparison& found) {
  nlohmann::ordered_json json{{"compared", found.compared}, {"different", found.different}};
  if (found.first) {
    json["first_difference"] = {{"point", found.first->vertex},
                                {"matrices", numbers_json(found.first->ours)},
                                {"program", numbers_json(found.first->theirs)},
                                {"tolerance", numbers_json(found.first->tolerance)}};
  }
  json["explanations"] = nlohmann::ordered_json::array();
  for (const ClipExplanation& e : found.explanations) {
    json["explanations"].push_back({{"id", e.id}, {"text", e.text}});
  }
  if (found.clip_from_object) json["program_matrix"] = rows_json(*found.clip_from_object);
  return json;
}

}  // namespace glassbox::app
