// The sources of layers: cameras from files, and pictures with distances (S1-02).
#include <filesystem>
#include <fstream>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/render/renderer.h>

#include "tests/support/catch.h"
#include "views/layers/draw_layers.h"
#include "views/layers/layer_builder.h"
#include "views/layers/layer_sources.h"

using namespace glassbox;
using namespace glassbox::views;

namespace {

class Folder {
public:
  Folder() : path_(std::filesystem::temp_directory_path() / "glassbox-layer-sources") {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary) << text;
  }

private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("a camera of K, R and t sees what the view that it comes from sees") {
  const Scene scene = make_builtin("room").value();
  const View view = make_view(scene.cameras.at(0), 96, 64).value();
  const PinholeCamera pinhole = camera_of(view).value();
  const Camera camera = camera_of_pinhole(pinhole, 96, 64, 0.1, 50.0).value();
  const PinholeCamera again = camera_of(make_view(camera, 96, 64).value()).value();
  // Three products and a sum of doubles for each entry, of numbers up to a hundred.
  CHECK((again.intrinsic - pinhole.intrinsic).cwiseAbs().maxCoeff() < 1e-11);
  CHECK((again.camera_from_world - pinhole.camera_from_world).cwiseAbs().maxCoeff() < 1e-13);
  CHECK((again.centre - pinhole.centre).norm() < 1e-13);

  PinholeCamera skewed = pinhole;
  skewed.intrinsic(0, 1) = 0.5;
  CHECK_FALSE(camera_of_pinhole(skewed, 96, 64, 0.1, 50.0));
}

TEST_CASE(
    "a picture and its distances from files are layers that draw that picture, byte for byte") {
  const Folder folder;
  const Scene scene = make_builtin("room").value();
  const View view = make_view(scene.cameras.at(0), 48, 32).value();
  RenderSettings settings;
  settings.want_distance = true;
  const Framebuffer drawn = Renderer(scene, Transfer::kSrgb).render(view, settings).buffers;
  REQUIRE(write_image(folder.file("room.png"), drawn.color, {}));
  REQUIRE(write_file(folder.file("room.pfm"), encode_pfm(drawn.distance)));
  folder.write("cameras.txt", cameras_text({{"room.png", camera_of(view).value()}}));
  const auto pictures = read_source_pictures(folder.file("cameras.txt"));
  REQUIRE(pictures);
  REQUIRE(pictures->size() == 1);
  const SourcePicture& picture = pictures->front();
  LayerBuilder builder(layer_camera(picture.view), 0);
  CHECK(builder.add_picture(picture.view, picture.color, picture.distance) == 0);
  const LayeredImage image = builder.pack();
  REQUIRE(check(image, "pictures"));
  CHECK(draw_layers(image, image.camera, {}).color.pixels == drawn.color.pixels);
}

TEST_CASE("files of cameras and pictures that are not what they should be are named") {
  const Folder folder;
  const auto told = [&](const char* file, const char* word) {
    const auto read = read_source_pictures(folder.file(file));
    REQUIRE_FALSE(read);
    INFO(read.error().message());
    CHECK(read.error().message().find(word) != std::string::npos);
  };
  const std::string camera = " 50 0 24 0 50 16 0 0 1 1 0 0 0 1 0 0 0 1 0 0 0\n";
  told("none.txt", "none.txt");
  folder.write("empty.txt", "0\n");
  told("empty.txt", "empty.txt");
  folder.write("count.txt", "2\na.png" + camera);
  told("count.txt", "count.txt");
  folder.write("cameras.txt", "1\na.png" + camera);
  told("cameras.txt", "a.png");
  REQUIRE(write_image(folder.file("a.png"), Image<Rgba8>(4, 3), {}));
  told("cameras.txt", "a.pfm");
  REQUIRE(write_file(folder.file("a.pfm"), encode_pfm(Image<float>(4, 2, 1.0f))));
  told("cameras.txt", "4 x 2 distances, but the picture has 4 x 3 pixels");
  REQUIRE(write_file(folder.file("a.pfm"), encode_pfm(Image<float>(4, 3, -1.0f))));
  told("cameras.txt", "none of its pictures has a distance");
  folder.write("skewed.txt", "1\na.png 50 2 24 0 50 16 0 0 1 1 0 0 0 1 0 0 0 1 0 0 0\n");
  REQUIRE(write_file(folder.file("a.pfm"), encode_pfm(Image<float>(4, 3, 1.0f))));
  told("skewed.txt", "skew");
}
