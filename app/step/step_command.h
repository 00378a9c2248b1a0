// glassbox step: carries a triangle of a scene, or points with the user's own matrices, through
// every space and shows each number.
//
// step_command reads the options and takes one of two ways. Each first computes everything and then
// prints it:
//
//   glassbox step SCENE --triangle N | --pick X,Y
//     stepped_triangle    the run for this triangle only (render/trace), with its error bounds
//     triangle_stages     the texts of its stages, from object to picture; stage_parts.h lists the
//                         longer ones: camera_text (the matrices), clipping_text, singular_text,
//                         fragment_text
//     prompt, line_reader the same stage by stage at a prompt, with other cameras and triangles
//
//   glassbox step --point X,Y,Z --model FILE --view FILE --proj FILE
//     matrix_tokens, printed_matrix  reads a matrix as some program printed it
//     matrices/           what the matrices are, what is wrong with them, and which change of
//                         convention would make the points visible
//     point_step          all of this for some points, which pipeline/vertex_chain.h carries from
//                         space to space
//     point_matrices_text, point_walk_text, point_verdict_text, point_json   the answer
//
// number_text writes numbers for both.
#pragma once

#include <optional>
#include <string>

#include "app/step/point_step.h"
#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"

#include <glassbox/mesh/limits.h>

namespace glassbox::app {

class StepCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  // SCENE and the options that belong to it, with those of the picture.
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
  std::uint32_t max_megabytes_ = 200;  // limit for JSON
};

}  // namespace glassbox::app
