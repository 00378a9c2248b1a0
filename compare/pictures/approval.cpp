#include <glassbox/compare/pictures/approval.h>

#include <fnmatch.h>

#include <map>
#include <sstream>

#include <glassbox/base/printable.h>
#include <glassbox/base/utf8.h>

namespace glassbox {
namespace {

bool matches(const std::string& pattern, const std::string& name) {
  const auto fits = [&](const std::string& text) {
    return ::fnmatch(pattern.c_str(), text.c_str(), 0) == 0;
  };
  return fits(name) || fits(name.substr(name.rfind('/') + 1));
}

}  // namespace

Result<std::vector<std::string>> parse_approval_list(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream lines{std::string(without_byte_order_mark(text))};
  for (std::string line; std::getline(lines, line);) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    names.push_back(line.starts_with("./") ? line.substr(2) : line);
  }
  if (!names.empty()) return names;
  return fail("", "there is no name of a picture in the list",
              "write one name a line, as --json has it, and ./ before a name that begins with #");
}

ApprovalChoice choose_for_approval(std::span<const Comparison> comparisons,
                                   const ApprovalRequest& request) {
  std::vector<bool> is_chosen(comparisons.size());
  ApprovalChoice choice;
  for (const std::string& pattern : request.patterns) {
    bool any = false;
    for (std::size_t i = 0; i < comparisons.size(); ++i) {
      if (!matches(pattern, comparisons[i].name)) continue;
      is_chosen[i] = any = true;
    }
    if (!any) choice.unknown.push_back("no picture's name matches " + in_quotes(pattern));
  }
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < comparisons.size(); ++i) places[comparisons[i].name] = i;
  for (const std::string& name : request.names) {
    if (const auto place = places.find(name); place != places.end()) {
      is_chosen[place->second] = true;
    } else {
      choice.unknown.push_back("no picture has the name " + in_quotes(name));
    }
  }
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    if (is_chosen[i]) choice.chosen.push_back(i);
  }
  return choice;
}

}  // namespace glassbox
