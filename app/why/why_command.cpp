// glassbox why SCENE [--triangle N]: explains why a triangle, or a whole scene, is or is not
// visible.
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/why/matrix_suspicions.h"
#include "app/why/verdict_text.h"
#include "cli/options/add_command.h"
#include "cli/options/builtin_help.h"
#include "cli/options/picture_question.h"
#include "cli/report/shell_line.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/error.h>
#include <glassbox/render/trace/scene_verdict.h>

namespace glassbox::app {

class WhyCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  Result<Answer> answer(const Scene& scene, const View& view) const;
  Result<Answer> about_triangle(const Scene& scene, const View& view, std::uint64_t number) const;
  Result<Answer> about_scene(const Scene& scene, const View& view) const;
  std::string triangle_text(const Scene& scene, const View& view,
                            const TriangleVerdict& verdict) const;
  // The pair of triangles that fights most, and how many others there are.
  std::string fights_text(const Scene& scene, const View& view,
                          const std::vector<DepthFight>& fights, const char* label) const;
  // `suspicions` is the text about the user's own matrices, or empty.
  std::string scene_text(const Scene& scene, const View& view, const SceneVerdict& found,
                         const std::string& suspicions) const;
  // The command line "glassbox SUBCOMMAND SCENE ... OPTION VALUE", with the options of this
  // picture.
  std::string command(const char* subcommand, const std::string& option,
                      const std::string& value) const;

  PictureQuestion question_;
  std::optional<std::uint64_t> triangle_;
};

namespace {

std::uint64_t parse_number(const std::string& text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw CLI::ValidationError(
        "--triangle", "needs a triangle's number, counted from 0 in the scene, not '" + text + "'");
  }
  return number;
}

// The pixel at which the reason for the verdict is best seen.
std::optional<std::array<int, 2>> telling_pixel(const TriangleVerdict& verdict) {
  const FragmentDetails& d = verdict.details;
  if (d.example) return d.example;
  if (verdict.result == TriangleResult::kHidden)
    return {{d.closest_hidden->x, d.closest_hidden->y}};
  if (verdict.result == TriangleResult::kDiscarded)
    return {{d.closest_discarded->x, d.closest_discarded->y}};
  if (verdict.result == TriangleResult::kOverwritten) return d.overwritten_at;
  if (verdict.nearest_centre) return {{verdict.nearest_centre->x, verdict.nearest_centre->y}};
  return std::nullopt;
}

// Where the eye stands; nothing in a parallel view.
std::optional<Point<World, double>> eye_of(const View& view, const SceneVerdict& found) {
  return view.perspective ? std::optional(found.extent.eye) : std::nullopt;
}

// The triangle that shows best why nothing is seen: one that the first cause takes, or else one
// that ends as most do. Nothing if some triangle is seen.
std::optional<std::uint32_t> telling_triangle(const SceneVerdict& found) {
  const std::optional<TriangleResult> loss = found.most_frequent_loss();
  if (!loss || !found.all_lost()) return std::nullopt;
  if (found.causes.empty()) return found.at(*loss).example;
  return found.causes.front().example;
}

// What keeps the scene out of the picture: the first cause with its mend, and a line for each of
// the others. Empty if the scene is seen.
std::string causes_text(const Scene& scene, const View& view, const SceneVerdict& found,
                        bool own_matrices) {
  std::string text;
  for (const SceneCause& cause : found.causes) {
    const bool first = text.empty();
    const CauseText words = explain(scene, view, found, cause);
    const std::string share =
        cause.triangles == 0
            ? ""
            : fmt::format("{} of {}: ", cause.triangles, counted(found.triangles, "triangle"));
    text += wrapped(first ? "  CAUSE  " : "  also   ", share + words.why);
    const bool of_camera = own_matrices && words.mend.find("--") != std::string::npos;
    if (first) {
      text += wrapped("      -> ",
                      (of_camera ? "for a camera in place of the matrices: " : "") + words.mend);
    }
  }
  return text;
}

}  // namespace

std::string WhyCommand::command(const char* subcommand, const std::string& option,
                                const std::string& value) const {
  return shell_line({{subcommand, question_.scene_name()},
                     given_option_words(question_.picture()),
                     {option, value}});
}

std::string WhyCommand::triangle_text(const Scene& scene, const View& view,
                                      const TriangleVerdict& verdict) const {
  const NumberedTriangle& triangle = verdict.triangle;
  std::string text = fmt::format("triangle {} of {}: {}\n", triangle.number, question_.title(),
                                 result_words(verdict.result));
  text += fmt::format("  what   {}\n", face_text(scene, triangle.instance, triangle.face));
  text += fmt::format("  stage  {}\n", stage_of(verdict.result));
  const char* label = "  why    ";
  for (const std::string& paragraph : explain(view, verdict)) {
    text += wrapped(label, paragraph);
    label = "         ";
  }
  text += fights_text(scene, view, verdict.fights, "         ");
  std::vector<std::string> lines;
  if (const auto at = telling_pixel(verdict)) {
    lines.push_back(command("pixel", "--at", fmt::format("{},{}", (*at)[0], (*at)[1])));
  }
  if (verdict.traced) {
    lines.push_back(command("step", "--triangle", std::to_string(triangle.number)));
  }
  label = "  look   ";
  for (const std::string& line : lines) {
    if (line.empty()) continue;
    text += label + line + "\n";
    label = "         ";
  }
  return text;
}

