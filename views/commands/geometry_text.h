// The report on two views as text.
#pragma once

#include <string>

#include "views/commands/geometry_report.h"

namespace glassbox::views {

// The report in lines of at most 100 columns.
std::string geometry_text(const GeometryInput& input, const GeometryReport& report);

// One line that says which kind of pair it is, and what that means. The page shows it too.
std::string kind_sentence(views::PairKind kind);
// The formula log(1 - confidence)/log(1 - inliers^size) for the number of samples, with its
// numbers.
std::string law_text(const GeometryReport& report);

}  // namespace glassbox::views
