// glassbox trace SCENE -o run.json|run.npz: writes a whole run as data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/picture_options.h"
#include "cli/report/progress.h"

#include <glassbox/render/trace/arrays.h>
#include <glassbox/render/trace/tracer.h>

namespace CLI {
class App;
}

namespace glassbox::app {

class TraceCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  void add_filter(CLI::App& command);
  int run();
  bool is_json() const;
  Result<void> check_words() const;
  Result<void> check_filter(const Scene& scene) const;
  Result<void> check_size(std::uint64_t bytes, const TraceCounts& counts, Progress& progress) const;
  // These return a sentence about what was written.
  Result<std::string> write_json(const Scene& scene, const View& view, Progress& progress);
  Result<std::string> write_npz(const Scene& scene, const View& view, Progress& progress);

  std::string scene_;
  std::string output_;
  PictureOptions picture_;
  TraceFilter filter_;
  std::vector<std::string> arrays_;
  std::uint32_t max_megabytes_ = 500;
};

}  // namespace glassbox::app
