// Writes machine-readable results to standard output or to a file, which is written completely or
// not at all.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/base/error.h>

namespace glassbox {

// Writes JSON. `target` is a path, or "-" for standard output.
Result<void> write_json(const std::string& target, const nlohmann::ordered_json& json);

// Writes the text unchanged to such a target.
Result<void> write_text(const std::string& target, const std::string& text);

// Writes what could be made, and otherwise says why it could not.
Result<void> write_text_result(const std::string& path, const Result<std::string>& text);

// An error if `path` does not end in `extension` (".pfm"), in upper or lower case.
Result<void> check_extension(const std::string& path, const std::string& extension);

// The checks that are possible before a long run: an error if the directory of one of the paths
// does not exist, or if two of them are the same file.
Result<void> check_outputs(const std::vector<std::string>& paths);

// An error if two outputs are the same file, or if one of them is one of `inputs`. The files may be
// in a directory that is made later.
Result<void> check_distinct(const std::vector<std::string>& outputs,
                            const std::vector<std::string>& inputs = {});

// Checks a report's outputs before a long run: its page, which must be an .html file, and its data,
// which may go to standard output.
Result<void> check_report_outputs(const std::optional<std::string>& page,
                                  const std::optional<std::string>& data);

// The files that a command will write: they are declared one after the other, and checked before a
// long run. A file without a path is not written.
class Outputs {
public:
  // A file with this extension (".pfm"); empty: any.
  Outputs& file(const std::optional<std::string>& path, const std::string& extension = {});
  // Both of a pair, or none.
  Outputs& files(const std::pair<std::string, std::string>& paths, const std::string& extension);
  // A picture, of a kind that write_image writes.
  Outputs& picture(const std::optional<std::string>& path);
  // Data, which may go to standard output ("-").
  Outputs& data(const std::optional<std::string>& path);
  // What is wrong with the first name that is wrong; otherwise as check_outputs.
  Result<void> check() const;

private:
  void add(const std::string& path, const Result<void>& legal);

  std::vector<std::string> paths_;
  Result<void> legal_;
};

}  // namespace glassbox
