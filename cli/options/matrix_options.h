// The options for matrices of the user's own program, --model, --view and --proj, and the scene and
// the view that result from them.
#pragma once

#include <optional>
#include <string>

#include "cli/options/arguments.h"
#include "cli/options/cli_fwd.h"

#include <glassbox/base/error.h>
#include <glassbox/matrices/matrix_setup.h>
#include <glassbox/matrices/printed_matrix.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

struct MatrixOptions : OwnMatrices {
  // Why a matrix could not be read. Whoever uses the matrices checks this first.
  std::optional<Error> error;
  bool reads_standard_input = false;

  // How the numbers are listed: of all matrices, and of single ones. Absent: as the layout says.
  std::optional<NumberOrder> order, model_order, view_order, projection_order;
};

// Adds the options. If there is no --size, `size` gets the shape of the window that --proj is made
// for; so --size must have been added before.
void add_matrix_options(CLI::App& command, MatrixOptions& options, Size& size);

inline constexpr const char* kMatrixGroup = "Your own matrices";

// Why the matrices cannot be used, if so.
Result<void> check_matrices_read(const MatrixOptions& options);

// The sixteen numbers by rows, as the text that the option takes, with all their digits.
std::string numbers_text(const GivenMatrix& matrix);

// The scene with the model matrix applied to all its meshes, after their nodes' own transforms.
// Cameras and lights stay where they are. Without --model, the scene as it is. An error if the
// matrix is not affine, not finite, or could not be read.
Result<Scene> with_model_matrix(Scene scene, const MatrixOptions& options);

}  // namespace glassbox
