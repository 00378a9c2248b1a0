// Which pictures of two directories are approved: those whose names match a pattern or are in a
// list.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glassbox/base/error.h>
#include <glassbox/compare/pictures/comparison.h>

namespace glassbox {

struct ApprovalRequest {
  // Patterns of a shell: * and ? stand for any characters, / among them, and [a-c] for one of a
  // set. A picture matches by its whole name, or by the part behind the last /.
  std::vector<std::string> patterns;
  std::vector<std::string> names;  // Comparison::name
};

// The names in a list of one name a line: empty lines, and lines that begin with # are skipped, as
// is "./" at the beginning of a name. An error if there is no name at all.
Result<std::vector<std::string>> parse_approval_list(const std::string& text);

struct ApprovalChoice {
  std::vector<std::size_t> chosen;  // indices of comparisons, in ascending order
  // Sentences about patterns that match no picture and names that are no picture's.
  std::vector<std::string> unknown;
};

// The comparisons that were asked for. Those that are the same or missing are among them.
ApprovalChoice choose_for_approval(std::span<const Comparison> comparisons,
                                   const ApprovalRequest& request);

}  // namespace glassbox
