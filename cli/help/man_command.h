// glassbox man: prints the manual page, for man(1).
#pragma once

namespace CLI {
class App;
}

namespace glassbox {

class ManCommand {
public:
  void add_to(CLI::App& app, int& exit_code);
};

}  // namespace glassbox
