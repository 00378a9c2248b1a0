// What layers are made of beside one view of a scene: other views of it, and pictures whose distances are known (S1-02).
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

#include "views/files/camera_file.h"

namespace glassbox::views {

// A camera of a picture of width x height pixels, as views render it. Its near plane is what depths are measured with; `far` may be
// absent. An error where K has a skew, which no lens of ours has.
Result<Camera> camera_of_pinhole(const PinholeCamera& pinhole, int width, int height, double near,
                                 std::optional<double> far);

// The cameras of a file. An error names the file.
Result<std::vector<NamedCamera>> read_cameras(const std::string& file);

// A picture whose distances are known.
struct SourcePicture {
  std::string name;
  Camera camera;
  View view;
  Image<Rgba8> color;
  Image<float> distance;  // along the gaze; infinite where there is nothing
};

// Those that a file of cameras names: each line's picture, in the file's folder, and beside it, with the ending .pfm in place of its own,
// the distances along the gaze, as glassbox render --depth-out and views match --depth-out write them. All have one near plane, half as
// far as what is nearest in any of them, and an infinite far one. An error names the file.
Result<std::vector<SourcePicture>> read_source_pictures(const std::string& file);

}  // namespace glassbox::views
