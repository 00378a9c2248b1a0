// The benchmark's results as an HTML page that needs no other file and no network.
#pragma once

#include <string>

#include "study/commands/bench/report.h"

namespace glassbox::study {

// Bars that compare with the peer and the floor, curves of scaling, and the numbers as text.
std::string bench_page(const BenchReport& report);

}  // namespace glassbox::study
