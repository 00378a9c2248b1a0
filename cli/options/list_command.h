// A subcommand `list`, which prints the items there are, as text and as JSON.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/cli_fwd.h"

namespace glassbox {

class ListCommand {
public:
  ListCommand(const char* help, std::string (*text)(), nlohmann::ordered_json (*json)())
      : help_(help), text_(text), json_(json) {}
  void add_to(CLI::App& parent, int& exit_code);

private:
  int run() const;

  const char* help_;
  std::string (*text_)();
  nlohmann::ordered_json (*json_)();
  std::optional<std::string> json_output_;
};

}  // namespace glassbox
