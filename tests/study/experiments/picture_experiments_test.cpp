// The experiments on depth, culling, the second eye, anaglyphs, walks over pixels, elision, tracing and samples (SPEC D).
#include <limits>

#include "tests/study/experiments/laws.h"

using namespace glassbox;
using namespace glassbox::study;
using namespace glassbox::test;

TEST_CASE(
    "D-6: a reversed float depth tells surfaces apart at any distance, and loses that through [-1, "
    "1]") {
  const auto all = check_experiment(d06_depth());
  for (const double z : {0.2, 1.0, 10.0, 100.0, 1000.0, 9000.0}) {
    // Two neighbouring floats of the distance are told apart: 2^-23.
    CHECK(error_at(all, "float, reversed", "ladder", z) <= 0x1p-23);
    CHECK(error_at(all, "float, reversed, infinite far", "ladder", z) <= 0x1p-23);
  }
  CHECK(error_at(all, "float, reversed through [-1, 1]", "ladder", 1000) > 1000 * 0x1p-23);
  // Reversing does nothing for fixed point (Reed 2015).
  for (const double z : {1.0, 10.0, 100.0}) {
    const double ratio =
        error_at(all, "u24, reversed", "ladder", z) / error_at(all, "u24", "ladder", z);
    CHECK((ratio > 0.5 && ratio < 2));
  }
}

TEST_CASE("D-9: only the test that knows nothing of the snap throws fronts away") {
  const auto all = check_experiment(d09_culling());
  for (const char* safe :
       {"none", "snapped area", "cluster cones", "filter, exact fallback, margin"})
    CHECK(largest_error(all, safe) == 0);
  CHECK(largest_error(all, "object-space dot product, float") > 0);
}

TEST_CASE("D-10: culling by the centre camera loses half the parallax, by the union nothing") {
  const auto all = check_experiment(d10_stereo_culling());
  CHECK(largest_error(all, "each eye by itself") == 0);
  CHECK(largest_error(all, "union, eight planes") == 0);
  CHECK(largest_error(all, "union, ball of the object") == 0);
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
  CHECK(largest_error(all, "warp of 2 layers", "forest") <
        largest_error(all, "depth-image warp", "forest"));
}

TEST_CASE(
    "D-12: the methods rank as in the literature, and desaturation closes the gap in proportion") {
  const auto all = check_experiment(d12_anaglyph());
  double before = 1;
  for (const char* method :
       {"colour", "half-colour", "Dubois 2009", "Dubois 2001", "optimised", "grey"}) {
    const double rivalry = largest_error(all, method, "eight colours");
    INFO(method);
    CHECK(rivalry < before);
    before = rivalry;
  }
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
  // 16^(1/2) = 4 and 16^(3/4) = 8 for the ratio from 1 to 16; a thousand pixels give it to a few per cent.
  CHECK((fall("random") > 3.6 && fall("random") < 4.4));
  CHECK((fall("jittered") > 7.2 && fall("jittered") < 8.8));
  CHECK(largest_error(all, "D3D standard") < largest_error(all, "random"));
  // A pattern that fills the pixel gains with every doubling.
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
