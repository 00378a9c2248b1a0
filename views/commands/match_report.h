// The report on the result of `glassbox views match`.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "views/commands/match_input.h"
#include "views/matching/match.h"

namespace glassbox::views {

std::string match_text(const MatchInput& input, const views::MatchSettings& settings,
                       const views::DenseMatch& match);
nlohmann::ordered_json match_json(const MatchInput& input, const views::MatchSettings& settings,
                                  const views::DenseMatch& match);

}  // namespace glassbox::views
