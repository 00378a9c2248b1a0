#include "views/rings/picture_set.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <span>

#include <fmt/format.h>

#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/input/directory.h>

#include "views/files/colmap_file.h"
#include "views/files/number_rows.h"

namespace glassbox::views {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxText = std::uint64_t(1) << 28;
constexpr std::string_view kMiddlebury = "_par.txt";
constexpr const char *kRingFile = "ring_par.txt", *kBoxFile = "box.txt";

Result<std::string> text_of(const fs::path& path) {
  return read_file(path.string(), kMaxText).map([](const std::vector<std::byte>& bytes) {
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  });
}

template <class T>
Result<T> with_file(Result<T> result, const std::string& file) {
  if (!result) result.error().file = file;
  return result;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// Where the cameras of a set of pictures are.
struct CameraFiles {
  fs::path cameras;  // what messages name
  fs::path images;   // COLMAP's other file; empty for Middlebury's
  fs::path root;     // the folder that has the pictures, masks and box.txt
  std::vector<std::string> warnings;

  bool is_colmap() const { return !images.empty(); }
};

// The folder with sparse/ in it where COLMAP's model is in sparse/ or sparse/N and the pictures are
// in images/ beside sparse/; otherwise the folder itself.
fs::path root_of_model(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::canonical(folder.empty() ? "." : folder, error);
  for (const fs::path& sparse : {whole, whole.parent_path()}) {
    const fs::path root = sparse.parent_path();
    if (sparse.filename() == "sparse" && fs::is_directory(root / "images", error)) return root;
  }
  return folder;
}

// COLMAP's two files in a folder. Binary ones come first, as COLMAP itself does it.
std::optional<CameraFiles> colmap_in(const fs::path& folder) {
  for (const char* extension : {".bin", ".txt"}) {
    const fs::path cameras = folder / (std::string("cameras") + extension);
    const fs::path images = folder / (std::string("images") + extension);
    if (is_file(cameras) && is_file(images)) {
      return CameraFiles{cameras, images, root_of_model(folder), {}};
    }
  }
  return std::nullopt;
}

// A folder with several models is noted.
std::optional<CameraFiles> colmap_below(const fs::path& folder) {
  const fs::path sparse = folder / "sparse";
  for (const fs::path& place : {folder, sparse / "0", sparse, folder / "0"}) {
    auto found = colmap_in(place);
    if (!found) continue;
    if (place.filename() == "0" && fs::exists(place.parent_path() / "1")) {
      found->warnings.push_back(
          "there are several models of COLMAP; the one in the folder 0 is read");
    }
    return found;
  }
  return std::nullopt;
}

// Finds the cameras of a folder.
Result<CameraFiles> cameras_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().filename().string().ends_with(kMiddlebury)) found.push_back(entry.path());
  }
  if (found.size() == 1) return CameraFiles{found.front(), {}, folder, {}};
  if (found.size() > 1) {
    return tl::unexpected(Error{
        folder.string(), "",
        fmt::format("has {} files of cameras (*_par.txt), so it is not clear which one to read",
                    found.size()),
        "name one of these files instead of the folder"});
  }
  if (auto model = colmap_below(folder)) return std::move(*model);
  return tl::unexpected(
      Error{folder.string(), "",
            "has no cameras: neither *_par.txt nor COLMAP's cameras and images "
            "(.bin or .txt), also not in sparse/0",
            "a folder with cameras is made by: glassbox views ring SCENE -o DIR"});
}

// The cameras of a file: one of COLMAP's, named by any of its files, or one of Middlebury's.
Result<CameraFiles> cameras_of_file(const fs::path& file) {
  const fs::path folder = file.parent_path();
  const std::string stem = file.stem().string(), extension = file.extension().string();
  const bool is_model = stem == "cameras" || stem == "images" || stem == "points3D";
  if (!is_model || (extension != ".bin" && extension != ".txt")) {
    return CameraFiles{file, {}, folder, {}};
  }
  return CameraFiles{
      folder / ("cameras" + extension), folder / ("images" + extension), root_of_model(folder), {}};
}

Result<std::vector<std::byte>> bytes_of_file(const fs::path& path) {
  return read_file(path.string(), kMaxText);
}

