// The pictures drawn by `views klt` and `views glyphs`, the results that they compute from
// pictures, and the pictures in which `diff` shows differences.
#include <algorithm>

#include <glassbox/compare/metrics/flip.h>
#include <glassbox/compare/metrics/metric.h>
#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/images/write.h>
#include <glassbox/render/renderer.h>

#include "tests/render/tile/generated_case.h"
#include "tests/same_bytes/configurations.h"
#include "tests/same_bytes/generated_object.h"
#include "views/glyphs/find_glyphs.h"
#include "views/glyphs/sensor.h"
#include "views/glyphs/sweep.h"
#include "views/klt/band_files.h"
#include "views/klt/globe.h"
#include "views/klt/transform.h"

namespace glassbox {
namespace {

using test::Configuration;
using test::RunResult;

// ---- klt ----

views::Bands any_bands(Random& random) {
  views::Bands bands{int(random.integer(2, 60)), int(random.integer(1, 40)), {}};
  const auto count = random.integer(1, 6);
  for (std::int64_t b = 0; b < count; ++b) {
    views::Band band{"band", {}};
    for (std::size_t i = 0; i < bands.pixels(); ++i)
      band.samples.push_back(random.between(0, 1000) +
                             (b > 0 ? bands.bands.front().samples[i] * double(b) : 0.0));
    bands.bands.push_back(std::move(band));
  }
  return bands;
}

void check_klt(std::uint64_t seed) {
  Random random(seed);
  const views::Bands bands = any_bands(random);
  const Image<Rgba8> ground(2, 1, {40, 70, 110, 255});
  test::check_same_result(seed, [&](const Configuration&) {
    RunResult made;
    const views::Klt klt = views::klt_of(bands).value();
    const views::Bands components = views::components_of(bands, klt, bands.count());
    for (const views::Band& component : components.bands) made.add("component", component.samples);
    made.add("grey", views::grey_of(components, 0, -500, 500));
    const Image<Rgba8> clouds = views::cloud_alpha(components);
    made.add("clouds", clouds);
    // The clouds are a translucent shell, most of which is inside the background's edge.
    const Scene globe = views::make_globe(ground, clouds);
    const View view = make_view(test::camera_for(globe, 1.5), 60, 40).value();
    Renderer renderer(globe, Transfer::kSrgb);
    made.add("globe", renderer.render(view, {}).buffers.color);
    return made;
  });
}

// ---- glyphs ----

void check_glyphs(std::uint64_t seed) {
  Random random(seed);
  views::WallLayout layout;
  layout.panels = int(random.integer(1, 2));
  layout.columns = 3;
  layout.rows = 2;
  const views::Wall wall = views::make_wall(layout).value();
  const double distance = random.between(0.4, 1.2);
  const double azimuth = random.between(-30, 30), elevation = random.between(-20, 20);
  const views::PinholeCamera camera =
      views::camera_in_front(distance, azimuth, elevation, 160, 120);
  views::Sensor sensor{random.between(-0.05, 0.05), random.between(0, 0.3), seed % 2 == 0, 2000};
  test::check_same_result(seed, [&](const Configuration&) {
    RunResult made;
    made.add("panel", views::draw_panel(wall, 0, 300));
    const Image<Rgba8> picture = views::WallPhotographer(wall).photograph(camera, 160, 120);
    made.add("photograph", picture);
    const Image<Rgba8> taken = views::apply_sensor(picture, sensor, seed);
    made.add("through a sensor", taken);
    for (const views::GlyphRegion& region :
         views::find_glyphs(taken, {}, wall.identities()).regions) {
      made.add_number("identity", region.identity);
      made.add_number("x", region.ellipse.centre.x());
      made.add_number("y", region.ellipse.centre.y());
    }
    return made;
  });
}

// ---- diff ----

template <class Sample>
StoredImage any_stored(int width, int height, int channels, double most, Random& random) {
  std::vector<Sample> samples(std::size_t(width) * std::size_t(height) * std::size_t(channels));
  for (Sample& sample : samples) sample = Sample(random.between(0, most));
  return {width, height, channels, std::move(samples)};
}

// The same picture with some samples changed.
template <class Sample>
StoredImage altered(StoredImage image, double most, Random& random) {
  for (Sample& sample : std::get<std::vector<Sample>>(image.samples)) {
    if (random.integer(0, 3) == 0) sample = Sample(random.between(0, most));
  }
  return image;
}

template <class Sample>
void check_diff(std::uint64_t seed, double most) {
  Random random(seed);
  const int width = int(random.integer(1, 300)), height = int(random.integer(1, 150));
  const int channels = int(random.integer(1, 4));
  const StoredImage reference = any_stored<Sample>(width, height, channels, most, random);
  const StoredImage test = altered<Sample>(reference, most, random);
  Selection selection(width, height);
  if (seed % 2 == 0) REQUIRE(selection.exclude({width / 3, height / 3, 9, 9}));
  test::check_same_result(seed, [&](const Configuration&) {
    const PicturePair pair{reference, test, selection};
    RunResult made;
    for (const MetricValue& value :
         measure_metrics(pair, parse_metrics("absmax,rmse,psnr,ssim,flip").value()))
      made.add_number(value.name.c_str(), value.value.value_or(-1));
    const Image<std::uint8_t> heat = heat_map(pair);
    made.add("heat", heat_picture(heat));
    if constexpr (!std::is_same_v<Sample, float>) {
      if (channels != 2) made.add("what FLIP sees", flip_heat_map(pair));
    }
    for (const Region& region : find_differences(pair).regions) {
      made.add_number("region", region.pixels);
      made.add_number("largest", region.largest);
    }
    return made;
  });
}

// A picture file is compressed in bands in parallel; large pictures have several bands.
void check_file(std::uint64_t seed) {
  Random random(seed);
  const int width = int(random.integer(1, 500)), height = int(random.integer(1, 900));
  Image<Rgba8> picture(width, height);
  for (Rgba8& pixel : picture.pixels) {
    const std::uint64_t bits = random.bits();
    if (bits % 8 == 0) pixel = {std::uint8_t(bits >> 8), std::uint8_t(bits >> 16), 7, 255};
  }
  test::check_same_result(seed, [&](const Configuration&) {
    RunResult made;
    made.add("file", encode_png(picture).value());
    return made;
  });
}

template <class Check>
void check_seeds(std::uint64_t count, const Check& check) {
  for (std::uint64_t seed = 0; seed < count; ++seed) check(seed);
  SUCCEED("what differs fails by itself");
}

void check_any_diff(std::uint64_t seed) {
  if (seed % 3 == 0) return check_diff<std::uint8_t>(seed, 255.999);
  if (seed % 3 == 1) return check_diff<std::uint16_t>(seed, 65535.999);
  check_diff<float>(seed, 2);
}

TEST_CASE("components of bands and their globe have the same bytes in every way", "[colours]") {
  check_seeds(4 / test::kCaseDivisor + 1, check_klt);
}

TEST_CASE("walls of glyphs, their photographs and what is found there are the same in every way",
          "[colours]") {
  check_seeds(1 / test::kCaseDivisor + 1, check_glyphs);
}

TEST_CASE("what diff measures and shows is the same in every way", "[colours]") {
  check_seeds(6 / test::kCaseDivisor + 1, check_any_diff);
}

TEST_CASE("a picture's file has the same bytes in every way", "[colours]") {
  check_seeds(3 / test::kCaseDivisor + 1, check_file);
}

TEST_CASE("some hundred components, walls, differences and files", "[.same-bytes]") {
  check_seeds(200, check_klt);
  check_seeds(100, check_glyphs);
  check_seeds(300, check_any_diff);
  check_seeds(50, check_file);
}

}  // namespace
}  // namespace glassbox
