// Compares our matrices with a table of matrices that were read back from Mesa, and with their
// formulas in double.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <glassbox/base/rounding.h>
#include <glassbox/pipeline/dialects.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/projection.h>

#include "tests/support/catch.h"
#include "tests/support/skip.h"

namespace glassbox {
namespace {

std::vector<double> numbers(const std::string& text) {
  std::istringstream in(text);
  std::vector<double> list;
  for (double x; in >> x;) list.push_back(x);
  return list;
}

glm::dmat4 ours(const std::string& kind, const std::vector<double>& a) {
  if (kind == "persp")
    return (clip_gl_from_clip() * perspective_degrees(a.at(0), a.at(1), {a.at(2), a.at(3)}).value())
        .columns;
  if (kind == "frustum") {
    return (clip_gl_from_clip() *
            frustum({a.at(0), a.at(1), a.at(2), a.at(3)}, {a.at(4), a.at(5)}).value())
        .columns;
  }
  REQUIRE(kind == "lookat");
  return look_at({a.at(0), a.at(1), a.at(2)}, {a.at(3), a.at(4), a.at(5)},
                 {a.at(6), a.at(7), a.at(8)})
      .value()
      .columns;
}

TEST_CASE("the table of gluPerspective, gluLookAt and glFrustum matrices is met (S4-12)") {
  const std::string path = GLASSBOX_ASSETS_DIR "/golden/mesa-ref/share/glu_matrices.tsv";
  std::ifstream file(path);
  if (!file) SKIP_TEST("no assets at " << path);
  int rows = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.rfind("kind", 0) == 0) continue;
    std::istringstream in(line);
    std::string kind, arguments, mesa_text, formula_text;
    REQUIRE(std::getline(in, kind, '\t'));
    REQUIRE(std::getline(in, arguments, '\t'));
    REQUIRE(std::getline(in, mesa_text, '\t'));
    REQUIRE(std::getline(in, formula_text, '\t'));
    const glm::dmat4 m = ours(kind, numbers(arguments));
    const std::vector<double> mesa = numbers(mesa_text), formula = numbers(formula_text);
    REQUIRE(mesa.size() == 16);
    REQUIRE(formula.size() == 16);
    for (std::size_t i = 0; i < 16; ++i) {
      const double entry = m[int(i / 4)][int(i % 4)];
      CAPTURE(line, i, entry);
      // Errors in double: look-at entries are sums that cancel, up to 40 u of their largest term,
      // 18; the others err by 8 ulps.
      const double size = kind == "lookat" ? (i >= 12 ? 18 : 1) : std::abs(formula[i]);
      CHECK(std::abs(entry - formula[i]) <= 40 * unit_roundoff<double> * size);
      // Mesa's matrices are floats, printed with nine digits.
      CHECK(std::abs(entry - mesa[i]) <= 8 * unit_roundoff<float> * size);
    }
    ++rows;
  }
  CHECK(rows >= 5);
}

}  // namespace
}  // namespace glassbox