std::string WhyCommand::fights_text(const Scene& scene, const View& view,
                                    const std::vector<DepthFight>& fights,
                                    const char* label) const {
  if (fights.empty()) return {};
  std::string text = fight_text(scene, view, question_.picture().settings.depth, fights.front());
  if (fights.size() > 1) {
    text += fmt::format(" {} do the same.", counted(fights.size() - 1, "other pair"));
  }
  return wrapped(label, text);
}

std::string WhyCommand::scene_text(const Scene& scene, const View& view, const SceneVerdict& found,
                                   const std::string& suspicions) const {
  std::string text =
      fmt::format("{}: {}\n", question_.title(), counted(found.triangles, "triangle")) +
      suspicions + causes_text(scene, view, found, question_.picture().matrices.replace_camera());
  if (found.triangles == 0) {
    if (!found.causes.empty()) return text;
    return text + "  This scene has no triangles; glassbox pixel shows lines and points, too.\n";
  }
  text += fmt::format("  {:>10}  {:<23}{:<13}{}\n", "triangles", "end", "stage", "for example");
  for (std::size_t i = 0; i < kTriangleResults; ++i) {
    const SceneVerdict::Group& group = found.groups[i];
    if (group.triangles == 0) continue;
    text +=
        fmt::format("  {:>10}  {:<23}{:<13}{}\n", group.triangles, result_words(TriangleResult(i)),
                    stage_of(TriangleResult(i)), group.example);
  }
  const std::optional<TriangleResult> loss = found.most_frequent_loss();
  std::string notes = fights_text(scene, view, found.fights, "  note   ");
  for (const std::string& one : surface_findings(scene, eye_of(view, found))) {
    notes += wrapped("  note   ", one);
  }
  if (!loss || !found.causes.empty()) return text + notes;
  const SceneVerdict::Group& lost = found.at(*loss);
  text += wrapped("  ", fmt::format("{}: {}.",
                                    lost.triangles == found.triangles
                                        ? std::string("All of them end there")
                                        : fmt::format("Most invisible triangles end as {}",
                                                      result_words(*loss)),
                                    result_meaning(*loss)));
  text += notes;
  const std::string line = command("why", "--triangle", std::to_string(lost.example));
  if (!found.all_lost() && !line.empty()) text += "  look   " + line + "\n";
  return text;
}

void WhyCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "why",
      "say why a triangle is not visible, or where it is; without --triangle, for all triangles");
  command.footer(
      "Examples:\n"
      "  glassbox why cube --triangle 0\n"
      "  glassbox why teapot --triangle 4711 --size 320x180\n"
      "  glassbox why room --eye 0,1,9 --look-at 0,1,20\n\n"
      "The options are those of glassbox render: the same options show the same picture.\n\n" +
      builtin_help());
  command
      .add_option_function<std::string>(
          "--triangle", [this](const std::string& text) { triangle_ = parse_number(text); },
          "the triangle's number in the scene, counted from 0 (render --id-out stores 1 more)")
      ->type_name("N");
  question_.add_to(command);
  question_.add_check(command, "exit with 1 if nothing is seen, or not the triangle");
  command.callback([this, &exit_code] {
    print_pixel_centres_note(question_.picture());
    exit_code = question_.answer(
        [this](const Scene& scene, const View& view) { return answer(scene, view); });
  });
}

Result<Answer> WhyCommand::answer(const Scene& scene, const View& view) const {
  return triangle_ ? about_triangle(scene, view, *triangle_) : about_scene(scene, view);
}

Result<Answer> WhyCommand::about_triangle(const Scene& scene, const View& view,
                                          std::uint64_t number) const {
  const Result<TriangleVerdict> found =
      triangle_verdict(scene, view, question_.picture().settings, number);
  if (!found) return tl::unexpected(found.error());
  Answer answer{to_json(*found), triangle_text(scene, view, *found), is_seen(found->result)};
  answer.json["why"] = explain(view, *found);
  return answer;
}

// If nothing is visible, explains one triangle as an example.
Result<Answer> WhyCommand::about_scene(const Scene& scene, const View& view) const {
  const SceneVerdict found = scene_verdict(scene, view, question_.picture().settings);
  // Matrices are suspected only if little is seen.
  const MatrixSuspicions suspected =
      found.is_little_seen() ? suspect_matrices(scene, question_.picture()) : MatrixSuspicions{};
  Answer answer{to_json(found), scene_text(scene, view, found, suspicions_text(suspected)),
                found.shown_pixels > 0};
  if (suspected.any()) answer.json["matrices"] = suspicions_json(suspected);
  answer.json["surfaces"] = surface_findings(scene, eye_of(view, found));
  for (std::size_t i = 0; i < found.causes.size(); ++i) {
    const CauseText text = explain(scene, view, found, found.causes[i]);
    answer.json["causes"][i]["why"] = text.why;
    answer.json["causes"][i]["mend"] = text.mend;
  }
  const std::optional<std::uint32_t> triangle = telling_triangle(found);
  if (!triangle) return answer;
  const Result<Answer> example = about_triangle(scene, view, *triangle);
  if (!example) return tl::unexpected(example.error());
  answer.json["example"] = example->json;
  answer.text += "\n" + example->text;
  return answer;
}

void add_why_command(CLI::App& app, int& exit_code) {
  add_command<WhyCommand>(app, exit_code);
}

}  // namespace glassbox::app
