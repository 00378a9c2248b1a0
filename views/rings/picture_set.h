// Calibrated pictures: files in, and out. What shapes are made from (S1-29).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/images/image.h>

#include "views/files/camera_file.h"
#include "views/rings/ring.h"

namespace glassbox::views {

struct CalibratedPicture {
  std::string name;
  PinholeCamera camera;
  Image<Rgba8> color;
  Image<std::uint8_t> matte;  // 255: the object, 0: background; empty where nothing is known
};

struct PictureSet {
  std::string source;  // the file with the cameras
  std::vector<CalibratedPicture> pictures;
  std::optional<WorldBox> box;  // of a file box.txt beside the cameras
};

// What pixels and mattes take.
double bytes_of(const CalibratedPicture& picture);
double bytes_of(const PictureSet& set);
double pixels_of(const PictureSet& set);
// Pixels that may be the object's: those of the mattes, and all of pictures without one.
double object_pixels_of(const PictureSet& set);

struct PictureSetOptions {
  bool wants_mattes = true;
  // A pixel brighter than this, 0 .. 255 in its brightest channel, is the object's; absent: as masks or alpha say.
  std::optional<int> matte_above;
  // Indices from 0 of the cameras to take, in this order; empty: all.
  std::vector<std::size_t> chosen;
  std::uint64_t most_bytes = std::uint64_t(1) << 32;  // of all decoded pictures
};

// `path` is a folder with one file *_par.txt, or with cameras.txt and images.txt as COLMAP writes them, or one of these files. Pictures
// lie in the same folder or below it (images/ too), mattes in masks/ under the same names. Refused: cameras that parse_cameras or
// parse_colmap refuse, pictures that are missing or leave the folder, mattes of another size than their picture, fewer than one
// camera or more than kMostRingViews, and pictures that would take more than `most_bytes`, before they are decoded.
Result<PictureSet> read_picture_set(const std::string& path, const PictureSetOptions& options);

// A matte that has the object where is_object(i) says so of pixel i.
template <class IsObject>
Image<std::uint8_t> matte_where(int width, int height, const IsObject& is_object) {
  Image<std::uint8_t> matte(width, height, 0);
  for (std::size_t i = 0; i < matte.pixels.size(); ++i) matte.pixels[i] = is_object(i) ? 255 : 0;
  return matte;
}

// All files that a set of pictures of these names may have in its folder.
std::vector<std::string> files_of_set(const std::string& folder,
                                      const std::vector<std::string>& names);

// Writes the files of a ring, a picture at a time: NAME.png, masks/NAME.png, box.txt and last ring_par.txt, in a folder that is made if
// need be. What an earlier ring of the same names left there goes: its cameras at once, so that a folder that has cameras is whole.
class PictureSetWriter {
public:
  static Result<PictureSetWriter> open(const std::string& folder);
  Result<void> add(const CalibratedPicture& picture);
  Result<void> close(const std::optional<WorldBox>& box);

private:
  explicit PictureSetWriter(const std::string& folder) : folder_(folder) {}
  std::string folder_;
  std::vector<NamedCamera> cameras_;
};
Result<void> write_picture_set(const std::string& folder, const PictureSet& set);

// "x0 y0 z0" and "x1 y1 z1", a line each.
Result<WorldBox> parse_box(std::string_view text);

}  // namespace glassbox::views
