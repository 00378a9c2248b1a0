// glassbox step: a triangle of a scene, or points through one's own matrices, through every space with each number.
//
// step_command reads the options and takes one of two ways, each of which works everything out first and then tells it:
//
//   glassbox step SCENE --triangle N | --pick X,Y
//     stepped_triangle    the run of this triangle alone (render/trace), with its bounds
//     triangle_stages     its stages as texts, object to picture; stage_parts.h names the longer ones: camera_text (the
//                         matrices), clipping_text, singular_text, fragment_text
//     prompt, line_reader the same by hand, stage by stage, with other cameras and triangles
//
//   glassbox step --point X,Y,Z --model FILE --view FILE --proj FILE
//     matrix_tokens, printed_matrix  a matrix as some program printed it
//     matrices/           what the matrices are, what is wrong with them, which change of convention would show the points
//     point_step          all of it for some points, which pipeline/vertex_chain.h carries from space to space
//     point_matrices_text, point_walk_text, point_verdict_text, point_json   the answer
//
// number_text writes numbers for both.
#pragma once

#include <optional>
#include <string>

#include "app/options/cli_fwd.h"
#include "app/options/picture_options.h"
#include "app/step/point_step.h"

#include <glassbox/mesh/limits.h>

namespace glassbox::app {

class StepCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  // SCENE and what goes with it; the picture's options, too.
  void add_triangle(CLI::App& command);
  int run();
  int run_triangle();
  int run_points();
  Result<void> check_size(std::size_t fragments) const;

  std::string scene_;
  PictureOptions picture_;
  LoadLimits limits_;
  std::optional<std::uint32_t> triangle_;
  std::optional<int> vertex_;
  std::optional<PixelAt> pick_;
  bool interactive_ = false;

  PointStepOptions points_;
  bool bits_ = false;
  std::optional<std::string> json_output_;
  std::uint32_t max_megabytes_ = 200;  // of JSON
};

}  // namespace glassbox::app
