// The results measured by `glassbox bench`.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "study/bench/measure.h"
#include "study/bench/memory_time_limit.h"
#include "study/bench/scaling.h"

namespace glassbox::study {

struct BenchReport {
  std::string machine, compiler, engine, target;
  int width = 0, height = 0, frames = 0;
  std::vector<study::Measurement> results;
  std::vector<study::Floor> floors;  // memory bandwidth for each number of threads; may be empty
  std::vector<study::Scaling> scalings;
  std::vector<std::string> notes;  // one sentence each

  // Whether all compared pictures are the same as those of the other renderer (the peer).
  bool pictures_same() const;
  // The floor (the memory bandwidth) measured with the result's number of threads; null if there is
  // none.
  const study::Floor* floor_of(const study::Measurement& result) const;
};

// {machine, compiler, target, results: [{scene, threads, ms, peer, peer_ms, ratio, ...}], scaling:
// [...]}, described in docs/benchmark.md.
nlohmann::ordered_json bench_json(const BenchReport& report);

// A page with bars that compare the times with the other renderer's and with the floor (the time
// that the memory's bandwidth allows at best), curves of scaling, and the numbers as text.
std::string bench_page(const BenchReport& report);

// The benchmark's results as text.
std::string bench_text(const BenchReport& report);

// "12.3", "0.0123": three significant digits, since repeated measurements agree in no more.
std::string three_digits(double value);

// The result of the comparison with the peer: "5 edge pixels differ, the others by at most 1/255".
std::string match_text(const study::PictureMatch& match);

// The fitted growth of the time: "t = 0.12 x^0.98; from 3e+05 on x^1.03 instead of x^0.71"
std::string scaling_text(const study::Scaling& scaling);

}  // namespace glassbox::study
