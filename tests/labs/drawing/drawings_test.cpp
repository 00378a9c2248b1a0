// Tests pictures with a student's functions in the pipeline: every lab with a right, a wrong, a
// crashing and an endless stage.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "labs/drawing/draw_and_compare.h"
#include "labs/drawing/stage_program.h"
#include "labs/framework/lab.h"
#include "tests/support/catch.h"
#include "tests/support/daily_share.h"

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>

using namespace glassbox;
using namespace glassbox::labs;

namespace {

namespace fs = std::filesystem;

// A defect that is planted in the solution: `find` becomes `replace`, an expression that depends on
// trial::wrong().
struct Trial {
  int lab;
  std::string scene;
  RenderSettings settings;
  std::string find, replace;
  // the stage in which it is found, and functions that a message names
  std::string stage, functions;
};

const std::vector<Trial>& trials() {
  RenderSettings d16;
  d16.depth = DepthFormat::kUnorm16;
  static const std::vector<Trial> all{
      {1,
       "teapot:2",
       {},
       "m.x += (p.y - next.y)",
       "m.x += (trial::wrong() ? 2 : 1) * (p.y - next.y)",
       "normal",
       "newell_vector"},
      {2,
       "room",
       {},
       "return rotation(step.v, step.amount);",
       "return rotation(step.v, trial::wrong() ? step.amount + 1 : step.amount);",
       "place",
       "compose"},
      {3,
       "room",
       {},
       "gaze * (-1 / length(gaze))",
       "gaze * ((trial::wrong() ? 1 : -1) / length(gaze))",
       "view",
       "uvn_view"},
      {4,
       "room",
       {},
       "std::tan(fovy_radians / 2)",
       "std::tan(fovy_radians / (trial::wrong() ? 1 : 2))",
       "projection",
       "perspective"},
      {5,
       "room",
       {},
       "if (!(p.x <= p.w)) code",
       "if (!(p.x <= (trial::wrong() ? p.w / 2 : p.w))) code",
       "clip",
       "outcode"},
      {6, "room", {}, "* kSteps + 0.5)", "* kSteps + (trial::wrong() ? 0 : 0.5))", "snap", "snap"},
      {7, "room", d16, "double(z) * steps", "double(trial::wrong() ? 1 - z : z) * steps", "codes",
       "depth_code"},
      {8,
       "room",
       {},
       "float(at.edges[k]) * at.inverse_w[k]",
       "float(at.edges[k]) * (trial::wrong() ? 1 : at.inverse_w[k])",
       "attributes",
       "texcoord_at"},
      {9,
       "room",
       {},
       "skew.at(0, 2) = s / pair.window;",
       "skew.at(0, 2) = (trial::wrong() ? -s : s) / pair.window;",
       "eye",
       "eye_projection"},
      {10,
       "room",
       {},
       "r[2] * l[0], r[2] * l[1]",
       "r[2] * l[trial::wrong() ? 1 : 0], r[2] * l[1]",
       "matrix",
       "eight_point"},
      {11,
       "room",
       {},
       "< picture.at(x, y)) word",
       "< picture.at(x, y) - (trial::wrong() ? 20 : 0)) word",
       "costs",
       "census"},
      {12,
       "room",
       {},
       "focal_ratio / w *",
       "(trial::wrong() ? 3 : 1) * focal_ratio / w *",
       "size",
       "splat_size"},
      {13,
       "teapot",
       {},
       "statistics(all).deviation < most",
       "statistics(all).deviation < (trial::wrong() ? 0 : most)",
       "sweep",
       "sweep"},
      {14,
       "teapot:2",
       {},
       "(level - from) / (to - from)",
       "(level - from) / ((trial::wrong() ? 2 : 1) * (to - from))",
       "shares",
       "crossing"},
  };
  return all;
}

// One program behaves in four ways, chosen by a letter in its file, so that it is compiled only
// once.
constexpr const char* kMark = "glassbox trial: ";
constexpr const char* kTrial = R"(
namespace trial {
static volatile char how[] = "glassbox trial: r";
// True where the answer is to be wrong; ends in a crash or not at all where that is asked.
inline bool wrong() {
  const char letter = how[sizeof how - 2];
  if (letter == 'c') *static_cast<volatile int*>(nullptr) = 1;
  while (letter == 'e') how[0] = how[0];
  return letter == 'w';
}
}
)";

const Lab& lab_of(int number) {
  const auto& all = all_labs();
  return *std::find_if(all.begin(), all.end(), [&](const Lab& l) { return l.number == number; });
}

// A temporary folder that the sandbox's user may enter.
class TestDirectory {
public:
  TestDirectory() {
    std::string name = (fs::temp_directory_path() / "glassbox-drawing-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path_ = name;
    fs::permissions(path_, fs::perms(0711));
  }
  ~TestDirectory() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  const fs::path& path() const { return path_; }

private:
  fs::path path_;
};

class StudentProgramTest {
public:
  explicit StudentProgramTest(const Trial& trial)
      : trial_(trial),
        sandbox_(grading::Sandbox::choose(directory_.path()).value()),
        drawing_(drawing_of(trial.lab).value()),
        scene_(make_builtin(trial.scene).value()) {
    const Sources sources = find_sources().value();
    const std::string& folder = lab_of(trial.lab).folder;
    std::string text = solution_text(sources, folder).value();
    const std::size_t at = text.find(trial.find);
    REQUIRE(at != std::string::npos);
    text.replace(at, trial.find.size(), trial.replace);
    const fs::path student = directory_.path() / "student.cpp";
    std::ofstream(student) << "#include \"student.h\"\n" << kTrial << text;
    const fs::path kept = fs::path(KEPT) / folder;
    fs::create_directories(kept);
    const auto made = build_stages(sources, {folder, student, kept, directory_.path()}, sandbox_);
    REQUIRE(made);
    INFO(made->messages);
    REQUIRE_FALSE(made->program.empty());
    program_ = made->program;
  }

