// glassbox step --point: matrices in every layout that programs print, slips of convention named, correct ones let pass.
#include <cmath>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/app/run.h"
#include "tests/pipeline/textbook.h"
#include "tests/support/catch.h"

namespace glassbox::test {
namespace {

namespace book = textbook;
using book::Rows;
using Json = nlohmann::json;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Sixteen numbers in the order of rows, or of columns, each printed by `format` and followed by `after`.
std::string numbers(const Rows& m, bool columns, const char* format,
                    const std::string& after = " ") {
  std::string text;
  for (std::size_t i = 0; i < 16; ++i) {
    char number[64];
    const double entry = columns ? m[i % 4][i / 4] : m[i / 4][i % 4];
    std::snprintf(number, sizeof number, format, entry);
    text += number + (i == 15 ? std::string() : after);
    if (i % 4 == 3) text += "\n";
  }
  return text;
}

std::string paper(const Rows& m) {
  return numbers(m, false, "%12.9g");
}

// A call of the program with matrices in files.
struct Call {
  Rows model = book::identity(), view = book::identity(), projection = book::identity();
  std::string options;
};

Outcome step(const Workplace& here, const Call& call) {
  here.write("model.txt", paper(call.model));
  here.write("view.txt", paper(call.view));
  here.write("proj.txt", paper(call.projection));
  return here.run("step --model model.txt --view view.txt --proj proj.txt " + call.options);
}

Json step_json(const Workplace& here, Call call) {
  call.options += " --json -";
  const Outcome outcome = step(here, call);
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  return Json::parse(outcome.out);
}

std::vector<std::string> findings(const Json& json, const std::string& severity) {
  std::vector<std::string> ids;
  for (const Json& finding : json["findings"]) {
    if (finding["severity"] == severity) ids.push_back(finding["id"]);
  }
  return ids;
}

using Ids = std::vector<std::string>;

const Rows kView = book::look_at_right({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
const Rows kModel = book::product(book::translation(1, 0, 0.5), book::turn_y(40));
const Rows kProjection = book::perspective_gl(book::radians(60), 1.5, 0.1, 100);
const char* kPoints = "--point 0.5,0.25,-0.5 --point -1,0.5,0 --point 0.25,-0.5,1 ";

// ---- layouts ----

TEST_CASE("a matrix is read from whatever layout a program prints it in") {
  const Workplace here;
  const Rows& m = kView;
  const std::string commas = numbers(m, false, "%.6f", ", ");
  std::string eigen = numbers(m, false, "%12.6g"), nested, glm = "mat4x4(", c_assignments,
              gdb = "{value = {";
  std::string glam = "Mat4 { ", numerics = "{ ", latex;
  const char* axes = "xyzw";
  for (std::size_t i = 0; i < 4; ++i) {
    char row[200], column[200], line[800];
    std::snprintf(row, sizeof row, "[%.9g, %.9g, %.9g, %.9g]", m[i][0], m[i][1], m[i][2], m[i][3]);
    nested += (i == 0 ? "array([" : ",\n       ") + std::string(row);
    std::snprintf(column, sizeof column, "(%f, %f, %f, %f)", m[0][i], m[1][i], m[2][i], m[3][i]);
    glm += (i == 0 ? "" : ", ") + std::string(column);
    glam += std::string(1, axes[i]) + "_axis: Vec4" + column + ", ";
    gdb += i == 0 ? "{" : ", {";
    numerics += "{";
    for (std::size_t j = 0; j < 4; ++j) {
      std::snprintf(line, sizeof line, "m[%d] = %.9gf;\n", int(4 * i + j), m[j][i]);
      c_assignments += line;
      std::snprintf(line, sizeof line, "%s{%c = %.9g, %c = %.9g, %c = %.9g}", j == 0 ? "" : ", ",
                    axes[j], m[j][i], "rgba"[j], m[j][i], "stpq"[j], m[j][i]);
      gdb += line;
      std::snprintf(line, sizeof line, "M%d%d:%.9g ", int(i + 1), int(j + 1), m[j][i]);
      numerics += line;
    }
    gdb += "}";
    numerics += "} ";
  }
  nested += "], dtype=float32)";
  glm += ")";
  gdb += "}}";
  glam += "}";
  numerics += "}";
  struct Layout {
    const char* name;
    std::string text, options;
  };
  const Layout layouts[] = {
      {"paper", paper(m), ""},
      {"Eigen", eigen, ""},
      {"numpy", nested, ""},
      {"commas and semicolons", "M = [" + numbers(m, false, "%.6f", "; ") + "]", ""},
      {"JSON", "[[" + numbers(m, false, "%.9g", ", ") + "]]", ""},
      {"GLM's to_string", glm, ""},
      {"GLM in gdb", gdb, ""},
      {"glam", glam, ""},
      {"System.Numerics", numerics, ""},
      {"OpenGL's memory", "GLfloat view[16] = {" + numbers(m, true, "%.9gf", ", ") + "};",
       "--order columns"},
      {"C, element by element", "float m[16]; // the view\n" + c_assignments, "--order columns"},
      {"row vectors", numbers(book::transposed(m), false, "%.9g"), "--order columns"},
      {"Fortran and MATLAB", numbers(m, false, "%.6e"), ""},
      {"tall brackets, a typeset minus", "⎡" + numbers(m, false, "%.9g") + "⎦", ""},
      {"a comment above", "# view matrix of camera 3\n" + paper(m), ""},
      {"labelled rows", "row 0: 1 0 0 0\nrow 1: 0 1 0 0\nrow 2: 0 0 1 −5\nrow 3: 0 0 0 1\n", ""},
  };
  for (const Layout& layout : layouts) {
    CAPTURE(layout.name);
    here.write("view.txt", layout.text);
    const Outcome outcome =
        here.run("step --point 1,2,3 --view view.txt --json - " + layout.options);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const Json json = Json::parse(outcome.out);
    const Json& rows = json["matrices"]["view"]["rows"];
    const bool labelled = contains(layout.name, "labelled");
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) {
        const double meant = labelled ? book::translation(0, 0, -5)[i][j] : m[i][j];
        // Six decimals, or six digits of numbers below 10.
        CHECK(std::abs(double(rows[i][j]) - meant) <= 5.1e-6);
      }
    }
    if (!labelled) CHECK(json["matrices"]["view"]["shape"] == "rigid");
  }
}

TEST_CASE("an order that the layout knows is taken from it, and the user's word is above it") {
  const Workplace here;
  here.write("view.txt", "mat4x4((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), (7, 8, 9, 1))");
  const auto translation = [&](const std::string& options) {
    const Json json =
        Json::parse(here.run("step --point 0,0,0 --view view.txt --json - " + options).out);
    return json["matrices"]["view"]["rows"][0][3];
  };
  CHECK(translation("") == 7);
  CHECK(translation("--order columns") == 7);
  CHECK(translation("--order rows") == 0);
}

TEST_CASE("the numbers themselves will do, and gdb's repeats") {
  const Workplace here;
  const auto run = [&](const std::vector<std::string>& words) {
    return run_program(GLASSBOX_PROGRAM, words, here.path());
  };
  const Outcome text = run({"step", "--point", "1,2,3", "--view",
                            "1 0 0 -1  0 1 0 -2  0 0 1 -8  0 0 0 1", "--json", "-"});
  REQUIRE(text.exit_code == 0);
  CHECK(Json::parse(text.out)["points"][0]["steps"][1]["position"] == Json({0.0, 0.0, -5.0, 1.0}));
  const Outcome negative = run({"step", "--point", "-1,-2,-3", "--view",
                                "-1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1", "--json", "-"});
  REQUIRE(negative.exit_code == 0);
  CHECK(Json::parse(negative.out)["points"][0]["steps"][1]["position"] ==
        Json({1.0, -2.0, 3.0, 1.0}));
  const Outcome repeats =
      run({"step", "--point", "1,2,3", "--view", "{1, 0 <repeats 14 times>, 1}", "--json", "-"});
  REQUIRE(repeats.exit_code == 0);
  CHECK(Json::parse(repeats.out)["matrices"]["view"]["rows"][3][3] == 1);
}

TEST_CASE(
    "what is no matrix is refused in one line: the option, the file, line, column and token") {
  const Workplace here;
  const std::string fifteen = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0\n";
  struct Case {
    std::string text;
    std::vector<std::string> parts;
  };
  const Case cases[] = {
      {fifteen, {"bad.txt", "--view", "15 numbers"}},
      {"", {"bad.txt", "0 numbers"}},
      {fifteen + "1 2", {"17 numbers"}},
      {"1 0 0\n0 1 0\n0 0 1\n", {"9 numbers", "3x3"}},
      {"1 0 0 0\n0 1 0 0\n0 0 1 0\n", {"12 numbers", "0 0 0 1"}},
      {paper(kView) + paper(kView) + paper(kView), {"48 numbers", "three matrices"}},
      {"1 0 0 0\n0 1 0 0\n0 0 1x 0\n0 0 0 1", {"line 3, column 5", "'1x'"}},
      {"1 0 0 0\n0 1.2.3 0 0\n", {"line 2, column 3", "'1.2.3'"}},
      {"1.0e+03 *\n1 0 0 0", {"line 1, column 9", "'*'", "factor"}},
      {"1 0 0 0 0 cos(a) -sin(a) 0", {"'-sin'", "expression"}},
      {"1 0 0 $ 0", {"line 1, column 7", "'$'"}},
      {"1e40 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", {"'1e40'", "too large"}},
      {"1+2j 0 0 0", {"'1+2j'"}},
      {"{0, 0} <repeats 8 times>", {"repeat"}},
      {"0 <repeats 4000000000 times>", {"more than 64 numbers"}},
      {std::string(70000, ' '), {"longer than"}},
      {std::string("1 0 \0 0", 7), {"bad.txt"}},
      {"\xff\xfe\x01", {"bad.txt", "line 1"}},
  };
  for (const Case& one : cases) {
    here.write("bad.txt", one.text);
    const Outcome outcome = here.run("step --point 1,2,3 --view bad.txt");
    CAPTURE(one.text.substr(0, 60), outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out.empty());
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    for (const std::string& part : one.parts) CHECK(contains(outcome.err, part));
  }
  here.write("good.txt", paper(kView));
  const std::pair<const char*, const char*> usages[] = {
      {"step --point 1,2,3", "no matrix"},
      {"step --view good.txt", "--point"},
      {"step --point 1,2 --view good.txt", "X,Y,Z"},
      {"step --point 1,2,nan --view good.txt", "finite"},
      {"step --point 1,2,1e39 --view good.txt", "float"},
      {"step --point 1,2,3 --view none.txt", "no such file"},
      {"step --point 1,2,3 --view .", "directory"},
      {"step --point 1,2,3 --view - --proj -", "standard input"},
      {"step --point 1,2,3 --view good.txt --dialect opengles", "opengl|d3d"},
      {"step --point 1,2,3 --view good.txt --order row", "rows or columns"},
      {"step --point 1,2,3 --view good.txt --world up", "right or left"},
      {"step --point 1,2,3 --view good.txt --viewport 0,0,0,5", "positive width"},
      {"step --point 1,2,3 --view good.txt --size 0x5", "--size"},
      {"step --point 1,2,3 --view good.txt --size 4x5 --viewport 0,0,4,5", "xclu"},
      {"step --point 1,2,3 --view good.txt --expect 1,2 --expect 3,4", "more expected"},
  };
  for (const auto& [words, part] : usages) {
    const Outcome outcome = here.run(words);
    CAPTURE(words, outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, part));
  }
}

// ---- the chain ----

TEST_CASE("the chain is that of a second computation, within its bounds, in every window") {
  const Workplace here;
  struct Api {
    const char* name;
    Rows view, projection;
    bool y_up_in_window_and_ndc_agree;
  };
  const double fovy = book::radians(60);
  const Api apis[] = {
      {"opengl", kView, kProjection, true},
      {"d3d", book::look_at_left({3, 2, 5}, {0, 0, 0}, {0, 1, 0}),
       book::perspective_d3d_left(fovy, 1.5, 0.1, 100), false},
      {"vulkan", kView, book::perspective_vulkan(fovy, 1.5, 0.1, 100), true},
      {"reversed", kView, book::perspective_reversed_infinite(fovy, 1.5, 0.1), false},
      {"glassbox", kView, book::perspective_d3d_right(fovy, 1.5, 0.1, 100), false},
      {"opengl", kView, book::ortho_gl(-9, 9, -6, 6, 0.1, 100), true},
  };
  for (const Api& api : apis) {
    const Json json = step_json(here, {kModel, api.view, api.projection,
                                       std::string("--dialect ") + api.name +
                                           " --viewport 10,20,600,400 --point 0.5,0.25,-0.5"});
    const Rows all = book::product(api.projection, book::product(api.view, kModel));
    std::array<double, 4> clip{};
    for (std::size_t i = 0; i < 4; ++i) {
      clip[i] = all[i][0] * 0.5 + all[i][1] * 0.25 - all[i][2] * 0.5 + all[i][3];
    }
    const Json& point = json["points"][0];
    CAPTURE(api.name, point.dump());
    CHECK(point["fate"] == "visible");
    // The matrices are rounded to float on their way in, by u for each entry; sizes here are below 10.
    constexpr double kRead = 64 * 0x1p-24;
    for (std::size_t i = 0; i < 4; ++i) {
      const double bound = double(point["steps"][2]["bound"][i]) + kRead;
      CHECK(std::abs(double(point["steps"][2]["position"][i]) - clip[i]) <= bound);
    }
    const double x = 10 + (clip[0] / clip[3] + 1) * 300;
    const double up = clip[1] / clip[3];
    const double y = 20 + (api.y_up_in_window_and_ndc_agree ? 1 + up : 1 - up) * 200;
    CHECK(std::abs(double(point["window"]["position"][0]) - x) <= 300 * kRead);
    CHECK(std::abs(double(point["window"]["position"][1]) - y) <= 300 * kRead);
    const double z = clip[2] / clip[3];
    CHECK(std::abs(double(point["window"]["depth"]) -
                   (std::string(api.name) == "opengl" ? (z + 1) / 2 : z)) <= kRead);
    CHECK(point["window"]["y_up"] == (std::string(api.name) == "opengl"));
  }
}

TEST_CASE("a viewport of negative height turns y over, and is no picture upside down") {
  const Workplace here;
  const Rows d3d = book::perspective_d3d_right(book::radians(60), 1.5, 0.1, 100);
  const Rows vulkan = book::perspective_vulkan(book::radians(60), 1.5, 0.1, 100);
  const Json negated = step_json(
      here, {kModel, kView, vulkan, "--dialect vulkan --point 0.5,1,0 --viewport 0,0,600,400"});
  const Json turned = step_json(
      here, {kModel, kView, d3d, "--dialect vulkan --point 0.5,1,0 --viewport 0,400,600,-400"});
  CHECK(findings(turned, "hint") == Ids());
  CHECK(negated["points"][0]["window"]["position"] == turned["points"][0]["window"]["position"]);
  // Less than a pixel is no picture whose aspect ratio could be compared.
  const Outcome thin = step(here, {kModel, kView, d3d, "--point 0.5,1,0 --viewport 0,0,600,0.5"});
  CHECK(thin.exit_code == 0);
}

TEST_CASE("bits, bounds, conditions and the deciding plane are printed, within 100 columns") {
  const Workplace here;
  const Outcome outcome =
      step(here, {kModel, kView, kProjection, "--point 0.5,0.25,-0.5 --point 90,1,2 --bits"});
  REQUIRE(outcome.exit_code == 0);
  for (const char* part :
       {"MODEL", "VIEW", "PROJECTION", "POINT (0.5, 0.25, -0.5)", "object -> world", "world -> eye",
        "eye -> clip", "clip -> NDC", "NDC -> window", "3f800000", "+- ", "exact", "condition",
        "snapped to", "stable", "decided: inside all six planes",
        "decided: outside the right plane by", "the picture spans x from", "VERDICT"}) {
    CAPTURE(part, outcome.out);
    CHECK(contains(outcome.out, part));
  }
  // Numbers of the longest kind, too.
  Rows long_numbers = kProjection;
  for (auto& row : long_numbers) {
    for (double& entry : row) entry = -1.2345678e-5 * (entry + 0.12345678);
  }
  const Outcome wide = step(here, {long_numbers, long_numbers, long_numbers,
                                   "--point -0.123456789,-1.2345678e-10,-1.2345678e10 --bits"});
  REQUIRE(wide.exit_code == 0);
  for (const std::string& text : {outcome.out, wide.out, here.run("step --help").out}) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      if (contains(line, "--")) continue;  // CLI11 lays the options out
      CAPTURE(line);
      CHECK(line.size() <= 100);
    }
  }
}

