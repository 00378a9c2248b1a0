// The experiments on depth, culling, the second eye, anaglyphs, the order in which pixels are
// visited, work left out by a plan, tracing and samples.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include <glassbox/base/random.h>
#include <glassbox/images/read.h>
#include <glassbox/mesh/builtin/forest.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/render/staged/staged.h>

#include "study/experiments/d09_tests.h"
#include "study/experiments/d11_pair_setup.h"
#include "study/experiments/d12_leaves.h"
#include "study/experiments/warp/warp.h"
#include "tests/study/experiments/check_experiment.h"
#include "tests/support/skip.h"

using namespace glassbox;
using namespace glassbox::study;
using namespace glassbox::test;

TEST_CASE(
    "D-6: a reversed float depth tells surfaces apart at any distance, and loses that through [-1, "
    "1]") {
  const auto all = check_experiment(d06_depth());
  for (const double z : {0.2, 1.0, 10.0, 100.0, 1000.0, 9000.0}) {
    // Surfaces at two neighbouring floats of the distance are distinguished: 2^-23.
    CHECK(error_at(all, "float, reversed", "ladder", z) <= 0x1p-23);
    CHECK(error_at(all, "float, reversed, infinite far", "ladder", z) <= 0x1p-23);
  }
  CHECK(error_at(all, "float, reversed through [-1, 1]", "ladder", 1000) > 1000 * 0x1p-23);
  // The city is within the distances of the ladder: no format is coarser there than where it is
  // coarsest on the ladder.
  for (const Measured& m : all) {
    if (m.configuration.scene != "city of boxes") continue;
    double coarsest = 0;
    for (const auto& [other, error] : all) {
      if (other.series == m.configuration.series && other.scene == "ladder") {
        coarsest = std::max(coarsest, *other.predicted_error);
      }
    }
    INFO(describe(m));
    CHECK(m.error <= 2 * coarsest);
  }
  // Reversing has no effect on fixed point (Reed 2015).
  for (const double z : {1.0, 10.0, 100.0}) {
    const double ratio =
        error_at(all, "u24, reversed", "ladder", z) / error_at(all, "u24", "ladder", z);
    CHECK((ratio > 0.5 && ratio < 2));
  }
}

TEST_CASE("D-9: only the test that knows nothing of the snap throws fronts away") {
  const auto all = check_experiment(d09_culling());
  for (const char* safe :
       {"none", "snapped area", "cluster cones", "filter, exact sum where needed, margin"})
    CHECK(largest_error(all, safe) == 0);
  CHECK(largest_error(all, "object-space dot product, float") > 0);
}

TEST_CASE("D-9: a filter decides as expansions do, or lets them decide") {
  const auto all = check_experiment(d09_culling());
  // In float: eight roundings of 2^-24 of terms that are no smaller than their sum. In double: the
  // same with 2^-53, 2^29 times less.
  for (const char* scene : {"teapot", "ellipsoid", "ellipsoid with the triangle sizes of a scan"}) {
    const double in_float = largest_error(all, "filter in float", scene, "exact fallbacks"),
                 in_double = largest_error(all, "filter in double", scene, "exact fallbacks");
    INFO(scene);
    CHECK(in_float > 0x1p-24);
    CHECK(in_float < 32 * 0x1p-24);
    CHECK(in_double > 0x1p-53);
    CHECK(in_double < 64 * 0x1p-53);
  }
  Random random(1);
  const auto coordinate = [&] { return float(random.between(-1, 1)); };
  int exact = 0, fronts = 0;
  for (int i = 0; i < 20000; ++i) {
    d09::ObjectTriangle t;
    for (Point<Object>& p : t) {
      p.x = coordinate(), p.y = coordinate(), p.z = coordinate();
    }
    // In the plane of the triangle, apart from the point's own rounding.
    const float s = coordinate(), r = coordinate();
    const Vector<Object, double> eye{
        double(t[0].x + s * (t[1].x - t[0].x) + r * (t[2].x - t[0].x)),
        double(t[0].y + s * (t[1].y - t[0].y) + r * (t[2].y - t[0].y)),
        double(t[0].z + s * (t[1].z - t[0].z) + r * (t[2].z - t[0].z))};
    const d09::Filtered one = d09::filter_in_float(t, eye), other = d09::filter_in_double(t, eye);
    CHECK(one.back == other.back);
    exact += one.used_exact;
    fronts += !one.back;
  }
  CHECK(exact > 10000);  // they are that close to the plane
  CHECK((fronts > 8000 && fronts < 12000));
}

