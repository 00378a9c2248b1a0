// glassbox completion SHELL: prints the script that makes a shell complete command lines.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace glassbox {

class CompletionCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run(const CLI::App& program) const;

  std::string shell_;
};

}  // namespace glassbox
