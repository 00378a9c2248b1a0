#include "app/step/prompt.h"

#include <histedit.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <iostream>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace glassbox::app {

namespace {

class StreamLineReader : public LineReader {
public:
  explicit StreamLineReader(std::istream& in) : in_(in) {}
  std::optional<std::string> read(const std::string& prompt) override {
    fmt::print("{}", prompt);
    std::fflush(stdout);
    std::string line;
    if (!std::getline(in_, line)) return {};
    return line;
  }

private:
  std::istream& in_;
};

// The words before the cursor; the last one is empty after a blank.
std::vector<std::string> words_before(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; in >> word;) words.push_back(word);
  if (text.empty() || text.back() == ' ') words.emplace_back();
  return words;
}

std::string common_prefix(const std::vector<std::string>& words) {
  std::string common = words.front();
  for (const std::string& word : words) {
    const auto end = std::mismatch(common.begin(), common.end(), word.begin(), word.end()).first;
    common.erase(end, common.end());
  }
  return common;
}

class TerminalLineReader : public LineReader {
public:
  explicit TerminalLineReader(Candidates candidates)
      : candidates_(std::move(candidates)),
        history_(history_init()),
        edit_(el_init("glassbox", stdin, stdout, stderr)) {
    constexpr int kRemembered = 1000;
    HistEvent event;
    history(history_, &event, H_SETSIZE, kRemembered);
    history(history_, &event, H_SETUNIQUE, 1);
    el_set(edit_, EL_CLIENTDATA, this);
    el_set(edit_, EL_PROMPT, &TerminalLineReader::prompt_of);
    el_set(edit_, EL_EDITOR, "emacs");
    el_set(edit_, EL_HIST, history, history_);
    el_set(edit_, EL_SIGNAL, 1);  // Control-C restores the terminal
    // el_set, the function for narrow characters, would copy these words as wide characters and
    // never free the copies.
    el_wset(edit_, EL_ADDFN, L"complete", L"completes a word", &TerminalLineReader::complete_word);
    el_set(edit_, EL_BIND, "^I", "complete", nullptr);
    el_set(edit_, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    // While no prompt is shown, the terminal itself edits the typed line and turns Control-D (end
    // of input) into NUL. So NUL does here what Control-D does.
    el_set(edit_, EL_BIND, "^@", "em-delete-or-list", nullptr);
  }
  ~TerminalLineReader() override {
    el_end(edit_);
    history_end(history_);
  }
  TerminalLineReader(const TerminalLineReader&) = delete;
  TerminalLineReader& operator=(const TerminalLineReader&) = delete;

  std::optional<std::string> read(const std::string& prompt) override {
    prompt_ = prompt;
    std::fflush(stdout);
    int count = 0;
    const char* text = el_gets(edit_, &count);
    if (text == nullptr || count <= 0) return {};
    std::string line(text, std::size_t(count));
    while (line.ends_with('\n') || line.ends_with('\r')) line.pop_back();
    HistEvent event;
    if (line.find_first_not_of(' ') != std::string::npos) {
      history(history_, &event, H_ENTER, line.c_str());
    }
    return line;
  }

private:
  static TerminalLineReader& reader_of(EditLine* edit) {
    void* self = nullptr;
    el_get(edit, EL_CLIENTDATA, &self);
    return *static_cast<TerminalLineReader*>(self);
  }
  static char* prompt_of(EditLine* edit) { return reader_of(edit).prompt_.data(); }
  static unsigned char complete_word(EditLine* edit, wint_t) { return reader_of(edit).complete(); }

  unsigned char complete() {
    const LineInfo* line = el_line(edit_);
    const std::vector<std::string> words = words_before({line->buffer, line->cursor});
    const std::string& begun = words.back();
    std::vector<std::string> fitting;
    for (const std::string& word : candidates_(words)) {
      if (word.starts_with(begun)) fitting.push_back(word);
    }
    if (fitting.empty()) return CC_ERROR;
    const std::string more =
        common_prefix(fitting).substr(begun.size()) + (fitting.size() == 1 ? " " : "");
    if (!more.empty()) return el_insertstr(edit_, more.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
    fmt::print("\n ");
    for (const std::string& word : fitting) fmt::print(" {}", word);
    fmt::print("\n");
    std::fflush(stdout);
    return CC_REDISPLAY;
  }

  Candidates candidates_;
  History* history_;
  EditLine* edit_;
  std::string prompt_;
};

}  // namespace

std::unique_ptr<LineReader> make_stream_reader(std::istream& in) {
  return std::make_unique<StreamLineReader>(in);
}

std::unique_ptr<LineReader> make_terminal_reader(Candidates candidates) {
  const char* name = std::getenv("TERM");
  const std::string terminal = name == nullptr ? "" : name;
  if (terminal.empty() || terminal == "dumb") return make_stream_reader(std::cin);
  return std::make_unique<TerminalLineReader>(std::move(candidates));
}

}  // namespace glassbox::app
