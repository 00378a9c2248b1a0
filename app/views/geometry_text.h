// The report of two views as text.
#pragma once

#include <string>

#include "app/views/geometry_report.h"

namespace glassbox::app {

// Lines of at most 100 columns.
std::string geometry_text(const GeometryInput& input, const GeometryReport& report);

// One line: which kind of pair it is, and what that means. The page has it, too.
std::string kind_sentence(views::PairKind kind);
// log(1 - confidence)/log(1 - inliers^size), with its numbers.
std::string law_text(const GeometryReport& report);

}  // namespace glassbox::app