Result<ColmapModel> read_model(const CameraFiles& files) {
  const auto cameras = bytes_of_file(files.cameras);
  if (!cameras) return tl::unexpected(cameras.error());
  const auto images = bytes_of_file(files.images);
  if (!images) return tl::unexpected(images.error());
  const auto text = [](const std::vector<std::byte>& bytes) {
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  };
  const bool binary = files.cameras.extension() == ".bin";
  return with_file(
      binary ? parse_colmap_binary(*cameras, *images) : parse_colmap(text(*cameras), text(*images)),
      files.cameras.parent_path().string());
}

Result<ColmapModel> model_of(const CameraFiles& files) {
  if (files.is_colmap()) return read_model(files);
  const auto text = text_of(files.cameras);
  if (!text) return tl::unexpected(text.error());
  return with_file(parse_cameras(*text), files.cameras.string()).map([](auto cameras) {
    return ColmapModel{std::move(cameras), {}};
  });
}

Result<std::vector<NamedCamera>> select_cameras(std::vector<NamedCamera> all,
                                                const std::string& file,
                                                const std::vector<std::size_t>& chosen) {
  if (chosen.empty()) return all;
  std::vector<NamedCamera> some;
  for (const std::size_t index : chosen) {
    if (index >= all.size()) {
      return tl::unexpected(Error{
          file, "", fmt::format("has {} cameras, so there is no number {}", all.size(), index + 1),
          "give numbers from 1 to the number of cameras"});
    }
    some.push_back(all[index]);
  }
  return some;
}

std::uint8_t brightest(const Rgba8& pixel) {
  return std::max({pixel.r, pixel.g, pixel.b});
}

Image<std::uint8_t> matte_by(const Image<Rgba8>& color, auto is_object) {
  return matte_where(color.width, color.height,
                     [&](std::size_t i) { return is_object(color.pixels[i]); });
}

// The number of pixels of a picture file, from its header; 0 if the header does not say.
std::uint64_t pixels_in(const fs::path& path) {
  const auto bytes = read_file(path.string());
  const auto size = bytes ? find_image_size(*bytes) : std::nullopt;
  return size ? std::uint64_t(size->width) * size->height : 0;
}

class Reader {
public:
  Reader(const CameraFiles& files, const PictureSetOptions& options)
      : options_(options),
        directory_(files.root / "cameras", "camera", options.most_bytes),
        folder_(files.root),
        orientation_(files.is_colmap() ? Orientation::kStored : Orientation::kUpright),
        bytes_left_(options.most_bytes) {}

  Result<CalibratedPicture> read(const NamedCamera& named) {
    CalibratedPicture picture{named.picture, named.camera, {}, {}};
    auto path = directory_.find(named.picture);
    if (!path) path = directory_.find("images/" + named.picture);
    if (!path) return tl::unexpected(path.error());
    auto color = decode(*path);
    if (!color) return tl::unexpected(color.error());
    picture.color = std::move(*color);
    if (const auto fits = check_size(named, picture.color, *path); !fits) {
      return tl::unexpected(fits.error());
    }
    if (options_.wants_mattes) {
      if (const auto added = add_matte(picture); !added) return tl::unexpected(added.error());
    }
    return picture;
  }

private:
  // Decodes a picture, if the memory for its pixels is within the limit; this is checked first.
  Result<Image<Rgba8>> decode(const fs::path& path) {
    DecodeLimits limits;
    limits.max_pixels = std::min<std::uint64_t>(limits.max_pixels, bytes_left_ / sizeof(Rgba8));
    auto image = read_image(path.string(), limits, orientation_);
    if (image) {
      bytes_left_ -= sizeof(Rgba8) * image->pixels.size();
    } else if (pixels_in(path) > bytes_left_ / sizeof(Rgba8)) {
      return tl::unexpected(
          Error{path.string(), "",
                fmt::format("the pictures take more than the {} MB that are allowed",
                            options_.most_bytes >> 20),
                "allow more with --max-mb, or choose fewer pictures"});
    }
    return image;
  }

