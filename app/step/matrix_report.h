// What three matrices are, what is wrong with them, and what would make the points visible: as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/step/matrices/conventions_check.h"
#include "app/step/matrices/findings.h"

namespace glassbox::app {

// How a matrix came in: "view.txt, read by rows, 6 digits"; empty where none was given.
struct MatrixOrigins {
  std::string model, view, projection;
};

// "rigid exactly: a turn by 30 degrees about (0, 1, 0), then a translation by (1, 2, 3)".
std::string affine_sentence(const MatrixFacts& facts);

std::string matrices_text(const MatrixSetup& setup, const MatrixOrigins& origins);
nlohmann::ordered_json matrices_json(const MatrixSetup& setup, const MatrixOrigins& origins);

std::string findings_text(const std::vector<Finding>& findings);
nlohmann::ordered_json findings_json(const std::vector<Finding>& findings);

std::string alternatives_text(const ConventionsReport& report);
nlohmann::ordered_json alternatives_json(const ConventionsReport& report);

}  // namespace glassbox::app
