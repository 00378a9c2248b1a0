// glassbox help [COMMAND...]: prints the same as --help after the command.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace glassbox::app {

class HelpCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run(const CLI::App& program) const;

  std::vector<std::string> words_;
};

}  // namespace glassbox::app