TEST_CASE("D-10: culling by the centre camera loses half the parallax, by the union nothing") {
  const auto all = check_experiment(d10_stereo_culling());
  CHECK(largest_error(all, "each eye by itself") == 0);
  CHECK(largest_error(all, "union, eight planes") == 0);
  CHECK(largest_error(all, "union, bounding sphere of the object") == 0);
  CHECK(largest_error(all, "centre camera", "strips behind the window") > 10);
}

TEST_CASE(
    "D-11: shared stages give the second eye's bytes; a warp lacks its holes, which layers fill") {
  const auto all = check_experiment(d11_second_eye());
  CHECK(largest_error(all, "shared vertex stage") == 0);
  CHECK(largest_error(all, "tile engine, shared stages") == 0);
  const char* cards = "cards before a wall";
  const double one = largest_error(all, "depth-image warp", cards),
               two = largest_error(all, "warp of 2 layers", cards);
  CHECK(two < one);
  CHECK(largest_error(all, "depth-image warp, holes filled", cards) < one);
  CHECK(largest_error(all, "warp of 3 layers", cards) == 0);
  double before = HUGE_VAL;
  for (const char* better : {"left picture twice", "depth-image warp", "warp of 2 layers",
                             "warp of 3 layers", "warp of 4 layers"}) {
    const double error = largest_error(all, better, "forest");
    INFO(better);
    CHECK(error < before);
    before = error;
  }
  for (const std::string layers : {"depth-image warp", "warp of 2 layers"}) {
    CHECK(largest_error(all, layers + ", holes filled", "forest") <
          largest_error(all, layers, "forest"));
  }
  CHECK(largest_error(all, "tile engine, depth-image warp", "forest") ==
        largest_error(all, "depth-image warp", "forest"));
}

TEST_CASE("D-11: PSNR is the RMS difference in decibels, and is infinite where there is none") {
  const auto all = check_experiment(d11_second_eye());
  int judged = 0, exact = 0;
  for (const Measured& m : all) {
    const Configuration& c = m.configuration;
    if (c.measure != "PSNR") continue;
    INFO(describe(m));
    ++judged;
    const double rms = error_at(all, c.series, c.scene, c.parameter);
    if (rms == 0) {
      ++exact;
      CHECK(std::isinf(m.error));
    } else {
      CHECK(m.error == 20 * std::log10(255 / rms));
    }
  }
  CHECK(judged == 24);
  // Four methods that draw exactly on either scene, and three and four layers of cards.
  CHECK(exact == 10);
}

TEST_CASE(
    "D-11: holes are what RMS and PSNR come from, and fewer with each layer; filling leaves none") {
  const auto all = check_experiment(d11_second_eye());
  for (const char* scene : {"cards before a wall", "forest"}) {
    INFO(scene);
    const auto holes = [&](const char* way) { return largest_error(all, way, scene, "holes"); };
    CHECK(holes("depth-image warp") > holes("warp of 2 layers"));
    CHECK(holes("warp of 2 layers") > holes("warp of 3 layers"));
    CHECK(holes("warp of 3 layers") >= holes("warp of 4 layers"));
    CHECK(holes("tile engine, depth-image warp") == holes("depth-image warp"));
    for (const char* full : {"depth-image warp, holes filled", "warp of 2 layers, holes filled",
                             "shared vertex stage", "left picture twice"})
      CHECK(holes(full) == 0);
    // Drawn pixels have the right distance. The left picture has no disparity, which is wrong by 12
    // px on the cards, in floats.
    CHECK(largest_error(all, "shared vertex stage", scene, "disparity") == 0);
    CHECK(largest_error(all, "tile engine, shared stages", scene, "disparity") == 0);
    CHECK(largest_error(all, "left picture twice", scene, "disparity") > 11.999);
  }
}

