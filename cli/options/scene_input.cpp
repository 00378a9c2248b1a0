#include "cli/options/scene_input.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include "cli/report/progress.h"

#include <glassbox/mesh/formats/load.h>
#include <glassbox/mesh/formats/load_memory.h>

namespace glassbox {

namespace {

constexpr const char* kStandardInput = "standard input";

}  // namespace

Result<std::vector<std::byte>> read_standard_input(std::uint64_t max_bytes) {
  if (::isatty(STDIN_FILENO) == 1) {
    return fail("", "is a terminal", "redirect a file to it: glassbox render - < duck.glb");
  }
  constexpr std::size_t kBlock = std::size_t(1) << 20;
  std::vector<std::byte> bytes;
  while (bytes.size() <= max_bytes) {
    const std::size_t size = bytes.size();
    bytes.resize(size + kBlock);
    const ssize_t n = ::read(STDIN_FILENO, bytes.data() + size, kBlock);
    bytes.resize(size + std::size_t(n > 0 ? n : 0));
    if (n == 0) return bytes;
    if (n < 0 && errno != EINTR) {
      return fail("", "cannot be read: " + std::string(std::strerror(errno)),
                  "check the program or file that it comes from");
    }
  }
  return fail("", "has more than " + std::to_string(max_bytes) + " bytes, the most that is read",
              "use a smaller file (in the library: LoadLimits::max_file_bytes)");
}

Result<SceneAndBytes> load_scene_and_bytes(const std::string& word, const LoadLimits& limits) {
  if (word != "-") {
    return load_scene(word, limits).map([](Scene scene) {
      return SceneAndBytes{std::move(scene), {}};
    });
  }
  return read_standard_input(limits.max_file_bytes)
      .and_then([&](std::vector<std::byte> bytes) {
        return load_scene_memory(bytes, limits).map([&](Scene scene) {
          return SceneAndBytes{std::move(scene), std::move(bytes)};
        });
      })
      .map_error([](Error error) {
        error.file = kStandardInput;
        return error;
      });
}

Result<Scene> load_scene_argument(const std::string& word, const LoadLimits& limits) {
  return load_scene_and_bytes(word, limits).map([](SceneAndBytes loaded) {
    return std::move(loaded.scene);
  });
}

Result<Scene> load_scene_argument(const std::string& word, Progress& progress,
                                  const LoadLimits& limits) {
  progress.phase("loading " + scene_title(word));
  return load_scene_argument(word, limits).map([&](Scene scene) {
    for (const std::string& warning : scene.warnings) progress.print_line("warning: " + warning);
    return scene;
  });
}

std::string scene_title(const std::string& word) {
  return word == "-" ? kStandardInput : word;
}

std::string scene_stem(const std::string& word) {
  if (word == "-") return "stdin";
  return std::filesystem::path(word.substr(0, word.find(':'))).stem().string();
}

}  // namespace glassbox
