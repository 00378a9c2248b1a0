#include "app/step/stepper.h"

#include <algorithm>
#include <cstdio>
#include <sstream>

#include <fmt/format.h>

namespace glassbox::app {

namespace {

constexpr const char* kHelp =
    "  n, Enter    next stage            p, b        back\n"
    "  NAME        jump to a stage: object, world, eye, clip, clipping, ndc, screen, setup, "
    "fragments\n"
    "  all         every stage from the first\n"
    "  --eye 1,2,3 --fov 60 ...          other picture options; shows what they change, stage by "
    "stage\n"
    "  reset       the options as they were at the start\n"
    "  q           quit\n";

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

// How long a common subsequence of a[i...] and b[j...] can be.
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

class Stepper {
public:
  Stepper(std::vector<StageText> stages, std::vector<std::string> words, const Restage& restage)
      : stages_(std::move(stages)),
        words_(std::move(words)),
        first_words_(words_),
        restage_(restage) {}

  void run(std::istream& in) {
    fmt::print("{}\n{}", kHelp, stages_[at_].text);
    for (std::string line; prompt(), std::getline(in, line);) {
      if (!obey(line)) return;
    }
    fmt::print("\n");
  }

private:
  void prompt() const {
    fmt::print("{} {}/{}> ", stages_[at_].name, at_ + 1, stages_.size());
    std::fflush(stdout);
  }

  void show() const { fmt::print("{}", stages_[at_].text); }

  // False: it was the last command.
  bool obey(const std::string& line) {
    const std::vector<std::string> words = split_words(line);
    const std::string command = words.empty() ? "n" : words.front();
    if (command == "q" || command == "quit") return false;
    if (command.starts_with("--")) return change(words), true;
    if (command == "reset") return restart(), true;
    if (command == "all") return show_all(), true;
    if (command == "n" || command == "next") return go(at_ + 1, "this is the last stage"), true;
    if (command == "p" || command == "b" || command == "back")
      return go(at_ - 1, "this is the first stage"), true;
    jump(command);
    return true;
  }

  void go(std::size_t stage, const char* refusal) {
    if (stage >= stages_.size()) {
      fmt::print("  {}\n", refusal);
      return;
    }
    at_ = stage;
    show();
  }

  void jump(const std::string& name) {
    for (std::size_t i = 0; i < stages_.size(); ++i) {
      if (stages_[i].name == name) return go(i, "");
    }
    fmt::print("{}{}", name == "help" ? "" : "  there is no stage or command of this name\n",
               kHelp);
  }

  void show_all() const {
    for (const StageText& stage : stages_) fmt::print("{}\n", stage.text);
  }

  void change(const std::vector<std::string>& more) {
    std::vector<std::string> words = words_;
    words.insert(words.end(), more.begin(), more.end());
    replace(words);
  }

  void restart() { replace(first_words_); }

  void replace(const std::vector<std::string>& words) {
    const auto stages = restage_(words);
    if (!stages) {
      fmt::print("  {}\n", stages.error().message());
      return;
    }
    const std::size_t count = std::max(stages_.size(), stages->size());
    for (std::size_t i = 0; i < count; ++i) {
      const std::string before = i < stages_.size() ? stages_[i].text : "";
      const std::string after = i < stages->size() ? (*stages)[i].text : "";
      if (before != after) fmt::print("{}", changed_lines(before, after));
    }
    stages_ = *stages;
    words_ = words;
    at_ = std::min(at_, stages_.size() - 1);
  }

  std::vector<StageText> stages_;
  std::vector<std::string> words_;
  const std::vector<std::string> first_words_;
  const Restage& restage_;
  std::size_t at_ = 0;
};

}  // namespace

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

void step_by_hand(std::istream& in, std::vector<StageText> stages, std::vector<std::string> words,
                  const Restage& restage) {
  Stepper(std::move(stages), std::move(words), restage).run(in);
}

}  // namespace glassbox::app