TEST_CASE(
    "D-11: a set-up that shares y is each eye's own, and one that should not be shared is seen") {
  using namespace d11;
  Scene forest = make_forest();
  const View centre = make_view(forest.cameras.front(), 240, 160).value();
  std::vector<PairTriangle> triangles =
      pair_triangles(*d10::make_eyes(std::move(forest), centre, {0.02 * 12, 12}));
  REQUIRE(triangles.size() > 10000);
  int degenerate = 0, moved = 0, both_ways = 0;
  for (PairTriangle t : triangles) {
    const auto alone = set_up_each(t), shared = set_up_shared(t);
    for (const std::size_t eye : {0u, 1u}) CHECK(are_same(alone[eye], shared[eye]));
    degenerate += !alone[0].has_value();
    both_ways += alone[0] && alone[1] && alone[0]->clockwise != alone[1]->clockwise;
    // A right eye that is 1/256 px higher than the left one shares nothing with it.
    for (ScreenVertex& v : t.right) v.position.y += 1.0f / 256;
    const auto higher = set_up_each(t), wrong = set_up_shared(t);
    moved += higher[1].has_value() && !are_same(higher[1], wrong[1]);
  }
  CHECK(moved + degenerate > int(triangles.size()) * 9 / 10);
  CHECK(both_ways > 0);  // thin triangles of which only one eye sees the front
}

// The errors of a warp of the forest: the share of pixels that are holes, and the error of the
// other pixels that show the right surface.
struct WarpedForest {
  double holes = 0;
  double rms_elsewhere = 0;  // in 1/255
};
WarpedForest warped_forest(int layers, Cull cull = Cull::kMaterial) {
  const Scene forest = make_forest();
  const View centre = make_view(forest.cameras.front(), 240, 160).value();
  const StereoPair pair{0.02 * 12, 12};
  RenderSettings settings;
  settings.transfer = Transfer::kNone;
  settings.want_distance = true;
  settings.cull = cull;
  const Framebuffer right =
      render_staged(forest, eye_view(centre, pair, Side::kRight), settings).buffers;
  const Warped warped =
      warp(peel(forest, eye_view(centre, pair, Side::kLeft), settings, layers), centre, pair, {});
  double holes = 0, squares = 0, same = 0;
  for (std::size_t i = 0; i < right.color.pixels.size(); ++i) {
    const double z = double(right.distance.pixels[i]), found = double(warped.distance.pixels[i]);
    holes += std::isfinite(z) && !std::isfinite(found);
    if (!(std::abs(found - z) < 0.02 * z)) continue;
    const Rgba8 &a = right.color.pixels[i], &b = warped.color.pixels[i];
    squares += (a.r - b.r) * (a.r - b.r) + (a.g - b.g) * (a.g - b.g) + (a.b - b.b) * (a.b - b.b);
    same += 3;
  }
  return {holes / double(right.color.pixels.size()), std::sqrt(squares / same)};
}

// Two layers contain the first surface behind every edge, which is all that a hole among cards
// shows. Between trees, most of what comes into view is behind two or more surfaces of the left
// picture: the second layer fills less than half of the holes, the third as many again. Neither the
// warp nor the peeling errs: where the surface is right, so is the colour.
TEST_CASE(
    "D-11: what is wrong with a warped forest is holes, which go on behind the second layer") {
  const WarpedForest one = warped_forest(1), two = warped_forest(2), three = warped_forest(3),
                     four = warped_forest(4);
  CAPTURE(one.holes, two.holes, three.holes, four.holes);
  CHECK(two.holes > one.holes / 2);
  CHECK(three.holes < one.holes / 3);
  CHECK(four.holes < three.holes);
  // The second layer of a tree is its own back side, unless back faces are culled.
  CHECK(warped_forest(2, Cull::kBack).holes < 0.75 * two.holes);
  for (const WarpedForest& each : {one, two, three, four}) CHECK(each.rms_elsewhere < 3);
}

