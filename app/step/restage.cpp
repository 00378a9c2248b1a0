#include "app/step/restage.h"

#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/options/arguments.h"
#include "app/options/command_tree.h"
#include "app/options/picture_options.h"
#include "app/step/stepped.h"

namespace glassbox::app {

namespace {

// What the words can say.
struct Request {
  PictureOptions picture;
  std::optional<std::uint32_t> triangle;
  std::optional<std::array<int, 2>> pick;
  std::optional<std::string> vertex;  // "0", "1", "2" or "all"
};

void add_options(CLI::App& app, Request& request) {
  add_picture_options(app, request.picture);
  app.add_option("--triangle", request.triangle)->type_name("N");
  app.add_option_function<std::string>("--pick",
                                       [&request](const std::string& text) {
                                         const auto [x, y] = parse_pixel("--pick", text);
                                         request.pick = {{x, y}};
                                       })
      ->type_name("X,Y")
      ->excludes(app.get_option("--triangle"));
  app.add_option("--vertex", request.vertex)
      ->type_name("0|1|2|all")
      ->check(CLI::IsMember({"0", "1", "2", "all"}));
  for (CLI::Option* option : app.get_options())
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

Result<StepTarget> target_of(const Scene& scene, const Request& request, StepTarget target) {
  if (request.vertex) {
    target.vertex.reset();
    if (*request.vertex != "all") target.vertex = (*request.vertex)[0] - '0';
  }
  if (request.triangle) {
    if (const auto legal = check_triangle("triangle", scene, *request.triangle); !legal) {
      return tl::unexpected(legal.error());
    }
    target.triangle = *request.triangle;
    target.pixel.reset();
  }
  if (request.pick) {
    const auto [x, y] = *request.pick;
    if (const auto legal = check_pixel("pick", {x, y}, request.picture.size); !legal) {
      return tl::unexpected(legal.error());
    }
    const auto picked = pick(scene, request.picture, x, y);
    if (!picked) return tl::unexpected(picked.error());
    target.triangle = *picked;
    target.pixel = request.pick;
  }
  return target;
}

}  // namespace

Result<Staged> restage(const Scene& scene, bool bits, const StepChoice& choice,
                       const std::vector<std::string>& more) {
  CLI::App app;
  Request request;
  add_options(app, request);
  std::vector<std::string> words = choice.words;
  words.insert(words.end(), more.begin(), more.end());
  try {
    // CLI11 wants the last first.
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Error& error) {
    return fail("", error.what(), "glassbox step --help lists the picture options");
  }
  const Result<StepTarget> target = target_of(scene, request, choice.target);
  if (!target) return tl::unexpected(target.error());
  const auto stepped = step_through(scene, request.picture, target->triangle);
  if (!stepped) return tl::unexpected(stepped.error());
  return Staged{{words_given(request.picture), *target},
                stage_texts(scene, *stepped, *target, bits)};
}

OptionWords restage_options() {
  CLI::App app;
  Request request;
  add_options(app, request);
  OptionWords options;
  for (const OptionFacts& option : command_tree(app).options) {
    const std::string& name = option.names.back();
    if (name != "--help") options[name] = kinds_of(option).choices;
  }
  return options;
}

}  // namespace glassbox::app
