// A model of COLMAP as its files have it, text or binary, and the cameras that it describes.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>

#include "views/files/colmap_file.h"

namespace glassbox::views {

// The parameters of a kind of lens are one or two focal lengths, the principal point, then
// distortion. The kinds stand in the order of their numbers in binary files.
struct ColmapLensKind {
  std::string_view name;
  std::size_t focal, parameters;
  bool is_pinhole;  // whether it is a pinhole camera where all distortion is 0
};
inline constexpr ColmapLensKind kColmapLensKinds[] = {{"SIMPLE_PINHOLE", 1, 3, true},
                                                      {"PINHOLE", 2, 4, true},
                                                      {"SIMPLE_RADIAL", 1, 4, true},
                                                      {"RADIAL", 1, 5, true},
                                                      {"OPENCV", 2, 8, true},
                                                      {"OPENCV_FISHEYE", 2, 8, false},
                                                      {"FULL_OPENCV", 2, 12, true},
                                                      {"FOV", 2, 5, false},
                                                      {"SIMPLE_RADIAL_FISHEYE", 1, 4, false},
                                                      {"RADIAL_FISHEYE", 1, 5, false},
                                                      {"THIN_PRISM_FISHEYE", 2, 12, false},
                                                      {"RAD_TAN_THIN_PRISM_FISHEYE", 2, 16, false}};

struct ColmapLens {
  std::string place;  // "cameras.txt, line 3"
  ColmapLensKind kind;
  ImageSize size;                  // px
  std::vector<double> parameters;  // kind.parameters of them
};

struct ColmapPicture {
  std::string place;           // "images.txt, line 7"
  std::array<double, 4> turn;  // quaternion w, x, y, z of the rotation from the world to the camera
  Vector3d shift;              // translation of the same
  std::int64_t lens = 0;       // its number
  std::string name;
};

// By their numbers. A lens that cannot be read is an error only where a picture needs it.
using ColmapLenses = std::map<std::int64_t, Result<ColmapLens>>;

// A size from a file; an error where it is no size of a picture.
Result<ImageSize> colmap_size(const std::string& place, double width, double height);

Result<ColmapModel> colmap_model(const ColmapLenses& lenses,
                                 const std::vector<ColmapPicture>& pictures);

}  // namespace glassbox::views
