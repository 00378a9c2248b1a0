#include "app/study/svg.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "app/report/output.h"
#include "app/study/gnuplot.h"
#include "study/experiment/pareto.h"

namespace glassbox::app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRemedy = "apt install gnuplot-nox, or leave --svg out";

// A directory that goes with whoever made it.
class Scratch {
public:
  Scratch() {
    std::string name = (fs::temp_directory_path() / "glassbox-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  bool exists() const { return !path_.empty(); }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

private:
  fs::path path_;
};

// gnuplot with a file of commands; its exit code, or none where there is no gnuplot.
std::optional<int> run_gnuplot(std::string argument) {
  std::string name = "gnuplot";
  char* words[] = {name.data(), argument.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, name.c_str(), nullptr, nullptr, words, environ) != 0)
    return std::nullopt;
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// By way of a file of our own, so that a chart in the directory is whole or not there.
Result<void> draw(const Scratch& scratch, const std::string& commands, const std::string& drawn,
                  const std::string& target) {
  const std::string script = scratch.file("commands");
  std::ofstream(script, std::ios::binary) << commands;
  const auto code = run_gnuplot(script);
  const std::string svg = text_of(drawn);
  if (code != 0 || svg.empty()) {
    return tl::unexpected(
        Error{target, "", "gnuplot could not draw it (what it says stands above)", kRemedy});
  }
  return write_text(target, svg);
}

}  // namespace

Result<void> check_gnuplot() {
  if (run_gnuplot("/dev/null")) return {};
  return fail("--svg", "gnuplot draws these charts, and it is not installed", kRemedy);
}

Result<int> write_svg_charts(const study::StudyResults& results, const std::string& directory) {
  const Scratch scratch;
  if (!scratch.exists()) {
    return fail("--svg", "no temporary directory can be made",
                "set TMPDIR to one that can be written");
  }
  const std::string drawn = scratch.file("chart.svg");
  int written = 0;
  for (const study::ExperimentResult& each : results.experiments) {
    const std::string stem = directory + "/" + each.id;
    if (!study::thread_counts(each).empty()) {
      const auto done = draw(scratch, time_chart_commands(each, drawn), drawn, stem + "-time.svg");
      if (!done) return tl::unexpected(done.error());
      ++written;
    }
    const auto done = draw(scratch, axis_chart_commands(each, drawn), drawn, stem + "-axis.svg");
    if (!done) return tl::unexpected(done.error());
    ++written;
  }
  return written;
}

}  // namespace glassbox::app
