// Reads the JSON data (the manifest) of an HTML page.
#pragma once

#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

namespace glassbox::test {

inline nlohmann::json manifest_of(const std::string& page) {
  const std::string start = "<script type=\"application/json\" id=\"manifest\">";
  const std::size_t first = page.find(start);
  if (first == std::string::npos) throw std::runtime_error("the page has no manifest");
  const std::size_t from = first + start.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

}  // namespace glassbox::test
