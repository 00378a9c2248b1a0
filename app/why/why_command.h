// glassbox why SCENE [--triangle N]: explains what became of a triangle, or of all of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_question.h"

#include <glassbox/base/error.h>
#include <glassbox/render/trace/verdict.h>

namespace glassbox::app {

class WhyCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  Result<Answer> answer(const Scene& scene, const View& view) const;
  Result<Answer> about_triangle(const Scene& scene, const View& view, std::uint64_t number) const;
  Result<Answer> about_scene(const Scene& scene, const View& view) const;
  std::string triangle_text(const Scene& scene, const View& view,
                            const TriangleVerdict& verdict) const;
  std::string scene_text(const SceneVerdict& found) const;
  // The command line "glassbox SUBCOMMAND SCENE ... OPTION VALUE", with the options of this
  // picture.
  std::string command(const char* subcommand, const std::string& option,
                      const std::string& value) const;

  PictureQuestion question_;
  std::optional<std::uint64_t> triangle_;
};

}  // namespace glassbox::app