TEST_CASE("the same words give the same bytes, to a file and to standard output") {
  const Workplace here;
  const Call call{kModel, kView, kProjection, std::string(kPoints) + "--json -"};
  const Outcome first = step(here, call), second = step(here, call);
  CHECK(first.out == second.out);
  const Outcome file =
      step(here, {kModel, kView, kProjection, std::string(kPoints) + "--json out.json"});
  CHECK(here.read("out.json") == first.out);
  CHECK(contains(file.out, "VERDICT"));
}

TEST_CASE("digits that the text lacks are told in pixels") {
  const Workplace here;
  here.write("few.txt", numbers(kView, false, "%.5f"));
  here.write("many.txt", numbers(kView, false, "%.9g"));
  here.write("proj.txt", paper(kProjection));
  const auto open = [&](const char* file) {
    const Outcome outcome =
        here.run(std::string("step --point 0.5,0.25,-0.5 --proj proj.txt --json - --view ") + file);
    return double(Json::parse(outcome.out)["points"][0]["window"]["open_by_digits"]);
  };
  // Entries open by 5e-6, a point at distance 6 that spans 6.2/1.73 units in 720 pixels: some hundred 5e-6.
  CHECK(open("few.txt") > 1e-4);
  CHECK(open("few.txt") < 1e-2);
  CHECK(open("many.txt") < open("few.txt") / 5);
}