TEST_CASE(
    "D-12: the methods rank as in the literature, and desaturation closes the gap in proportion") {
  const auto all = check_experiment(d12_anaglyph());
  for (const char* scene : {"eight colours", "random colours", "room", "dead leaves"}) {
    double before = 1;
    for (const char* method :
         {"colour", "half-colour", "Dubois 2009", "Dubois 2001", "optimised", "grey"}) {
      const double rivalry = largest_error(all, method, scene);
      INFO(method << ", " << scene);
      CHECK(rivalry < before);
      before = rivalry;
    }
    // The colours of the eyes do not conflict if both see the same grey, or if each has its own
    // channels.
    CHECK(largest_error(all, "grey", scene) == 0);
    CHECK(largest_error(all, "true", scene) == 0);
  }
}

// Statistics that are typical of photographs: the light changes little from pixel to pixel except
// at rare edges, at every scale, and it varies more than the colour.
struct PictureStatistics {
  double deviation = 0, kurtosis = 0;  // of the difference of log(light) between neighbours
  double colour = 0;                   // deviation of log(R/G), divided by that of log(light)
};
PictureStatistics statistics_of(const Image<Linear>& picture) {
  const auto logarithm = [](float x) { return std::log(std::max(double(x), 0x1p-12)); };
  const auto light = [&](int x, int y) { return logarithm(luma(picture.at(x, y))); };
  double squares = 0, fourths = 0, count = 0, sum = 0, light2 = 0, ratio = 0, ratio2 = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Linear& c = picture.at(x, y);
      const double red_green = logarithm(c[0]) - logarithm(c[1]);
      sum += light(x, y), light2 += light(x, y) * light(x, y);
      ratio += red_green, ratio2 += red_green * red_green;
      if (x == 0) continue;
      const double d = light(x, y) - light(x - 1, y);
      squares += d * d, fourths += d * d * d * d, count += 1;
    }
  }
  const double pixels = double(picture.pixels.size());
  const auto deviation = [&](double s, double s2) {
    return std::sqrt(s2 / pixels - s / pixels * (s / pixels));
  };
  return {std::sqrt(squares / count), fourths / count / (squares / count * (squares / count)),
          deviation(ratio, ratio2) / deviation(sum, light2)};
}
Image<Linear> halved(const Image<Linear>& picture) {
  Image<Linear> half(picture.width / 2, picture.height / 2, Linear{});
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (std::size_t k = 0; k < 3; ++k) {
        half.at(x, y)[k] = (picture.at(2 * x, 2 * y)[k] + picture.at(2 * x + 1, 2 * y)[k] +
                            picture.at(2 * x, 2 * y + 1)[k] + picture.at(2 * x + 1, 2 * y + 1)[k]) /
                           4;
      }
    }
  }
  return half;
}

TEST_CASE("D-12: dead leaves have the statistics of photographs, and even noise has not") {
  const Image<Linear> leaves = d12::make_leaves(256, 192, 12);
  const PictureStatistics fine = statistics_of(leaves), coarse = statistics_of(halved(leaves));
  CAPTURE(fine.deviation, coarse.deviation, fine.kurtosis, coarse.kurtosis, fine.colour);
  CHECK(fine.kurtosis > 6);  // 3 for normally distributed differences
  CHECK(coarse.kurtosis > 6);
  // The same at half the size, apart from discs smaller than a pixel, which do not exist.
  CHECK((coarse.deviation / fine.deviation > 0.67 && coarse.deviation / fine.deviation < 1.5));
  CHECK(fine.colour < 0.5);
  Image<Linear> noise = leaves;
  Random random(1);
  for (Linear& c : noise.pixels) {
    for (float& channel : c) channel = float(std::exp(random.between(-2, 0)));
  }
  const PictureStatistics even = statistics_of(noise), even_coarse = statistics_of(halved(noise));
  CHECK(even.kurtosis < 4);
  CHECK(even_coarse.deviation / even.deviation < 0.67);
  CHECK(even.colour > 0.5);
}

