// Matches in a file: x and y of the left picture, then of the right one, a match a line.
#pragma once

#include <string>
#include <string_view>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// A line of names may come first, as spreadsheets write it.
Result<Matches> parse_matches(std::string_view text);
std::string matches_text(const Matches& matches);

}  // namespace glassbox::views
