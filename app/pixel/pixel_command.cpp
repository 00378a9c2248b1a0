#include "app/pixel/pixel_command.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/pixel/history_json.h"
#include "app/pixel/history_text.h"
#include "app/why/verdict_text.h"
#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/builtin_help.h"
#include "cli/options/picture_question.h"
#include "cli/report/exit_codes.h"
#include "cli/report/number_json.h"
#include "cli/report/shell_line.h"

#include <glassbox/compare/pixels/differences.h>
#include <glassbox/images/recipe.h>
#include <glassbox/pipeline/unproject.h>
#include <glassbox/render/trace/depth_fights.h>
#include <glassbox/render/trace/numbering.h>

namespace glassbox::app {

class PixelCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run() const;
  Answer answer(const Scene& scene, const View& view) const;

  PictureQuestion question_;
  PixelPosition at_;
  bool all_ = false;  // list all triangles that narrowly miss the pixel's centre
};

namespace {

using Json = nlohmann::ordered_json;

// The world-space point seen at the pixel's centre. `distance` is its distance from the eye,
// measured along the direction of view.
Result<Point<World, double>> world_point(const View& view, PixelPosition pixel, double distance) {
  const auto& m = view.clip_from_eye;
  const double clip_z = double(m.at(2, 2)) * -distance + double(m.at(2, 3));
  const double ndc_z = view.perspective ? clip_z / distance : clip_z;
  return unproject(view, {pixel.x + 0.5, pixel.y + 0.5, ndc_z});
}

// The final contents of the pixel in the picture.
struct SeenPixel {
  Rgba8 color;
  std::optional<NumberedTriangle> triangle;  // none for a line, a point or the background
  std::optional<double> distance;            // none for the background
  std::optional<Point<World, double>> world;
};

SeenPixel seen_at(const Scene& scene, const View& view, const Framebuffer& buffers,
                  PixelPosition at) {
  SeenPixel seen;
  seen.color = buffers.color.at(at.x, at.y);
  const std::uint32_t id = buffers.id.at(at.x, at.y);
  if (id > 0) seen.triangle = find_triangle(scene, id - 1);
  const double distance = double(buffers.distance.at(at.x, at.y));
  if (!std::isfinite(distance)) return seen;
  seen.distance = distance;
  if (const auto world = world_point(view, at, distance)) seen.world = *world;
  return seen;
}

std::string text_of(const Scene& scene, const SeenPixel& seen) {
  const Rgba8& c = seen.color;
  std::string text = fmt::format("  colour    ({}, {}, {}), alpha {}\n", c.r, c.g, c.b, c.a);
  if (!seen.distance) return text + "  nothing was drawn here: this is the background\n";
  text += seen.triangle
              ? fmt::format("  triangle  {}: {}\n", seen.triangle->number,
                            face_text(scene, seen.triangle->instance, seen.triangle->face))
              : "  triangle  none: a line or a point\n";
  text += fmt::format("  distance  {:.9g} along the gaze\n", *seen.distance);
  if (seen.world) {
    text += fmt::format("  world     ({:.9g}, {:.9g}, {:.9g})\n", seen.world->x, seen.world->y,
                        seen.world->z);
  }
  return text;
}

Json json_of(const Scene& scene, const SeenPixel& seen) {
  Json json{{"color", numbers_json(seen.color)}};
  if (seen.triangle) {
    const Instance& instance = scene.instances[seen.triangle->instance];
    json["triangle"] = seen.triangle->number;
    json["instance"] = seen.triangle->instance;
    json["mesh"] = scene.meshes[instance.mesh].name;
    json["face"] = seen.triangle->face;
  }
  if (seen.distance) json["distance"] = *seen.distance;
  if (seen.world) json["world"] = numbers_json(*seen.world);
  return json;
}

// Whether the triangle has a fragment in the pixel.
bool is_in(const PixelHistory& history, std::uint32_t triangle) {
  return std::ranges::any_of(history.events, [&](const PixelEvent& event) {
    return is_fragment(event) && event.source.is_triangle && event.source.number == triangle;
  });
}

// The pairs of triangles that fight in the picture, and of which both are in this pixel.
std::vector<DepthFight> fights_in(const Scene& scene, const View& view,
                                  const RenderSettings& settings, const PixelHistory& history) {
  std::vector<DepthFight> fights = depth_fights(scene, view, settings);
  std::erase_if(fights, [&](const DepthFight& fight) {
    return !is_in(history, fight.first) || !is_in(history, fight.second);
  });
  return fights;
}

// Whether the words are options that add_picture_options knows, written as given_option_words
// writes them, and nothing else. In particular there is no "--" or "++", which would change the
// meaning of the words after it.
bool are_picture_options(const std::vector<std::string>& words) {
  CLI::App app;
  PictureOptions picture;
  add_picture_options(app, picture);
  try {
    app.parse(
        // CLI11 expects the words in reverse order
        std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Error&) {
    return false;  // CLI11 throws for an unknown option, and for --help too
  }
  return given_option_words(picture) == words;
}

}  // namespace

std::string pixel_command_line(const Recipe& recipe, PixelPosition pixel) {
  if (recipe.scene.starts_with('-') || !are_picture_options(recipe.options)) return {};
  return shell_line(
      {{"pixel", recipe.scene}, recipe.options, {"--at", fmt::format("{},{}", pixel.x, pixel.y)}});
}

void PixelCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "pixel", "print what is seen in one pixel of a picture, and the history of the pixel");
  command.footer(
      "Examples:\n"
      "  glassbox pixel teapot --at 640,360\n"
      "  glassbox pixel room --size 320x180 --shade flat --at 12,34 --json -\n\n"
      "The history has every fragment that touched the pixel, in drawing order, and triangles "
      "that\n"
      "were culled or clipped where they would have covered it, or that miss its centre.\n"
      "The options are those of glassbox render: the same options show the same picture.\n\n" +
      builtin_help());
  command
      .add_option_function<std::string>(
          "--at", [this](const std::string& text) { at_ = parse_pixel("--at", text); },
          "the pixel, counted from 0 at the top left")
      ->type_name("X,Y")
      ->required();
  command.add_flag("--all", all_,
                   "list all triangles that miss the pixel's centre, not the nearest few");
  question_.add_to(command);
  command.callback([this, &exit_code] { exit_code = run(); });
}

