// One vertex's way from object to window, as text for a terminal and as JSON.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/step/matrices/projection_facts.h"

#include <glassbox/pipeline/vertex_chain.h>

namespace glassbox::app {

// What the text needs to know besides the numbers.
struct ChainSetting {
  ApiDialect dialect;
  Viewport viewport;
  ProjectionFacts projection;  // ProjectionKind::kNone: nothing is said in its terms
  bool projected = true;       // false: there is no projection, and the way ends in the eye's space
  bool bits = false;           // the float's bits beside each number, in hexadecimal
  // How far the digits of printed matrices leave the position in the window open, in pixels; none for matrices that were
  // not printed.
  std::optional<double> open_px;
};

std::string chain_text(const VertexChain& chain, const ChainSetting& setting);
nlohmann::ordered_json chain_json(const VertexChain& chain, const ChainSetting& setting);

// Four lines "[ a b c d ]".
std::string matrix_rows(const glm::dmat4& m, const std::string& indent, int digits = 6);
nlohmann::ordered_json matrix_json(const glm::dmat4& m);  // an array of rows

// "visible at (640.00, 360.00)", "outside the near plane: its distance along the gaze is 0.05, and ...",
// "behind the eye (w = -3)"
std::string fate_text(const VertexChain& chain, const ChainSetting& setting);

}  // namespace glassbox::app
