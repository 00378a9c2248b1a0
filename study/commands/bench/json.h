// The benchmark's results as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "study/commands/bench/report.h"

namespace glassbox::study {

// {machine, compiler, target, results: [{scene, threads, ms, peer, peer_ms, ratio, ...}], scaling:
// [...]}, described in docs/benchmark.md.
nlohmann::ordered_json bench_json(const BenchReport& report);

}  // namespace glassbox::study
