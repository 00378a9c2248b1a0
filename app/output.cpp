#include "app/output.h"

#include <cstdio>
#include <span>

#include <fmt/format.h>

#include <glassbox/images/atomic_file.h>

namespace glassbox::app {

Result<void> write_json(const std::string& target, const nlohmann::ordered_json& json) {
  // Names come from files and may be anything but UTF-8; they are written with replacement characters then.
  const std::string text =
      json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (target == "-") {
    fmt::print("{}", text);
    return {};
  }
  return write_file(target, std::as_bytes(std::span(text)));
}

}  // namespace glassbox::app
