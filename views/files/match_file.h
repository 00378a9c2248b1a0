// Matches in a file: one match a line, x and y in the left picture, then x and y in the right one.
#pragma once

#include <string>
#include <string_view>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// The first line may be a heading with column names, as spreadsheets write it.
Result<Matches> parse_matches(std::string_view text);
std::string matches_text(const Matches& matches);

}  // namespace glassbox::views
