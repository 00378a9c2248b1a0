#include "study/experiment/collect.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "study/experiment/result_file.h"

namespace glassbox::study {

namespace {

tl::unexpected<Error> refused(const PartFile& part, const std::string& cause,
                              const std::string& remedy) {
  return tl::unexpected(Error{part.path, "", cause, remedy});
}

// Returns the origin (machine, compiler and so on) without the fields that may differ between the
// parts of one run. With `any_machine` the machine may differ, too.
Origin shared(Origin origin, bool any_machine) {
  origin.part = 1;
  if (any_machine) {
    origin.machine.clear(), origin.target.clear(), origin.caches.clear();
    origin.threads = 1;
  }
  return origin;
}

// Restores the order of the experiments. Part number k of N has every N-th experiment from number k
// on: long experiments are neighbours in the list, so this spreads them over the parts.
std::vector<ExperimentResult> in_order(const std::vector<const PartFile*>& parts) {
  std::vector<ExperimentResult> all;
  for (std::size_t round = 0;; ++round) {
    const std::size_t before = all.size();
    for (const PartFile* part : parts) {
      const auto& measured = part->results.experiments;
      if (round < measured.size()) all.push_back(measured[round]);
    }
    if (all.size() == before) return all;
  }
}

}  // namespace

Result<StudyResults> join_parts(std::span<const PartFile> parts, bool any_machine) {
  if (parts.empty())
    return fail("", "there are no parts to join",
                "measure the parts with study run --part, such as --part 1/4");
  const Origin& first = parts.front().results.origin;
  std::vector<const PartFile*> by_number(std::size_t(first.parts), nullptr);
  StudyResults joined{first, {}};
  std::set<std::string> machines, measured;
  for (const PartFile& part : parts) {
    const Origin& origin = part.results.origin;
    if (const std::string differs =
            first_difference(shared(first, any_machine), shared(origin, any_machine));
        !differs.empty()) {
      return refused(part,
                     "was measured in another run than " + parts.front().path + ": " + differs,
                     "join parts of one run; --any-machine also joins parts of different machines");
    }
    const PartFile*& place = by_number[std::size_t(origin.part) - 1];
    if (place != nullptr) {
      return refused(part,
                     fmt::format("is part {}, but {} is the same part", origin.part, place->path),
                     "remove one of them");
    }
    place = &part;
    for (const ExperimentResult& each : part.results.experiments) {
      if (measured.insert(each.id).second) continue;
      return refused(part, "has " + each.id + ", which another part contains too",
                     "measure all parts with the same experiments");
    }
    machines.insert(origin.machine);
    joined.origin.threads = std::max(joined.origin.threads, origin.threads);
  }
  const auto missing = std::ranges::find(by_number, nullptr);
  if (missing != by_number.end()) {
    return fail(
        "", fmt::format("part {}/{} is missing", missing - by_number.begin() + 1, first.parts),
        "measure it with study run --part and the same other options as for the other parts");
  }
  joined.origin.part = joined.origin.parts = 1;
  joined.origin.machine = fmt::format("{}", fmt::join(machines, "; "));
  joined.experiments = in_order(by_number);
  return joined;
}

}  // namespace glassbox::study
