// Writes machine-readable results to standard output or to a file, which is written completely or
// not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/base/error.h>

namespace glassbox {

// Writes JSON. `target` is a path, or "-" for standard output.
Result<void> write_json(const std::string& target, const nlohmann::ordered_json& json);

// Writes the text unchanged. `target` is a path, or "-" for standard output.
Result<void> write_text(const std::string& target, const std::string& text);

// Writes the text; returns the error if there is an error instead of a text.
Result<void> write_text_result(const std::string& path, const Result<std::string>& text);

// The absolute path without links and dots, which is the same for two names of one file. The file
// need not exist.
std::filesystem::path whole_path(const std::string& path);

// An error if `path` does not end in `extension` (".pfm"), in upper or lower case.
Result<void> check_extension(const std::string& path, const std::string& extension);

// The checks that are possible before a long run: an error if the directory of one of the paths
// does not exist, or if two of them are the same file.
Result<void> check_outputs(const std::vector<std::string>& paths);

// An error if two outputs are the same file, or if an output is one of the `inputs`. The files may
// be in a directory that does not exist yet.
Result<void> check_distinct(const std::vector<std::string>& outputs,
                            const std::vector<std::string>& inputs = {});

// Checks a report's outputs before a long run: its page, which must be an .html file, and its data,
// which may go to standard output.
Result<void> check_report_outputs(const std::optional<std::string>& page,
                                  const std::optional<std::string>& data);

// The files that a command will write: each is added by a call, and all are checked before a long
// run. A file without a path is not written.
class Outputs {
public:
  // Adds a file with this extension (".pfm"); empty: any extension.
  Outputs& file(const std::optional<std::string>& path, const std::string& extension = {});
  // Adds two files, or none if the first path is empty.
  Outputs& files(const std::pair<std::string, std::string>& paths, const std::string& extension);
  // Adds a picture, in a format that write_image can write.
  Outputs& picture(const std::optional<std::string>& path);
  // Adds a file of data. "-" is standard output, which needs no check.
  Outputs& data(const std::optional<std::string>& path);
  // Returns the error about the first path with a wrong extension; if there is none, what
  // check_outputs returns.
  Result<void> check() const;
  // The paths that were added.
  const std::vector<std::string>& paths() const { return paths_; }

private:
  void add(const std::string& path, const Result<void>& legal);

  std::vector<std::string> paths_;
  Result<void> legal_;
};

}  // namespace glassbox
