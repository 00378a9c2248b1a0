// Other sources of layers besides one view of a scene: further views of it, and pictures with known
// distances (S1-02).
#pragma once

#include <string>
#include <vector>

#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/view.h>

#include "views/files/camera_file.h"

namespace glassbox::views {

// Converts a pinhole camera to the engine's camera for a picture of width x height pixels. Depths
// are measured relative to its near plane; `far` may be absent. An error if K has a skew, because
// the engine's lenses have none.
Result<Camera> camera_of_pinhole(const PinholeCamera& pinhole, int width, int height, double near,
                                 std::optional<double> far);

// Reads the cameras of a file. An error names the file.
Result<std::vector<NamedCamera>> read_cameras(const std::string& file);

// A picture with known distances.
struct SourcePicture {
  std::string name;
  Camera camera;
  View view;
  Image<Rgba8> color;
  Image<float> distance;  // along the direction of view; infinite where there is no surface
};

// Reads the pictures that a file of cameras names. Each picture is in the file's folder. Its
// distances are in a file of the same name with the extension .pfm: along the direction of view, as
// glassbox render --depth-out and views match --depth-out write them. All pictures get the same
// near plane, at half of the smallest distance in any of them, and an infinite far plane. An error
// names the file.
Result<std::vector<SourcePicture>> read_source_pictures(const std::string& file);

}  // namespace glassbox::views
