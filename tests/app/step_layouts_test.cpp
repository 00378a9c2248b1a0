// Tests glassbox step --point: matrices in every layout that programs print, and what is refused.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "tests/app/step_run.h"

namespace glassbox::test {
namespace {

TEST_CASE("a matrix is read from whatever layout a program prints it in") {
  const WorkingDirectory here;
  const Rows& m = kView;
  const std::string commas = numbers(m, false, "%.6f", ", ");
  std::string eigen = numbers(m, false, "%12.6g"), nested, glm = "mat4x4(", c_assignments,
              gdb = "{value = {";
  std::string glam = "Mat4 { ", numerics = "{ ", keyed, directx = "{", unreal, godot = "[";
  std::string utf16;
  for (const char c : plain_rows(m)) utf16 += {c, '\0'};
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
      std::snprintf(line, sizeof line, "%s\"%d\":%.17g", keyed.empty() ? "{" : ",", int(4 * i + j),
                    m[j][i]);
      keyed += line;
      std::snprintf(line, sizeof line, "%s{%c = %.9g, %c = %.9g, %c = %.9g}", j == 0 ? "" : ", ",
                    axes[j], m[j][i], "rgba"[j], m[j][i], "stpq"[j], m[j][i]);
      gdb += line;
      std::snprintf(line, sizeof line, "M%d%d:%.9g ", int(i + 1), int(j + 1), m[j][i]);
      numerics += line;
      std::snprintf(line, sizeof line, "_%d%d=%.9g ", int(i + 1), int(j + 1), m[j][i]);
      directx += line;
      std::snprintf(line, sizeof line, "%s%.9g", j == 0 ? "[" : " ", m[j][i]);
      unreal += line;
    }
    gdb += "}";
    numerics += "} ";
    unreal += "] ";
    std::snprintf(line, sizeof line, "%s%c: (%.9g, %.9g, %.9g)", i == 0 ? "" : ", ", "XYZO"[i],
                  m[0][i], m[1][i], m[2][i]);
    godot += line;
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
      {"paper", plain_rows(m), ""},
      {"Eigen", eigen, ""},
      {"numpy", nested, ""},
      {"commas and semicolons", "M = [" + numbers(m, false, "%.6f", "; ") + "]", ""},
      {"JSON", "[[" + numbers(m, false, "%.9g", ", ") + "]]", ""},
      {"GLM's to_string", glm, ""},
      {"GLM in gdb", gdb, ""},
      {"glam", glam, ""},
      {"System.Numerics", numerics, ""},
      {"DirectXMath", directx + "}", ""},
      {"Unreal", unreal, ""},
      {"Godot", godot + "]", ""},
      {"OpenGL's memory", "GLfloat view[16] = {" + numbers(m, true, "%.9gf", ", ") + "};",
       "--order columns"},
      {"C, element by element", "float m[16]; // the view\n" + c_assignments, "--order columns"},
      {"row vectors", numbers(book::transposed(m), false, "%.9g"), "--order columns"},
      {"Fortran and MATLAB", numbers(m, false, "%.6e"), ""},
      {"tall brackets, a typeset minus", "⎡" + numbers(m, false, "%.9g") + "⎦", ""},
      {"numpy 2, a list of its numbers",
       "[np.float32(" + numbers(m, false, "%.9g", "), np.float32(") + ")]", ""},
      {"PyTorch", "tensor([" + numbers(m, false, "%.6f", ", ") + "], device='cuda:0')", ""},
      {"Unity", numbers(m, false, "%.6f", "\t"), ""},
      {"Blender", "<Matrix 4x4 (" + numbers(m, false, "%.6f", ", ") + ")>", ""},
      {"a Float32Array", "Float32Array(16) [ " + numbers(m, true, "%.17g", ", ") + " ]", ""},
      {"a Float32Array as JSON", keyed + "}", ""},
      {"three.js", "Matrix4 { elements: [" + numbers(m, true, "%.17g", ", ") + "] }", ""},
      {"three.js as JSON", "{\"elements\":[" + numbers(m, true, "%.17g", ",") + "]}", ""},
      {"gl-matrix", "mat4(" + numbers(m, true, "%.17g", ", ") + ")", ""},
      {"CSS", "matrix3d(" + numbers(m, true, "%.6f", ", ") + ")", ""},
      {"a title in quotes",
       "{\"name\": \"view matrix 3\", \"rows\": [" + numbers(m, false, "%.9g", ", ") + "]}", ""},
      {"a comment above", "# view matrix of camera 3\n" + plain_rows(m), ""},
      {"labelled rows", "row 0: 1 0 0 0\nrow 1: 0 1 0 0\nrow 2: 0 0 1 −5\nrow 3: 0 0 0 1\n", ""},
      {"PowerShell in UTF-16", "\xff\xfe" + utf16, ""},
      {"UTF-16 without a mark", utf16, ""},
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
        // Layouts have six decimals, or six significant digits of numbers below 10.
        CHECK(std::abs(double(rows[i][j]) - meant) <= 5.1e-6);
      }
    }
    if (!labelled) CHECK(json["matrices"]["view"]["shape"] == "rigid");
  }
}

TEST_CASE("an order that the layout knows is taken from it, and the user's word is above it") {
  const WorkingDirectory here;
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
  const WorkingDirectory here;
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
  const WorkingDirectory here;
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
      {plain_rows(kView) + plain_rows(kView) + plain_rows(kView), {"48 numbers", "three matrices"}},
      {"1 0 0 0\n0 1 0 0\n0 0 1x 0\n0 0 0 1", {"line 3, column 5", "'1x'"}},
      {"1 0 0 0\n0 1.2.3 0 0\n", {"line 2, column 3", "'1.2.3'"}},
      {"1.0e+03 *\n1 0 0 0", {"line 1, column 9", "'*'", "factor"}},
      {"1 0 0 0 0 cos(a) -sin(a) 0", {"'-sin'", "expression"}},
      {"1 0 0 $ 0", {"line 1, column 7", "'$'"}},
      {"1e40 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1", {"'1e40'", "too large"}},
      {"1+2j 0 0 0", {"'1+2j'"}},
      {"0x3f800000 0 0 0", {"'0x3f800000'", "is not a number"}},
      {"Float32Array(16)", {"1 number"}},
      {"'1 0 0 0", {"4 numbers"}},
      {"{0, 0} <repeats 8 times>", {"repeat"}},
      {"0 <repeats 4000000000 times>", {"more than 64 numbers"}},
      {std::string(70000, ' '), {"longer than"}},
      {std::string("1 0 \0 0", 7), {"bad.txt"}},
      {"\xff\xfe\x01", {"bad.txt", "has 0 numbers"}},
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
  here.write("good.txt", plain_rows(kView));
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
      {"step --point 1,2,3 --view good.txt --order row", "rows|columns"},
      {"step --point 1,2,3 --view good.txt --world up", "right|left"},
      {"step --point 1,2,3 --view good.txt --viewport 0,0,0,5", "width above 0"},
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

}  // namespace
}  // namespace glassbox::test
