// glassbox views texture: draws a surface from another eye, with the colours of pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/arguments.h"
#include "cli/options/camera_options.h"
#include "cli/options/cli_fwd.h"
#include "cli/report/progress.h"
#include "views/commands/picture_choice.h"
#include "views/texture/textured_surface.h"

#include <glassbox/mesh/scene.h>

#include <nlohmann/json_fwd.hpp>

namespace glassbox::views {

class ViewsTextureCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  struct Found;
  int run();
  Result<void> check_asked() const;
  Result<void> check_outputs() const;
  void tell_of_unused() const;
  double bytes_for(const Scene& scene, const ChosenPictures& pictures) const;
  Result<Found> find(const Scene& scene, const ChosenPictures& pictures, Progress& progress) const;
  Result<void> write_outputs(const Scene& scene, const ChosenPictures& pictures,
                             const Found& found) const;
  std::string text(const ChosenPictures& pictures, const Found& found) const;
  nlohmann::ordered_json json(const ChosenPictures& pictures, const Found& found) const;
  std::string command_line() const;

  std::string mesh_;
  PictureChoice choice_;
  bool each_ = false;
  views::Blend blend_ = views::Blend::kBarycentric;
  int neighbours_ = 4, texels_ = 8;
  CameraOptions camera_;
  std::optional<Size> size_;
  Rgba8 background_{26, 31, 38, 255};
  std::optional<std::string> output_, fixed_, left_out_output_, json_output_, page_;
  const CLI::App* command_ = nullptr;
  std::vector<std::string> camera_words_;  // names of the camera options
  std::vector<const CLI::Option*> options_;
};

}  // namespace glassbox::views
