// Tests glassbox trace: a whole run as JSON and as NumPy arrays. The arrays are read by libzip and
// by the test's own code, and by NumPy itself where it is installed.
#include <zip.h>

#include <cstring>
#include <iostream>
#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "tests/app/sessions.h"
#include "tests/app/text.h"
#include "tests/support/catch.h"
#include "tests/support/skip.h"

namespace glassbox::test {
namespace {

using Json = nlohmann::json;

// ---- .npz ----

struct NpyArray {
  std::string type;                // such as "<f4"
  std::vector<std::size_t> shape;  // all dimensions
  std::string bytes;

  std::size_t count() const {
    std::size_t count = 1;
    for (const std::size_t n : shape) count *= n;
    return count;
  }
  template <class T>
  T at(std::size_t index) const {
    T value;
    REQUIRE((index + 1) * sizeof value <= bytes.size());
    std::memcpy(&value, bytes.data() + index * sizeof value, sizeof value);
    return value;
  }
};

std::string between(const std::string& text, const std::string& from, const std::string& to) {
  const std::size_t start = text.find(from);
  REQUIRE(start != std::string::npos);
  const std::size_t end = text.find(to, start + from.size());
  REQUIRE(end != std::string::npos);
  return text.substr(start + from.size(), end - start - from.size());
}

// The format of numpy.lib.format: "\x93NUMPY", version 1.0, the length of a Python dict in ASCII,
// the dict, the numbers.
NpyArray parse_npy(const std::string& file) {
  REQUIRE(file.size() >= 64);
  REQUIRE(file.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
  const std::size_t length =
      static_cast<unsigned char>(file[8]) + std::size_t(256) * static_cast<unsigned char>(file[9]);
  REQUIRE((10 + length) % 64 == 0);
  const std::string header = file.substr(10, length);
  REQUIRE(header.ends_with('\n'));
  REQUIRE(between(header, "'fortran_order': ", ",") == "False");
  NpyArray array{between(header, "'descr': '", "'"), {}, file.substr(10 + length)};
  std::istringstream shape(between(header, "'shape': (", ")"));
  for (std::string n; std::getline(shape, n, ',');) {
    if (n.find_first_of("0123456789") != std::string::npos) array.shape.push_back(std::stoul(n));
  }
  REQUIRE(array.bytes.size() == array.count() * std::stoul(array.type.substr(2)));
  return array;
}

std::map<std::string, NpyArray> parse_npz(const std::string& path) {
  struct Close {
    void operator()(zip_t* archive) const { zip_discard(archive); }
  };
  int error = 0;
  const std::unique_ptr<zip_t, Close> archive(
      zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &error));
  REQUIRE(archive);
  std::map<std::string, NpyArray> arrays;
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive.get(), 0); ++i) {
    zip_stat_t stat;
    REQUIRE(zip_stat_index(archive.get(), zip_uint64_t(i), 0, &stat) == 0);
    std::string name = stat.name, file(stat.size, '\0');
    zip_file_t* in = zip_fopen_index(archive.get(), zip_uint64_t(i), 0);
    REQUIRE(in != nullptr);
    REQUIRE(zip_fread(in, file.data(), file.size()) == zip_int64_t(file.size()));
    zip_fclose(in);
    CAPTURE(name);
    REQUIRE(name.ends_with(".npy"));
    name.resize(name.size() - 4);
    arrays[name] = parse_npy(file);
  }
  return arrays;
}

// ---- both forms ----

