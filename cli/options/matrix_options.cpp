#include "cli/options/matrix_options.h"

#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/choices.h"

#include <glassbox/matrices/view_of_matrices.h>
#include <glassbox/pipeline/view.h>

namespace glassbox {

namespace {

// Reads one of the matrices. The first error is kept.
void take_matrix(const char* option, const std::string& source, std::optional<NumberOrder> asked,
                 MatrixOptions& o, GivenMatrix& matrix) {
  if (o.error) return;
  if (source == "-" && o.reads_standard_input) {
    o.error = Error{"", "--model, --view, --proj", "several matrices are read from standard input",
                    "put the others into files"};
    return;
  }
  if (source == "-") o.reads_standard_input = true;
  Result<GivenMatrix> read = read_given_matrix(option, source, asked ? asked : o.order);
  if (read) {
    matrix = *std::move(read);
  } else {
    o.error = read.error();
  }
}

// The size with the height of `size` and this shape, as far as an image can have it.
Size size_of_aspect(const Size& size, double aspect) {
  const double width = std::round(size.height * aspect);
  if (width >= 1 && width <= kMaxImageSide) return {int(width), size.height};
  return size;
}

void add_orders(CLI::App& command, MatrixOptions& o) {
  const Choices<std::optional<NumberOrder>> orders{{"rows", NumberOrder::kRows},
                                                   {"columns", NumberOrder::kColumns}};
  add_choice<std::optional<NumberOrder>>(
      command, "--order", o.order, orders,
      "how the numbers are listed: row by row of p' = M p, or column by column (the rows of p M) "
      "[as the layout says, else rows]")
      ->group(kMatrixGroup);
  const auto add = [&](const char* name, std::optional<NumberOrder>& order, const char* matrix) {
    add_choice<std::optional<NumberOrder>>(
        command, name, order, orders, fmt::format("the same as --order, but only for {}", matrix))
        ->group(kMatrixGroup);
  };
  add("--model-order", o.model_order, "--model");
  add("--view-order", o.view_order, "--view");
  add("--proj-order", o.projection_order, "--proj");
}

// The matrices come after the orders: CLI11 reads the values of options in the order in which they
// were added.
void add_sources(CLI::App& command, MatrixOptions& o, Size& size) {
  const CLI::Option* size_option = command.get_option("--size");
  const auto add = [&](const char* name, GivenMatrix& matrix,
                       const std::optional<NumberOrder>& order, const char* help) {
    return command
        .add_option_function<std::string>(
            name,
            [name, &o, &matrix, &order](const std::string& source) {
              take_matrix(name, source, order, o, matrix);
            },
            help)
        ->type_name("FILE|-|NUMBERS")
        ->group(kMatrixGroup);
  };
  add("--model", o.model, o.model_order,
      "the model matrix, from object space to world space [the identity]");
  add("--view", o.view, o.view_order,
      "the view matrix, from world space to eye space [the identity]");
  command
      .add_option_function<std::string>(
          "--proj",
          [&o, &size, size_option](const std::string& source) {
            take_matrix("--proj", source, o.projection_order, o, o.projection);
            if (o.error || size_option->count() > 0) return;
            const std::optional<double> aspect = aspect_of_projection(o.projection);
            if (aspect) size = size_of_aspect(size, *aspect);
          },
          "the projection, from eye space to clip space; or projection times view. Without --size, "
          "the picture gets its shape")
      ->type_name("FILE|-|NUMBERS")
      ->group(kMatrixGroup);
}

void add_conventions(CLI::App& command, MatrixOptions& o) {
  Choices<const ApiDialect*> dialects;
  for (const ApiDialect& dialect : api_dialects()) dialects.push_back({dialect.name, &dialect});
  add_choice<const ApiDialect*>(
      command, "--dialect", o.dialect, dialects,
      "the graphics API that the matrices are made for [guessed from them]")
      ->group(kMatrixGroup);
  add_choice<std::optional<Handedness>>(
      command, "--world", o.world, {{"right", Handedness::kRight}, {"left", Handedness::kLeft}},
      "the handedness of your world, if you know it")
      ->group(kMatrixGroup);
  add_choice<std::optional<FrontFaces>>(
      command, "--front", o.front,
      {{"ccw", FrontFaces::kCounterClockwise}, {"cw", FrontFaces::kClockwise}},
      "which faces are front faces in your API: those whose corners run counter-clockwise on the "
      "screen, or clockwise [the model's outside]")
      ->group(kMatrixGroup);
}

}  // namespace

void add_matrix_options(CLI::App& command, MatrixOptions& options, Size& size) {
  add_orders(command, options);
  add_sources(command, options, size);
  add_conventions(command, options);
}

Result<void> check_matrices_read(const MatrixOptions& options) {
  if (options.error) return tl::unexpected(*options.error);
  return {};
}

std::string numbers_text(const GivenMatrix& matrix) {
  std::string text;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      text += fmt::format("{}{}", text.empty() ? "" : ",", entry_at(matrix.m, row, column));
    }
  }
  return text;
}

Result<Scene> with_model_matrix(Scene scene, const MatrixOptions& options) {
  if (const auto read = check_matrices_read(options); !read) return tl::unexpected(read.error());
  if (!options.model.given) return scene;
  const MatrixFacts facts = matrix_facts(options.model.m);
  if (facts.shape == MatrixShape::kNotFinite) {
    return fail("--model", "it has an entry that is not a finite number",
                "find out which division or angle of your program gives it");
  }
  if (!facts.affine) {
    return fail("--model",
                "its last row is " + row_text(options.model.m, 3) + ", which is not 0 0 0 1",
                facts.affine_transposed ? "its last column is: give --model-order columns"
                                        : "give the projection as --proj");
  }
  const Transform<World, World> model(options.model.m);
  for (Node& node : scene.nodes) {
    node.world_from_node = model * node.world_from_node;
    if (node.parent == kNone) node.parent_from_node = node.world_from_node;
  }
  return scene;
}

}  // namespace glassbox