  // Returns a copy of the program that behaves so: r is right, w is wrong, c crashes, e is endless.
  fs::path behaving(char how) const {
    std::ifstream file(program_, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), {});
    const std::size_t mark = bytes.find(kMark);
    REQUIRE(mark != std::string::npos);
    bytes[mark + std::string(kMark).size()] = how;
    const fs::path program = directory_.path() / std::string("stages-").append(1, how);
    std::ofstream(program, std::ios::binary) << bytes;
    fs::permissions(program, fs::perms(0755));
    return program;
  }

  struct Outcome {
    Result<ComparedPictures> both;
    std::optional<std::string> failure;
  };
  Outcome draw(char how, double seconds = 60) const {
    Camera camera =
        scene_.cameras.empty() ? framing_camera(scene_, 64.0 / 48).value() : scene_.cameras[0];
    const DepthRange range = DepthRange::kStandard;
    const DrawingInput drawn{scene_,          camera, make_view(camera, 64, 48, range).value(),
                             trial_.settings, {},     {0.05, 3}};
    StudentAnswers answers(sandbox_, behaving(how), seconds);
    auto both = draw_and_compare(drawing_, drawn, answers);
    return {std::move(both), answers.failure()};
  }

private:
  TestDirectory directory_;
  const Trial& trial_;
  grading::Sandbox sandbox_;
  LabDrawing drawing_;
  Scene scene_;
  fs::path program_;
};

}  // namespace

namespace {

// Expects that the solution draws as the reference does, and that the defects are named.
void draw_in_every_way(const Trial& trial) {
  CAPTURE(trial.lab);
  const StudentProgramTest student_program(trial);

  const StudentProgramTest::Outcome right = student_program.draw('r');
  REQUIRE(right.both);
  const DrawingResult& fine = right.both->result;
  CHECK(fine.right());
  std::uint64_t records = 0;
  for (const JudgedStage& stage : fine.stages) records += stage.records;
  CHECK(records > 0);
  // Interpolation in float and in double sometimes gives neighbouring bytes; nothing else rounds.
  CHECK(fine.differing_pixels <= (trial.lab == 8 ? fine.yours.pixels.size() / 100 : 0));
  // Layers lack what no eye has seen, so the true picture is shown too.
  CHECK(fine.truth.has_value() == (trial.lab >= 12));
  if (fine.truth) CHECK(fine.truth->pixels != fine.reference.pixels);

  const StudentProgramTest::Outcome wrong = student_program.draw('w');
  REQUIRE(wrong.both);
  const DrawingResult& found = wrong.both->result;
  CHECK_FALSE(found.right());
  CHECK(found.differing_pixels > 0);
  REQUIRE(found.first_record);
  const WrongRecord& record = found.wrong[*found.first_record];
  CHECK(found.stages[record.stage].name == trial.stage);
  CHECK(std::abs(record.number.yours - record.number.reference) > record.number.bound);
  REQUIRE(found.first_pixel);
  CHECK(found.first_pixel->yours != found.first_pixel->reference);

  const StudentProgramTest::Outcome crashing = student_program.draw('c');
  CHECK_FALSE(crashing.both);
  REQUIRE(crashing.failure);
  CAPTURE(*crashing.failure);
  CHECK(crashing.failure->find("SIGSEGV") != std::string::npos);
  CHECK(crashing.failure->find(trial.functions) != std::string::npos);

  const StudentProgramTest::Outcome endless = student_program.draw('e', 0.5);
  CHECK_FALSE(endless.both);
  REQUIRE(endless.failure);
  CAPTURE(*endless.failure);
  CHECK(endless.failure->find("still running after 0.5 seconds") != std::string::npos);
}

void draw_labs(const test::DailyShare& share) {
  INFO(share.text());
  for (std::size_t i = 0; i < trials().size(); ++i) {
    if (share.includes(i, trials().size())) draw_in_every_way(trials()[i]);
  }
}

}  // namespace

// Each lab is a program that takes some ten seconds to compile.
TEST_CASE("labs draw, some every day: solutions as the reference, and what goes wrong is named") {
  draw_labs(test::DailyShare(3));
}

TEST_CASE("every lab draws: the solution as the reference, and what goes wrong is named",
          "[.faults]") {
  draw_labs(test::DailyShare::everything());
}

TEST_CASE("every lab has a trial, whose text its solution has once") {
  const Sources sources = find_sources().value();
  for (const Lab& lab : all_labs()) {
    INFO(lab.folder);
    CHECK(std::count_if(trials().begin(), trials().end(),
                        [&](const Trial& trial) { return trial.lab == lab.number; }) == 1);
  }
  for (const Trial& trial : trials()) {
    INFO(trial.find);
    const std::string text = solution_text(sources, lab_of(trial.lab).folder).value();
    const std::size_t at = text.find(trial.find);
    CHECK(at != std::string::npos);
    CHECK(text.find(trial.find, at + 1) == std::string::npos);
  }
}