TEST_CASE("D-12: photographs, where there are any, have them too") {
  const std::string path = GLASSBOX_ASSETS_DIR "/stereo/cones/im2.ppm";
  if (!std::filesystem::exists(path)) SKIP_TEST("no photograph at " << path);
  const Image<Rgba8> photograph = read_image(path).value();
  Image<Linear> light(photograph.width, photograph.height, Linear{});
  std::ranges::transform(photograph.pixels, light.pixels.begin(), linear_of);
  const PictureStatistics fine = statistics_of(light), coarse = statistics_of(halved(light));
  CAPTURE(fine.deviation, coarse.deviation, fine.kurtosis, coarse.kurtosis, fine.colour);
  CHECK(fine.kurtosis > 6);
  CHECK(coarse.kurtosis > 6);
  CHECK((coarse.deviation / fine.deviation > 0.67 && coarse.deviation / fine.deviation < 1.5));
}

TEST_CASE("D-27: every walk counts the pixels of the definition") {
  for (const Measured& m : check_experiment(d27_hierarchical_raster())) {
    INFO(describe(m));
    CHECK(m.error == 0);
  }
}

TEST_CASE("D-28: no decision of the plan changes a byte") {
  for (const Measured& m : check_experiment(d28_elision())) {
    INFO(describe(m));
    CHECK(m.error == 0);
  }
}

TEST_CASE("D-29: a run that is watched gives the bytes of one that is not") {
  for (const Measured& m : check_experiment(d29_trace())) {
    INFO(describe(m));
    CHECK(m.error == 0);
  }
}

TEST_CASE("D-31: random samples err as S^-1/2, samples in cells as S^-3/4") {
  const auto all = check_experiment(d31_supersampling());
  const auto fall = [&](const char* pattern) {
    return error_at(all, pattern, "star chart", 1) / error_at(all, pattern, "star chart", 16);
  };
  // The ratio from 1 to 16 samples is 16^(1/2) = 4 or 16^(3/4) = 8; a thousand pixels give it to a
  // few per cent.
  CHECK((fall("random") > 3.6 && fall("random") < 4.4));
  CHECK((fall("jittered") > 7.2 && fall("jittered") < 8.8));
  CHECK(largest_error(all, "D3D standard") < largest_error(all, "random"));
  // A pattern that fills the pixel improves with every doubling.
  for (const char* scene : {"star chart", "forest"}) {
    for (const double samples : {2.0, 4.0, 8.0}) {
      INFO(scene << ", " << samples);
      CHECK(error_at(all, "rotated grid", scene, 2 * samples) <
            error_at(all, "rotated grid", scene, samples));
    }
  }
  CHECK(largest_error(all, "analytic area, double") < 1e-13);
}

TEST_CASE("a law that does not hold is seen") {
  const auto planted = [](double error, double predicted,
                          const std::optional<study::Finding>& finding) {
    Measured m;
    m.error = error;
    m.configuration.predicted_error = predicted;
    m.configuration.finding = finding;
    return m;
  };
  CHECK_FALSE(obeys_theory(planted(1e-300, 0, {})));
  CHECK_FALSE(obeys_theory(planted(2.5, 1, {})));
  CHECK_FALSE(obeys_theory(planted(0.4, 1, {})));
  CHECK(obeys_theory(planted(2.5, 1, study::Finding{"a reason", 2, 3})));
  CHECK_FALSE(obeys_theory(planted(2500, 1, study::Finding{"a reason", 2, 3})));
  CHECK_FALSE(obeys_theory(
      planted(std::numeric_limits<double>::quiet_NaN(), 1, study::Finding{"a reason", 2, 3})));
}
