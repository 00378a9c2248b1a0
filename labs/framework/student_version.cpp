#include "labs/framework/student_version.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "labs/framework/sources.h"
#include "labs/framework/strip_solution.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kCall = "hidden_check(";

// The position after the string literal that begins at `at`.
std::size_t after_string(std::string_view text, std::size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return std::min(at + 1, text.size());
}

struct Call {
  std::vector<std::string> strings;  // its arguments that are string literals
  std::size_t end = std::string::npos;
};

// Reads a call whose arguments begin at `at`.
Call read_call(std::string_view text, std::size_t at) {
  Call call;
  int depth = 1;
  while (at < text.size()) {
    if (text[at] == '"') {
      const std::size_t end = after_string(text, at);
      call.strings.emplace_back(text.substr(at, end - at));
      at = end;
      continue;
    }
    if (text[at] == '(') ++depth;
    if (text[at] == ')' && --depth == 0) {
      call.end = at + 1;
      return call;
    }
    ++at;
  }
  return call;
}

// Replaces each hidden_check("a name", "5.1", ...) by hidden_check_placeholder("5.1").
Result<std::string> without_hidden_checks(const std::string& name, const std::string& text) {
  std::string kept;
  std::size_t from = 0;
  for (std::size_t at = text.find(kCall); at != std::string::npos; at = text.find(kCall, from)) {
    const Call call = read_call(text, at + kCall.size());
    if (call.end == std::string::npos || call.strings.size() < 2) {
      const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n');
      return tl::unexpected(
          Error{name, fmt::format("line {}", line), "a hidden check has no task",
                "write hidden_check(\"NAME\", \"TASK\", ...) with both in quotes"});
    }
    kept += text.substr(from, at - from) + "hidden_check_placeholder(" + call.strings[1] + ")";
    from = call.end;
  }
  return kept + text.substr(from);
}

bool is_code(const fs::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".h";
}

Result<std::vector<fs::path>> files_below(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    if (at->is_regular_file(error)) files.push_back(at->path());
  }
  if (error) return fail(folder.string(), error.message(), "check the folder's permissions");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

bool is_lab_path(const fs::path& path) {
  auto part = path.begin();
  if (part == path.end() || *part != "labs" || ++part == path.end()) return false;
  const std::string name = part->string();
  return name.size() > 3 && std::isdigit(static_cast<unsigned char>(name[0])) != 0 &&
         std::isdigit(static_cast<unsigned char>(name[1])) != 0 && name[2] == '-';
}

Result<std::optional<std::string>> student_version(const std::string& name,
                                                   const std::string& text) {
  const fs::path file(name);
  if (file.filename() == "faults.json") return std::optional<std::string>();
  if (!is_code(file)) return std::optional(text);
  auto stripped = strip_solution(text, name);
  if (stripped) stripped = without_hidden_checks(name, *stripped);
  if (!stripped) return tl::unexpected(stripped.error());
  return std::optional(std::move(*stripped));
}

Result<void> copy_for_students(const fs::path& labs, const fs::path& to) {
  const auto files = files_below(labs);
  if (!files) return tl::unexpected(files.error());
  for (const fs::path& file : *files) {
    const fs::path relative = file.lexically_relative(labs);
    const auto text = read_text_file(file);
    if (!text) return tl::unexpected(text.error());
    Result<std::optional<std::string>> kept = std::optional(*text);
    if (is_lab_path("labs" / relative)) kept = student_version(relative.generic_string(), *text);
    if (!kept) return tl::unexpected(kept.error());
    if (!*kept) continue;
    if (const auto written = write_if_changed(to / relative, **kept); !written) return written;
  }
  return {};
}

}  // namespace glassbox::labs
