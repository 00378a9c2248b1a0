// The report on the result of `glassbox views match`.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "views/commands/match_input.h"
#include "views/matching/match.h"

#include <glassbox/base/error.h>

namespace glassbox::views {

std::string match_text(const MatchInput& input, const views::MatchSettings& settings,
                       const views::DenseMatch& match);
nlohmann::ordered_json match_json(const MatchInput& input, const views::MatchSettings& settings,
                                  const views::DenseMatch& match);

// The page of `glassbox views match --html`: pictures, maps, the costs for the pixel under the
// cursor, and the points in space.
struct MatchPageOrigin {
  std::string program, command;  // "glassbox 1.0.0"; the command line that makes the page
};

// Whether the sums of every pixel and disparity are few enough for a page.
bool has_room_for_sums(const MatchInput& input, const views::DisparityRange& range);

// An error if pictures of this size are too large for a browser.
Result<void> check_match_page(const MatchInput& input);

// `report` is the JSON of match_json.
Result<std::string> make_match_page(const MatchInput& input, const views::DenseMatch& match,
                                    const nlohmann::ordered_json& report,
                                    const MatchPageOrigin& origin);

}  // namespace glassbox::views
