// Calibrated pictures (pictures with known cameras), read from files and written to files. Shapes
// are reconstructed from them (S1-29).
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
  Image<std::uint8_t> matte;  // 255: the object, 0: background; empty if unknown
};

struct PictureSet {
  std::string source;  // the file with the cameras
  std::vector<CalibratedPicture> pictures;
  std::optional<WorldBox> box;  // from a file box.txt beside the pictures' folders
  std::vector<std::string> warnings;
};

// Bytes that the pixels and mattes occupy.
double bytes_of(const CalibratedPicture& picture);
double bytes_of(const PictureSet& set);
double pixels_of(const PictureSet& set);
// The number of pixels that may show the object: those in the mattes, and all pixels of pictures
// without a matte.
double object_pixels_of(const PictureSet& set);

struct PictureSetOptions {
  bool wants_mattes = true;
  // A pixel belongs to the object if its brightest channel is above this, 0 .. 255. Absent: the
  // masks or alpha decide.
  std::optional<int> matte_above;
  // Indices from 0 of the cameras to use, in this order; empty: all.
  std::vector<std::size_t> chosen;
  std::uint64_t most_bytes = std::uint64_t(1) << 32;  // of all decoded pictures
};

// `path` is a folder with one file *_par.txt, or with a model of COLMAP (cameras and images, both
// .bin or both .txt) in it, in sparse/0 or in sparse; or it is one of these files. Pictures are in
// the same folder or below it (images/ too), mattes in masks/ under the same names; for a model
// below sparse/, the folder is the one with sparse/ in it. A JPEG of COLMAP's has its pixels
// taken as stored, because COLMAP ignores the orientation in its Exif data. Refused: cameras that
// parse_cameras or parse_colmap refuses, pictures that are missing, outside of the folder, or of
// another size than COLMAP's lens, mattes of another size than their picture, fewer than one camera
// or more than kMaxRingViews, and pictures that would need more than `most_bytes` (checked before
// they are decoded).
Result<PictureSet> read_picture_set(const std::string& path, const PictureSetOptions& options);

// A matte in which pixel i belongs to the object if is_object(i) is true.
template <class IsObject>
Image<std::uint8_t> matte_where(int width, int height, const IsObject& is_object) {
  Image<std::uint8_t> matte(width, height, 0);
  for (std::size_t i = 0; i < matte.pixels.size(); ++i) matte.pixels[i] = is_object(i) ? 255 : 0;
  return matte;
}

// All files that a set of pictures with these names may have in its folder.
std::vector<std::string> files_of_set(const std::string& folder,
                                      const std::vector<std::string>& names);

// Writes the files of a ring, one picture after the other: NAME.png, masks/NAME.png, box.txt and at
// the end ring_par.txt. The folder is created if it does not exist. Files left there by an earlier
// ring of the same names are removed, its camera file first, so that a folder with a camera file is
// always complete.
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

// The text has two lines, "x0 y0 z0" and "x1 y1 z1".
Result<WorldBox> parse_box(std::string_view text);

}  // namespace glassbox::views