  // A camera counts in the pixels of the pictures that it was computed from. Smaller ones could be
  // scaled or cut out of these, and the camera would be another one.
  static Result<void> check_size(const NamedCamera& named, const Image<Rgba8>& color,
                                 const fs::path& path) {
    if (!named.size || (named.size->width == std::uint32_t(color.width) &&
                        named.size->height == std::uint32_t(color.height))) {
      return {};
    }
    return tl::unexpected(
        Error{path.string(), "",
              fmt::format("is {} x {}, but its camera is one for {} x {} pixels", color.width,
                          color.height, named.size->width, named.size->height),
              "give the pictures that the model was computed from, or let COLMAP scale model and "
              "pictures together (colmap image_undistorter --max_image_size N)"});
  }

  Result<void> add_matte(CalibratedPicture& picture) {
    if (options_.matte_above) {
      picture.matte = matte_by(picture.color, [&](const Rgba8& pixel) {
        return brightest(pixel) > *options_.matte_above;
      });
      return {};
    }
    // COLMAP gives the mask of a.jpg the name a.jpg.png.
    for (const std::string& name : {"masks/" + picture.name, "masks/" + picture.name + ".png"}) {
      if (!is_file(folder_ / name)) continue;
      const auto path = directory_.find(name);
      if (!path) return tl::unexpected(path.error());
      const auto mask = decode(*path);
      if (!mask) return tl::unexpected(mask.error());
      if (mask->width != picture.color.width || mask->height != picture.color.height) {
        return tl::unexpected(
            Error{path->string(), "",
                  fmt::format("is {} x {}, but its picture is {} x {}", mask->width, mask->height,
                              picture.color.width, picture.color.height),
                  "make the mask as large as the picture"});
      }
      picture.matte = matte_by(*mask, [](const Rgba8& pixel) { return brightest(pixel) >= 128; });
      return {};
    }
    const bool has_alpha = std::ranges::any_of(picture.color.pixels,
                                               [](const Rgba8& pixel) { return pixel.a != 255; });
    if (has_alpha)
      picture.matte = matte_by(picture.color, [](const Rgba8& pixel) { return pixel.a >= 128; });
    return {};
  }

  const PictureSetOptions& options_;
  obj::Directory directory_;
  fs::path folder_;
  Orientation orientation_;
  std::uint64_t bytes_left_;
};

Image<Rgba8> grey_of(const Image<std::uint8_t>& matte) {
  Image<Rgba8> picture(matte.width, matte.height);
  for (std::size_t i = 0; i < matte.pixels.size(); ++i) {
    const std::uint8_t value = matte.pixels[i];
    picture.pixels[i] = {value, value, value, 255};
  }
  return picture;
}

Result<void> write_text(const fs::path& path, const std::string& text) {
  return write_file(path.string(), std::as_bytes(std::span(text)));
}

}  // namespace

double bytes_of(const CalibratedPicture& picture) {
  return double(sizeof(Rgba8) * picture.color.pixels.size() + picture.matte.pixels.size());
}

double bytes_of(const PictureSet& set) {
  double bytes = 0;
  for (const CalibratedPicture& picture : set.pictures) bytes += bytes_of(picture);
  return bytes;
}

double pixels_of(const PictureSet& set) {
  double pixels = 0;
  for (const CalibratedPicture& picture : set.pictures)
    pixels += double(picture.color.pixels.size());
  return pixels;
}

double object_pixels_of(const PictureSet& set) {
  double pixels = 0;
  for (const auto& [name, camera, color, matte] : set.pictures) {
    pixels += double(matte.pixels.empty()
                         ? color.pixels.size()
                         : matte.pixels.size() - std::size_t(std::ranges::count(matte.pixels, 0)));
  }
  return pixels;
}

Result<WorldBox> parse_box(std::string_view text) {
  const auto rows = number_rows(text);
  if (!rows) return tl::unexpected(rows.error());
  const bool has_form = rows->size() == 2 && (*rows)[0].numbers.size() == 3 &&
                        (*rows)[1].numbers.size() == 3 && (*rows)[0].name.empty() &&
                        (*rows)[1].name.empty();
  if (!has_form) {
    return fail("", "a box needs two lines of three numbers",
                "write the corner of least coordinates, then the corner of greatest coordinates");
  }
  WorldBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = (*rows)[0].numbers[std::size_t(axis)];
    box.high[axis] = (*rows)[1].numbers[std::size_t(axis)];
  }
  if (!((box.high - box.low).minCoeff() > 0)) {
    return fail(
        "", "the box is empty: a coordinate of the first corner is not below that of the second",
        "write the corner of least coordinates first");
  }
  return box;
}

