// Commands that ask something about the picture of a scene: `glassbox COMMAND SCENE [picture
// options] [--json FILE|-]`.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

// An answer as JSON and as text.
struct Answer {
  nlohmann::ordered_json json;
  std::string text;
  bool passes = true;  // for --check: whether what was asked for is seen
};

class PictureQuestion {
public:
  using AnswerFunction = std::function<Result<Answer>(const Scene&, const View&)>;
  using SceneAnswerFunction = std::function<Result<Answer>(const Scene&)>;

  // Adds SCENE, the picture options, and --json.
  void add_to(CLI::App& command);
  // Adds --check: the exit code is 1 if the answer does not pass.
  void add_check(CLI::App& command, const std::string& help);

  const std::string& scene_name() const { return scene_; }
  const PictureOptions& picture() const { return picture_; }

  // The scene and the size: "teapot, 640 x 480"
  std::string title() const;

  // Loads the scene, chooses the view, calls `ask`, and prints the answer as text, writes it as
  // JSON (after the scene's name and the picture's size), or both. Returns the exit code.
  int answer(const AnswerFunction& ask) const;
  // Does what answer() does, for an `ask` that chooses the view, or the eyes, by itself.
  int answer_of_scene(const SceneAnswerFunction& ask) const;

private:
  std::string scene_;
  PictureOptions picture_;
  std::optional<std::string> json_output_;
  bool check_ = false;
};

}  // namespace glassbox