TEST_CASE("the arrays and the JSON of a run have the same numbers") {
  const WorkingDirectory here;
  const std::string run = "trace room --size 48x32 ";
  REQUIRE(here.run(run + "-o run.json").exit_code == 0);
  const Outcome outcome = here.run(run + "-o run.npz");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK(here.names() == std::vector<std::string>{"run.json", "run.npz"});
  const Json json = Json::parse(here.read("run.json"));
  auto arrays = parse_npz(here.file("run.npz"));

  const Json &triangles = json.at("triangles"), &fragments = json.at("fragments");
  REQUIRE(!fragments.empty());
  REQUIRE(arrays["triangle.number"].shape == std::vector<std::size_t>{triangles.size()});
  REQUIRE(arrays["corner.clip"].shape == std::vector<std::size_t>{triangles.size(), 3, 4});
  REQUIRE(arrays["fragment.after"].shape == std::vector<std::size_t>{fragments.size(), 4});
  CHECK(arrays["corner.clip"].type == "<f4");
  CHECK(arrays["corner.eye"].type == "<f8");
  CHECK(arrays["fragment.after"].type == "|u1");
  CHECK(arrays["run.clip_from_eye"].shape == std::vector<std::size_t>{4, 4});
  CHECK(arrays["round_trip.largest_ratio"].shape.empty());
  for (std::size_t row = 0; row < 4; ++row) {
    CHECK(arrays["run.clip_from_eye"].at<double>(4 * row + 2) ==
          json["view"]["clip_from_eye"][row][2]);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Json& corner = triangles[t]["corners"][2];
    REQUIRE(arrays["corner.clip"].at<float>(4 * (3 * t + 2)) == corner["clip"][0].get<float>());
    REQUIRE(arrays["corner.world_bound"].at<double>(3 * (3 * t + 2) + 1) ==
            corner["world_bound"][1].get<double>());
    const std::size_t first = arrays["triangle.first_vertex"].at<std::uint64_t>(t);
    const Json& polygon = triangles[t]["polygon"];
    REQUIRE(arrays["triangle.vertex_count"].at<std::uint8_t>(t) == polygon.size());
    for (std::size_t v = 0; v < polygon.size(); ++v) {
      REQUIRE(arrays["vertex.ndc"].at<float>(3 * (first + v) + 1) ==
              polygon[v]["ndc"][1].get<float>());
    }
  }
  for (std::size_t f = 0; f < fragments.size(); ++f) {
    REQUIRE(arrays["fragment.triangle"].at<std::int64_t>(f) == fragments[f]["triangle"]);
    REQUIRE(arrays["fragment.lambda"].at<float>(3 * f + 2) ==
            fragments[f]["lambda"][2].get<float>());
    REQUIRE(arrays["fragment.depth_bound"].at<double>(f) ==
            fragments[f]["bounds"]["depth"].get<double>());
  }
  const Json about = Json::parse(arrays["about"].bytes);
  CHECK(about.at("scene") == "room");
  CHECK(about.at("draws") == json.at("draws"));
  CHECK(arrays["round_trip.largest_error"].at<double>(0) ==
        json["round_trip"]["largest_error"].get<double>());
  CHECK(json["round_trip"]["largest_ratio"] <= 1);
}

TEST_CASE("the JSON of one triangle is that of glassbox step") {
  const WorkingDirectory here;
  const Json trace = Json::parse(here.run("trace cube --size 64x48 --triangle 10 -o -").out);
  const Json step = Json::parse(here.run("step cube --size 64x48 --triangle 10 --json -").out);
  CHECK(trace == step);
}

TEST_CASE("what is kept can be narrowed to a part of the picture, a triangle, stages and arrays") {
  const WorkingDirectory here;
  const auto json = [&](const std::string& words) {
    return Json::parse(here.run("trace room --size 48x32 -o - " + words).out);
  };
  const Json whole = json(""), part = json("--rect 10,10,14,12"),
             shapes = json("--stages triangles");
  CHECK(part["fragments"].size() < whole["fragments"].size());
  for (const Json& fragment : part["fragments"]) {
    CHECK(fragment["pixel"][0] >= 10);
    CHECK(fragment["pixel"][0] < 14);
  }
  CHECK(shapes["triangles"] == whole["triangles"]);
  CHECK(shapes["fragments"].empty());
  const Json one = json("--instance 0");
  CHECK(one["triangles"].size() < whole["triangles"].size());
  for (const Json& triangle : one["triangles"]) CHECK(triangle["instance"] == 0);

  REQUIRE(here.run("trace cube --size 48x32 --arrays corner.clip,piece -o few.npz").exit_code == 0);
  const auto few = parse_npz(here.file("few.npz"));
  CHECK(few.contains("about"));
  CHECK(few.contains("corner.clip"));
  CHECK(few.contains("piece.edges"));
  CHECK(!few.contains("corner.eye"));
  CHECK(!few.contains("fragment.depth"));
}

TEST_CASE("a trace that would be large says so, and beyond the limit it is refused unwritten") {
  const WorkingDirectory here;
  for (const char* file : {"big.npz", "big.json"}) {
    CAPTURE(file);
    const std::string run = "trace teapot --size 320x240 -o " + std::string(file);
    const Outcome refused = here.run(run + " --max-mb 5");
    CHECK(refused.exit_code == 2);
    CHECK(contains(refused.err, "--max-mb 5"));
    CHECK(contains(refused.err, "fragments"));
    CHECK(contains(refused.err, "--rect"));
    CHECK(here.names().empty());
  }
  const Outcome told = here.run("trace teapot --size 320x240 -o big.npz");
  CHECK(told.exit_code == 0);
  CHECK(contains(told.err, "will be written"));
}

