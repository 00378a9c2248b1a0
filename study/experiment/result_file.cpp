#include "study/experiment/result_file.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <span>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glassbox/images/atomic_file.h>
#include <glassbox/images/read.h>

#include "study/experiment/results_json.h"

namespace glassbox::study {

namespace {

tl::unexpected<Error> in_file(const std::string& path, Error error) {
  error.file = path;
  return tl::unexpected(std::move(error));
}

// Returns for example "the machine is 'A' in the file and 'B' now"; empty if both are the same.
std::string difference(const char* what, const std::string& there, const std::string& here) {
  if (there == here) return {};
  return fmt::format("the {} is '{}' in the file, but '{}' now", what, there, here);
}

}  // namespace

std::string first_difference(const Origin& there, const Origin& here) {
  const auto part = [](const Origin& o) { return fmt::format("{}/{}", o.part, o.parts); };
  const auto effort = [](Effort e) { return e == Effort::kQuick ? "quick" : "full"; };
  for (const std::string& found : {difference("version", there.version, here.version),
                                   difference("machine", there.machine, here.machine),
                                   difference("instruction set", there.target, here.target),
                                   difference("list of caches", there.caches, here.caches),
                                   difference("effort", effort(there.effort), effort(here.effort)),
                                   difference("compiler", there.compiler, here.compiler),
                                   difference("list of compiler flags", there.flags, here.flags),
                                   difference("number of threads", fmt::to_string(there.threads),
                                              fmt::to_string(here.threads)),
                                   difference("part", part(there), part(here))}) {
    if (!found.empty()) return found;
  }
  return {};
}

Result<StudyResults> read_results(const std::string& path) {
  constexpr std::uint64_t kMaxBytes = std::uint64_t(1) << 28;
  const auto bytes = read_file(path, kMaxBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto json = nlohmann::ordered_json::parse(*bytes, nullptr, false);
  auto results = results_of(json);
  if (!results) return in_file(path, results.error());
  return results;
}

Result<void> write_results(const std::string& path, const StudyResults& results) {
  const std::string text = results_json(results).dump(2) + "\n";
  return write_file(path, std::as_bytes(std::span(text)));
}

Result<StudyResults> resume_results(const std::string& path, const Origin& origin) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return StudyResults{origin, {}};
  auto results = read_results(path);
  if (!results) return results;
  if (const std::string differs = first_difference(results->origin, origin); !differs.empty()) {
    return in_file(path, {{},
                          "",
                          "was measured differently: " + differs,
                          "use the options of the run that made the file, or name another file"});
  }
  return results;
}

const ExperimentResult* find_result(const StudyResults& results, const std::string& id) {
  const auto found = std::ranges::find(results.experiments, id, &ExperimentResult::id);
  return found == results.experiments.end() ? nullptr : &*found;
}

}  // namespace glassbox::study
