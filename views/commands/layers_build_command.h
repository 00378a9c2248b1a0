// glassbox views layers build: writes a file with the surfaces that one camera sees, and those
// behind them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "cli/options/picture_options.h"
#include "views/layers/layer_file.h"
#include "views/layers/ray_layers.h"

namespace glassbox::views {

class LayersBuildCommand {
public:
  void add_to(CLI::App& layers, int& exit_code);

private:
  // The layers, and the facts for the report about them.
  struct Built {
    views::StoredLayers layers;
    std::size_t views = 1;
    std::size_t beside = 0;  // samples of other views that are outside this camera's picture
    std::vector<std::string> left_out;
    std::optional<views::RayCounts> rays;
  };

  int run();
  Result<void> check_sources() const;
  Result<void> check_asked(const Scene& scene) const;
  Result<Built> build(Progress& progress) const;
  Result<Built> build_from_scene(Progress& progress) const;
  Result<Built> build_from_pictures() const;
  Result<void> check_rays() const;
  Built build_by_rays(const Scene& scene, const Camera& camera, const View& view) const;
  double epsilon() const;
  double cube_side(const View& view) const;  // world units
  views::SampleWishes wishes() const { return {normals_, ids_}; }

  std::optional<std::string> scene_, views_, pictures_;
  std::string output_;
  std::optional<int> layers_;
  std::optional<double> epsilon_;
  std::optional<views::RaySampling> rays_;
  std::optional<double> cube_;
  std::optional<int> threads_;
  bool ends_ = false, normals_ = false, ids_ = false;
  PictureOptions picture_;
  std::optional<std::string> json_output_;
};

}  // namespace glassbox::views
