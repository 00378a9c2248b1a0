// glassbox step SCENE --triangle N: see app/step/scene_step.h.
// glassbox step --point x,y,z --model FILE --view FILE --proj FILE: a point through one's own matrices, space by space, with
// a check of each matrix, and where the point vanishes the convention that would make it visible.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/chain_text.h"
#include "app/matrix_report.h"
#include "app/matrix_text.h"
#include "app/step/scene_step.h"

#include <glassbox/base/error.h>
#include <glassbox/pipeline/vertex_chain.h>

namespace glassbox::app {

class StepCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  int step_points();
  Result<void> read_matrices();
  Result<void> read_matrix(const char* option, const std::optional<std::string>& source,
                           GivenMatrix& matrix, std::string& origin);
  void choose_dialect();
  void guess_or_ask();
  ChainMatrices chain_matrices() const;
  double open_px(const glm::vec4& point, const VertexChain& chain) const;
  Viewport viewport() const;
  ChainSetting chain_setting() const;
  std::string text(const std::vector<VertexChain>& chains) const;
  std::string verdict(const std::vector<VertexChain>& chains) const;
  nlohmann::ordered_json json(const std::vector<VertexChain>& chains) const;

  SceneStep scene_;
  std::vector<glm::dvec4> points_;
  std::vector<glm::dvec2> expected_;
  std::optional<std::string> model_, view_, projection_;
  std::optional<NumberOrder> order_;
  std::optional<std::string> dialect_;
  std::optional<std::array<double, 4>> window_;  // x, y, width, height
  std::optional<Hand> world_;
  bool bits_ = false;
  std::optional<std::string> json_output_;

  MatrixSetup setup_;
  MatrixOrigins origins_;
  std::string dialect_reason_;
  std::vector<double> open_px_;  // per point
  std::vector<Finding> findings_;
  ConventionsReport report_;
};

}  // namespace glassbox::app