Result<PictureSet> read_picture_set(const std::string& path, const PictureSetOptions& options) {
  std::error_code error;
  auto files = fs::is_directory(path, error) ? cameras_in(path) : cameras_of_file(path);
  if (!files) return tl::unexpected(files.error());
  const std::string file = files->cameras.string();
  auto model = model_of(*files);
  if (!model) return tl::unexpected(model.error());
  const auto cameras = select_cameras(std::move(model->cameras), file, options.chosen);
  if (!cameras) return tl::unexpected(cameras.error());
  if (cameras->empty() || cameras->size() > std::size_t(kMaxRingViews)) {
    return tl::unexpected(Error{
        file, "",
        fmt::format("has {} cameras, but 1 to {} are possible", cameras->size(), kMaxRingViews),
        "choose fewer cameras, but at least one"});
  }
  PictureSet set{file, {}, {}, std::move(files->warnings)};
  std::ranges::move(model->warnings, std::back_inserter(set.warnings));
  Reader reader(*files, options);
  for (const NamedCamera& camera : *cameras) {
    auto picture = reader.read(camera);
    if (!picture) return tl::unexpected(picture.error());
    set.pictures.push_back(std::move(*picture));
  }
  const fs::path box = files->root / kBoxFile;
  if (is_file(box)) {
    const auto text = text_of(box);
    if (!text) return tl::unexpected(text.error());
    const auto parsed = with_file(parse_box(*text), box.string());
    if (!parsed) return tl::unexpected(parsed.error());
    set.box = *parsed;
  }
  return set;
}

std::vector<std::string> files_of_set(const std::string& folder,
                                      const std::vector<std::string>& names) {
  const fs::path place(folder);
  std::vector<std::string> files{(place / kRingFile).string(), (place / kBoxFile).string()};
  for (const std::string& name : names) {
    files.push_back((place / name).string());
    files.push_back((place / "masks" / name).string());
  }
  return files;
}

Result<PictureSetWriter> PictureSetWriter::open(const std::string& folder) {
  std::error_code error;
  fs::create_directories(fs::path(folder) / "masks", error);
  if (!error) fs::remove(fs::path(folder) / kRingFile, error);
  if (!error) fs::remove(fs::path(folder) / kBoxFile, error);
  if (error) {
    return tl::unexpected(Error{folder, "", "cannot be written to: " + error.message(),
                                "name a folder that can be written to"});
  }
  return PictureSetWriter(folder);
}

Result<void> PictureSetWriter::add(const CalibratedPicture& picture) {
  const fs::path path = fs::path(folder_) / picture.name;
  const fs::path mask = fs::path(folder_) / "masks" / picture.name;
  // Removes the masks that an earlier picture of this name has left behind.
  for (const std::string& stale : {mask.string(), mask.string() + ".png"}) {
    std::error_code error;
    fs::remove(stale, error);
    if (error)
      return tl::unexpected(
          Error{stale, "", "cannot be removed: " + error.message(), "remove it yourself"});
  }
  if (const auto written = write_image(path.string(), picture.color); !written) return written;
  if (!picture.matte.pixels.empty()) {
    const auto written = write_image(mask.string(), grey_of(picture.matte));
    if (!written) return written;
  }
  cameras_.push_back({picture.name, picture.camera, {}});
  return {};
}

Result<void> PictureSetWriter::close(const std::optional<WorldBox>& box) {
  if (box) {
    const auto& [low, high] = *box;
    const auto written = write_text(fs::path(folder_) / kBoxFile,
                                    fmt::format("{} {} {}\n{} {} {}\n", low.x(), low.y(), low.z(),
                                                high.x(), high.y(), high.z()));
    if (!written) return written;
  }
  return write_text(fs::path(folder_) / kRingFile, cameras_text(cameras_));
}

Result<void> write_picture_set(const std::string& folder, const PictureSet& set) {
  auto writer = PictureSetWriter::open(folder);
  if (!writer) return tl::unexpected(writer.error());
  for (const CalibratedPicture& picture : set.pictures) {
    if (const auto added = writer->add(picture); !added) return added;
  }
  return writer->close(set.box);
}

}  // namespace glassbox::views