// ---- conventions ----

TEST_CASE("correct chains raise no alarm and no hint") {
  const Workplace here;
  const double fovy = book::radians(60);
  const Rows left = book::look_at_left({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const struct {
    const char* options;
    Rows view, projection;
  } chains[] = {
      {"--dialect opengl", kView, kProjection},
      {"--dialect opengl --world right", kView, book::ortho_gl(-9, 9, -6, 6, 0.1, 100)},
      {"--dialect opengl", kView, book::frustum_gl(-0.1, 0.2, -0.1, 0.1, 0.1, 50)},
      {"--dialect d3d", left, book::perspective_d3d_left(fovy, 1.5, 0.1, 100)},
      {"--dialect d3d --world left", left, book::ortho_d3d(-9, 9, -6, 6, 0.1, 100, true)},
      {"--dialect d3d", kView, book::perspective_d3d_right(fovy, 1.5, 0.1, 100)},
      {"--dialect vulkan --world right", kView, book::perspective_vulkan(fovy, 1.5, 0.1, 100)},
      {"--dialect vulkan", kView, book::ortho_vulkan(-9, 9, -6, 6, 0.1, 100)},
      {"--dialect reversed", kView, book::perspective_reversed_infinite(fovy, 1.5, 0.1)},
      {"", kView, kProjection},
      {"", left, book::perspective_d3d_left(fovy, 1.5, 0.1, 100)},
      {"", kView, book::perspective_vulkan(fovy, 1.5, 0.1, 100)},
      {"", kView, book::perspective_reversed_infinite(fovy, 1.5, 0.1)},
  };
  for (const auto& chain : chains) {
    const Json json = step_json(here, {kModel, chain.view, chain.projection,
                                       std::string(kPoints) + "--size 600x400 " + chain.options});
    CAPTURE(chain.options, json["dialect"], json["findings"].dump());
    CHECK(findings(json, "alarm") == Ids());
    CHECK(findings(json, "hint") == Ids());
    CHECK(json["visible"] == 3);
    CHECK(json["alternatives"].empty());
  }
}

TEST_CASE("each planted slip is named: by a finding, or by the first change that would mend it") {
  const Workplace here;
  const double fovy = book::radians(60);
  Rows turned = kView;
  turned[0][3] = turned[1][3] = turned[2][3] = 0;
  const Rows rank3{{{2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 2, 0}, {0, 0, 1, 0}}};
  const Rows d3d_left = book::perspective_d3d_left(fovy, 1.5, 0.1, 100);
  // S3.37 literally: the gaze turned to +z by a proper rotation.
  const book::Vector3 gaze = book::unit({-3, -2, -5});
  const book::Vector3 up = book::unit(book::cross(book::cross(gaze, {0, 1, 0}), gaze));
  const Rows mirror_trap = book::from_axes(book::cross(up, gaze), up, gaze, {3, 2, 5});
  // Where (0, 1, 0) would be in a window that counts y from the other edge.
  const Rows both = book::product(kProjection, kView);
  const double w = both[3][1] + both[3][3];
  const std::string flipped = std::to_string(300 + 300 * (both[0][1] + both[0][3]) / w) + "," +
                              std::to_string(200 - 200 * (both[1][1] + both[1][3]) / w);
  struct Slip {
    const char* name;
    Call call;
    const char* finding;  // an alarm, or nullptr
    const char* change;   // the first alternative, or nullptr
    const char* words;    // in the text
  };
  const Slip slips[] = {
      {"all transposed",
       {book::transposed(kModel), book::transposed(kView), book::transposed(kProjection), kPoints},
       "transposed",
       "transpose-all",
       "for row vectors, p M"},
      {"read in the wrong order",
       {kModel, kView, kProjection, std::string(kPoints) + "--order columns"},
       "transposed",
       "transpose-all",
       "read them in the other --order"},
      {"view transposed",
       {kModel, book::transposed(kView), kProjection, kPoints},
       "transposed",
       "transpose-view",
       "then the view is rigid, as given it is not"},
      {"projection transposed",
       {kModel, kView, book::transposed(kProjection), kPoints},
       "transposed",
       "transpose-projection",
       "stands in the last column"},
      {"E12: S4.5 times S4.18",
       {kModel, kView, d3d_left, kPoints},
       nullptr,
       "eye-hand",
       "handedness is mixed (E12)"},
      {"E12, the other way round",
       {kModel, book::look_at_left({3, 2, 5}, {0, 0, 0}, {0, 1, 0}), kProjection, kPoints},
       nullptr,
       "eye-hand",
       "every w is negative (3 of 3)"},
      {"view not inverted",
       {kModel, book::rigid_inverse(kView), kProjection, kPoints},
       nullptr,
       "invert-view",
       "then the eye stands at (3, 2, 5)"},
      {"factors of the view exchanged",
       {kModel, book::product(book::translation(-3, -2, -5), turned), kProjection, kPoints},
       nullptr,
       "view-factors",
       "R * T(-eye)"},
      {"view times projection",
       {kModel, book::identity(), book::product(kView, kProjection), kPoints},
       "factors-exchanged",
       nullptr,
       "view * projection"},
      {"view and projection exchanged",
       {kModel, kProjection, kView, kPoints},
       "exchanged",
       "exchange-view-projection",
       "exchange --view and --proj"},
      {"degrees for radians",
       {kModel, kView, book::perspective_gl(60, 1.5, 0.1, 100), kPoints},
       "degrees-as-radians",
       nullptr,
       "60 degrees were taken for radians"},
      {"radians for degrees",
       {kModel, kView, book::perspective_gl(book::radians(book::radians(60)), 1.5, 0.1, 100),
        kPoints},
       "radians-as-degrees",
       "radians",
       "radians were taken for degrees"},
      {"E15: rank 3", {kModel, kView, rank3, kPoints}, "depth-lost", nullptr, "(E15)"},
      {"E16: OpenGL's z in Direct3D",
       {book::identity(), kView, kProjection, "--point 2.92698,1.95132,4.8783 --dialect d3d"},
       "z-range",
       "depth-range",
       "everything nearer than 0.1998 is clipped (E16)"},
      {"E16: Direct3D's z in OpenGL",
       {kModel, kView, book::perspective_d3d_right(fovy, 1.5, 0.1, 100),
        std::string(kPoints) + "--dialect opengl"},
       "z-range",
       nullptr,
       "half of the depth buffer"},
      {"reversed depth",
       {kModel, kView, book::perspective_reversed_infinite(fovy, 1.5, 0.1),
        std::string(kPoints) + "--dialect d3d"},
       "depth-direction",
       nullptr,
       "--dialect reversed"},
      {"near and far exchanged",
       {kModel, kView, book::perspective_gl(fovy, 1.5, 100, 0.1),
        std::string(kPoints) + "--dialect opengl"},
       "depth-direction",
       nullptr,
       "near and far are exchanged"},
      {"E7: the mirror trap",
       {kModel, mirror_trap, d3d_left, std::string(kPoints) + "--world right"},
       "world-mirrored",
       nullptr,
       "(E7)"},
      {"y of the window",
       {book::identity(), kView, book::perspective_gl(fovy, 1.5, 0.1, 100),
        "--size 600x400 --point 0,1,0 --expect " + flipped},
       nullptr,
       "flip-y",
       "counted from the other edge"},
  };
  for (const Slip& slip : slips) {
    CAPTURE(slip.name);
    const Outcome text = step(here, slip.call);
    REQUIRE(text.exit_code == 0);
    const Json json = step_json(here, slip.call);
    CAPTURE(json["findings"].dump(), json["alternatives"].dump(), json["visible"]);
    if (slip.finding != nullptr) {
      const Ids alarms = findings(json, "alarm");
      CHECK(std::find(alarms.begin(), alarms.end(), slip.finding) != alarms.end());
      CHECK(contains(text.out, "WRONG"));
    } else {
      CHECK(findings(json, "alarm") == Ids());
    }
    if (slip.change != nullptr) {
      REQUIRE_FALSE(json["alternatives"].empty());
      CHECK(json["alternatives"][0]["ids"] == Json::array({slip.change}));
      CHECK(contains(text.out, "ought to be"));
    }
    // Line breaks may stand between the words.
    std::string flat;
    for (const char c : text.out) {
      if (c == '\n')
        flat += ' ';
      else if (c != ' ' || flat.empty() || flat.back() != ' ')
        flat += c;
    }
    std::string once;
    for (const char c : flat) {
      if (c != ' ' || once.empty() || once.back() != ' ') once += c;
    }
    CAPTURE(text.out);
    CHECK(contains(once, slip.words));
  }
}

TEST_CASE("E7 is told even where the world's hand is not given, as what would follow") {
  const Workplace here;
  const Rows left = book::look_at_left({3, 2, 5}, {0, 0, 0}, {0, 1, 0});
  const Outcome outcome =
      step(here, {kModel, left, book::perspective_d3d_left(1, 1.5, 0.1, 100), "--point 0,0,0"});
  CHECK(contains(outcome.out, "draw a left-handed world as it is"));
  CHECK(contains(outcome.out, "(E7)"));
  CHECK_FALSE(contains(outcome.out, "WRONG"));
}

TEST_CASE("where no convention helps, it says what the camera sees instead") {
  const Workplace here;
  const Outcome outcome = step(here, {book::identity(), kView, kProjection, "--point 0,9,0"});
  CHECK(contains(outcome.out, "No change of convention"));
  CHECK(contains(outcome.out, "the picture spans y from"));
  CHECK_FALSE(contains(outcome.out, "WRONG"));
}

TEST_CASE("NaN, infinity, w = 0 and directions are told, and nothing is computed from them") {
  const Workplace here;
  Rows broken = kView;
  broken[0][1] = std::nan("");
  Json json = step_json(here, {kModel, broken, kProjection, "--point 0,0,0"});
  CHECK(findings(json, "alarm") == Ids{"not-finite"});
  CHECK(json["points"][0]["fate"] == "not-finite");
  CHECK_FALSE(json["points"][0].contains("ndc"));
  const Outcome direction = step(here, {kModel, kView, kProjection, "--point 0,0,1,0"});
  CHECK(contains(direction.out, "it a direction"));
  // In the plane of the eye.
  json = step_json(here, {book::identity(), book::identity(), kProjection, "--point 1,1,0"});
  CHECK(json["points"][0]["fate"] == "in-eye-plane");
  // Overflow on the way.
  json = step_json(here, {book::scaling(1e30, 1e30, 1e30), book::scaling(1e30, 1e30, 1e30),
                          kProjection, "--point 1,1,1"});
  CHECK(json["points"][0]["fate"] == "not-finite");
}

}  // namespace
}  // namespace glassbox::test