TEST_CASE("trace refuses what it cannot write, says what to do, and writes nothing") {
  const WorkingDirectory here;
  const auto refuses = [&](const std::string& words, const std::string& reason) {
    const Outcome outcome = here.run("trace " + words);
    INFO(words << ": " << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(contains(outcome.err, reason));
    CHECK(outcome.out.empty());
    CHECK(here.names().empty());
  };
  refuses("cube", "--output");
  refuses("cube -o run.txt", ".npz");
  refuses("cube -o none/run.npz", "none");
  refuses("cube -o run.npz --triangle 12", "12 triangles");
  refuses("cube -o run.npz --instance 1", "1 instance;");
  refuses("cube -o run.npz --rect 0,0,1281,5", "1280 x 720");
  refuses("cube -o run.npz --stages triangles,wheels", "wheels");
  refuses("cube -o run.npz --arrays corner.clap", "corner.clip");
  refuses("cube -o run.json --arrays corner.clip", "--stages");
  refuses("cube -o run.npz --stages triangles --arrays corner.clip,fragment", "--arrays fragment");
  refuses("nothing-here.glb -o run.npz", "nothing-here.glb");
}

TEST_CASE("a limit below nothing and an array that is not there are refused, with what was meant") {
  const WorkingDirectory here;
  const std::string run = "trace cube --size 16x16 -o run.npz ";
  check_refused(here.run(run + "--max-mb -1"), {"--max-mb", "'-1'"});
  check_refused(here.run(run + "--arrays vertex.ndk"), {"--arrays", "'vertex.ndk'", "vertex.ndc?"});
  check_refused(here.run(run + "--arrays nothing_like_it"), {"docs/trace.md lists them"});
  CHECK(here.names().empty());
}

// ---- docs/trace.md ----

TEST_CASE("docs/trace.md names every array with its type and the shape of a row") {
  const WorkingDirectory here;
  REQUIRE(here.run("trace cube --size 16x12 -o run.npz").exit_code == 0);
  const std::string page = [] {
    std::ifstream in(std::string(GLASSBOX_SOURCE_DIR) + "/docs/trace.md");
    return std::string(std::istreambuf_iterator<char>(in), {});
  }();
  for (const auto& [name, array] : parse_npz(here.file("run.npz"))) {
    CAPTURE(name, array.type);
    const std::size_t line = page.find("\n| `" + name + "` | " + array.type.substr(1) + " | ");
    REQUIRE(line != std::string::npos);
    // In "(T, 3, 4)" the number of dimensions must agree, and so must those that do not depend on
    // the run.
    std::istringstream dimensions(between(page.substr(line), "| (", ")"));
    std::vector<std::string> shape;
    for (std::string n; dimensions >> n;)
      shape.push_back(n.ends_with(',') ? n.substr(0, n.size() - 1) : n);
    REQUIRE(shape.size() == array.shape.size());
    for (std::size_t i = 0; i < shape.size(); ++i) {
      if (std::isdigit(static_cast<unsigned char>(shape[i][0]))) {
        CHECK(std::stoul(shape[i]) == array.shape[i]);
      }
    }
  }
}

TEST_CASE("what docs/trace.md shows is what the commands print") {
  const WorkingDirectory here;
  const std::string find_numpy =
      "for p in python3 /usr/bin/python3; do $p -c 'import numpy' 2>/dev/null && exec $p \"$@\"; "
      "done; exit 77";
  std::ifstream in(std::string(GLASSBOX_SOURCE_DIR) + "/docs/trace.md");
  REQUIRE(in);
  int count = 0;
  for (const Session& session : sessions_of(in)) {
    CAPTURE(session.command);
    std::string expected = session.output;
    while (expected.ends_with("\n\n")) expected.pop_back();
    if (session.command.starts_with("cat ")) {
      here.write(session.command.substr(4), expected);
      continue;
    }
    ++count;
    if (session.command.starts_with("python3 ")) {
      const Outcome outcome =
          run_program("/bin/sh", {"-c", find_numpy, "sh", session.command.substr(8)}, here.path());
      if (outcome.exit_code == 77) {
        SKIP_TEST("NumPy (Debian: python3-numpy) is not installed");
      }
      CAPTURE(outcome.err);
      CHECK(outcome.exit_code == 0);
      CHECK(outcome.out == expected);
      continue;
    }
    REQUIRE(session.command.starts_with("glassbox "));
    const Outcome outcome = here.run(session.command.substr(9));
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.out == expected);
  }
  CHECK(count >= 2);
}

}  // namespace
}  // namespace glassbox::test