int PixelCommand::run() const {
  const auto legal = check_pixel("--at", at_, question_.picture().size);
  if (!legal) return refuse(legal.error());
  print_pixel_centres_note(question_.picture());
  return question_.answer(
      [this](const Scene& scene, const View& view) { return answer(scene, view); });
}

Answer PixelCommand::answer(const Scene& scene, const View& view) const {
  RenderSettings settings = question_.picture().settings;
  settings.want_distance = true;
  settings.want_id = true;
  Rendering rendering;
  const PixelHistory history = pixel_history(scene, view, settings, at_.x, at_.y, &rendering);
  const SeenPixel seen = seen_at(scene, view, rendering.buffers, at_);

  Json json{{"x", at_.x}, {"y", at_.y}};
  json.update(json_of(scene, seen));
  json["history"] = to_json(scene, history);
  json["depth_fights"] = Json::array();
  std::vector<std::string> notes;
  for (const DepthFight& fight : fights_in(scene, view, settings, history)) {
    json["depth_fights"].push_back(to_json(fight));
    notes.push_back(fight_text(scene, view, settings.depth, fight));
  }
  return {json, fmt::format("pixel ({}, {}) of {}\n{}\n{}", at_.x, at_.y, question_.title(),
                            text_of(scene, seen), history_text(scene, history, all_, notes))};
}

void add_pixel_command(CLI::App& app, int& exit_code) {
  add_command<PixelCommand>(app, exit_code);
}

}  // namespace glassbox::app
