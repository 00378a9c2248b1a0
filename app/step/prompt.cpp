#include "app/step/prompt.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/arguments.h"
#include "cli/options/command_tree.h"
#include "cli/options/picture_options.h"

namespace glassbox::app {

namespace {

constexpr const char* kHelp =
    "  n, Enter    next stage            p, b        back\n"
    "  NAME        jump to a stage: object, world, eye, clip, clipping, ndc, screen, setup, "
    "fragments\n"
    "  all         every stage from the first\n"
    "  triangle N  another triangle of the scene, by its number\n"
    "  pick X,Y    the triangle that is visible in this pixel, and its fragment there\n"
    "  vertex K    only this corner: 0, 1 or 2; vertex all shows all of them again\n"
    "  --eye 1,2,3 --fov 60 ...          other picture options; shows what they change, stage by "
    "stage\n"
    "  reset       the options and the triangle as they were at the start\n"
    "  help        these lines           q           quit\n";

struct PromptState {
  StepChoice choice;
  std::vector<StageText> stages;
};

// ---- another choice ----

// What the options typed at the prompt can change.
struct PromptRequest {
  PictureOptions picture;
  std::optional<std::uint32_t> triangle;
  std::optional<PixelPosition> pick;
  std::optional<std::string> vertex;  // "0", "1", "2" or "all"
};

void add_options(CLI::App& app, PromptRequest& request) {
  add_picture_options(app, request.picture);
  app.add_option("--triangle", request.triangle)->type_name("N");
  app.add_option_function<std::string>(
         "--pick",
         [&request](const std::string& text) { request.pick = parse_pixel("--pick", text); })
      ->type_name("X,Y")
      ->excludes(app.get_option("--triangle"));
  app.add_option("--vertex", request.vertex)
      ->type_name("0|1|2|all")
      ->check(CLI::IsMember({"0", "1", "2", "all"}));
  for (CLI::Option* option : app.get_options())
    option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

// Computes the stages for additional words: picture options, --triangle N, --pick X,Y and --vertex
// K. Everything that they do not mention stays as in `choice`. A picked triangle stays the same
// when the picture changes later.
Result<PromptState> apply_options(const Scene& loaded, bool bits, const StepChoice& choice,
                                  const std::vector<std::string>& more) {
  CLI::App app;
  PromptRequest request;
  add_options(app, request);
  read_as_decimal(app);
  std::vector<std::string> words = choice.words;
  words.insert(words.end(), more.begin(), more.end());
  try {
    // CLI11 expects the words in reverse order.
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Error& error) {
    return fail("", error.what(), "glassbox step --help lists the picture options");
  }
  StepTarget target = choice.target;
  if (request.vertex) {
    target.vertex.reset();
    if (*request.vertex != "all") target.vertex = (*request.vertex)[0] - '0';
  }
  // The scene with another texture filter, if the words contain --filter.
  std::optional<Scene> refiltered;
  if (request.picture.filter) refiltered = with_texture_filter(loaded, request.picture);
  const Scene& scene = refiltered ? *refiltered : loaded;
  const auto aimed =
      set_step_target(target, scene, request.picture, request.triangle, request.pick, "");
  if (!aimed) return tl::unexpected(aimed.error());
  const auto stepped = step_through(scene, request.picture, target.triangle);
  if (!stepped) return tl::unexpected(stepped.error());
  return PromptState{{given_option_words(request.picture), target},
                     stage_texts(scene, *stepped, target, bits)};
}

// The names of the options that apply_options accepts, each with its possible values; no values for
// numbers.
using OptionWords = std::map<std::string, std::vector<std::string>>;

OptionWords prompt_options() {
  CLI::App app;
  PromptRequest request;
  add_options(app, request);
  OptionWords options;
  for (const OptionFacts& option : command_tree(app).options) {
    const std::string& name = option.names.back();
    if (name != "--help") options[name] = kinds_of(option).choices;
  }
  return options;
}

// The words that can complete a command.
std::vector<std::string> step_candidates(const std::vector<std::string>& words,
                                         const OptionWords& options) {
  const bool first = words.size() == 1;
  std::vector<std::string> candidates;
  if (first) {
    candidates = {"next", "back",   "object", "world",     "eye",     "clip", "clipping",
                  "ndc",  "screen", "setup",  "fragments", "picture", "all",  "triangle",
                  "pick", "vertex", "reset",  "help",      "quit"};
  } else if (words.size() == 2 && words[0] == "vertex") {
    return {"0", "1", "2", "all"};
  } else {
    const auto option = options.find(words[words.size() - 2]);
    if (option != options.end() && !option->second.empty()) return option->second;
    if (!words[0].starts_with("--")) return {};
  }
  // All options at once would not help, so they are offered after "-" only.
  if (words.back().starts_with("-")) {
    for (const auto& [name, choices] : options) candidates.push_back(name);
  }
  return candidates;
}

// ---- what a choice changes ----

std::vector<std::string> split_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> split_words(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// [i][j]: the length of the longest common subsequence of a[i...] and b[j...].
using Lengths = std::vector<std::vector<std::size_t>>;

Lengths common_lengths(const std::vector<std::string>& a, const std::vector<std::string>& b) {
  Lengths length(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = a.size(); i-- > 0;) {
    for (std::size_t j = b.size(); j-- > 0;) {
      length[i][j] =
          a[i] == b[j] ? length[i + 1][j + 1] + 1 : std::max(length[i + 1][j], length[i][j + 1]);
    }
  }
  return length;
}

// The lines that differ between two texts, marked "- " and "+ ". Common lines are left out, except
// the heading.
std::string changed_lines(const std::string& before, const std::string& after) {
  const std::vector<std::string> a = split_lines(before), b = split_lines(after);
  const Lengths length = common_lengths(a, b);
  std::string text;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    if (i < a.size() && j < b.size() && a[i] == b[j]) {
      const bool heading = i == 0 && j == 0;
      if (heading) text += "  " + a[i] + "\n";
      ++i, ++j;
    } else if (j == b.size() || (i < a.size() && length[i + 1][j] >= length[i][j + 1])) {
      text += "- " + a[i++] + "\n";
    } else {
      text += "+ " + b[j++] + "\n";
    }
  }
  return text;
}

// ---- the prompt ----

class StepPrompt {
public:
  StepPrompt(const Scene& scene, PromptState staged, bool bits)
      : scene_(scene), bits_(bits), state_(std::move(staged)), initial_choice_(state_.choice) {}

  void run(LineReader& lines) {
    fmt::print("{}\n", kHelp);
    show();
    while (const auto line = lines.read(prompt())) {
      if (!run_command(*line)) return;
    }
    fmt::print("\n");
  }

private:
  const std::vector<StageText>& stages() const { return state_.stages; }

  std::string prompt() const {
    return fmt::format("{} {}/{}> ", stages()[stage_index_].name, stage_index_ + 1,
                       stages().size());
  }

  void show() const { fmt::print("{}", stages()[stage_index_].text); }

  // Executes a command. Returns false if the command ends the prompt.
  bool run_command(const std::string& line) {
    const std::vector<std::string> words = split_words(line);
    const std::string command = words.empty() ? "n" : words.front();
    if (command == "q" || command == "quit") return false;
    if (command.starts_with("--")) return change(state_.choice, words), true;
    if (command == "triangle" || command == "pick" || command == "vertex")
      return change_target(words), true;
    if (command == "reset") return change(initial_choice_, {}), true;
    if (command == "all") return show_all(), true;
    if (command == "help") return fmt::print("{}", kHelp), true;
    if (command == "n" || command == "next")
      return go_to_stage(stage_index_ + 1, "this is the last stage"), true;
    if (command == "p" || command == "b" || command == "back")
      return go_to_stage(stage_index_ - 1, "this is the first stage"), true;
    go_to_named_stage(command);
    return true;
  }

  void go_to_stage(std::size_t stage, const char* refusal) {
    if (stage >= stages().size()) {
      fmt::print("  {}\n", refusal);
      return;
    }
    stage_index_ = stage;
    show();
  }

  void go_to_named_stage(const std::string& name) {
    for (std::size_t i = 0; i < stages().size(); ++i) {
      if (stages()[i].name == name) return go_to_stage(i, "");
    }
    fmt::print("  there is no stage or command of this name\n{}", kHelp);
  }

  void show_all() const {
    for (const StageText& stage : stages()) fmt::print("{}\n", stage.text);
  }

  // Replaces a command such as "triangle 7" by the option "--triangle 7" and applies it.
  void change_target(std::vector<std::string> words) {
    if (words.size() != 2) {
      fmt::print("  {} needs one more word: {}\n", words[0],
                 words[0] == "triangle" ? "a number"
                 : words[0] == "pick"   ? "X,Y"
                                        : "0, 1, 2 or all");
      return;
    }
    words[0] = "--" + words[0];
    change(state_.choice, words);
  }

  // Applies a change. For another triangle the stage is shown whole; for another picture, only the
  // lines that change.
  void change(const StepChoice& choice, const std::vector<std::string>& more) {
    Result<PromptState> staged = apply_options(scene_, bits_, choice, more);
    if (!staged) {
      fmt::print("  {}\n", staged.error().message());
      return;
    }
    const StepTarget before = state_.choice.target;
    const bool same = before == staged->choice.target;
    if (same) show_changes(stages(), staged->stages);
    state_ = std::move(*staged);
    stage_index_ = std::min(stage_index_, stages().size() - 1);
    if (same) return;
    if (before.triangle != state_.choice.target.triangle) {
      fmt::print("  triangle {}\n", state_.choice.target.triangle);
    }
    show();
  }

  static void show_changes(const std::vector<StageText>& from, const std::vector<StageText>& to) {
    for (std::size_t i = 0; i < std::max(from.size(), to.size()); ++i) {
      const std::string before = i < from.size() ? from[i].text : "";
      const std::string after = i < to.size() ? to[i].text : "";
      if (before != after) fmt::print("{}", changed_lines(before, after));
    }
  }

  const Scene& scene_;
  const bool bits_;
  PromptState state_;
  const StepChoice initial_choice_;
  std::size_t stage_index_ = 0;
};

}  // namespace

void run_step_prompt(const Scene& scene, const StepChoice& choice, std::vector<StageText> stages,
                     bool bits, bool terminal) {
  const OptionWords options = prompt_options();
  const auto complete = [&options](const std::vector<std::string>& words) {
    return step_candidates(words, options);
  };
  const auto lines = terminal ? make_terminal_reader(complete) : make_stream_reader(std::cin);
  StepPrompt(scene, {choice, std::move(stages)}, bits).run(*lines);
}

}  // namespace glassbox::app
