// The benchmark's results for people.
#pragma once

#include <string>

#include "app/bench/report.h"

namespace glassbox::app {

std::string bench_text(const BenchReport& report);

// "12.3", "0.0123": three digits, as many as repeated measurements agree in at best.
std::string three_digits(double value);

// What became of the comparison with the peer: "5 edge pixels differ, the others by at most 1/255".
std::string match_text(const study::PictureMatch& match);

// "t = 0.12 x^0.98; from 3e+05 on x^1.03 instead of x^0.71"
std::string scaling_text(const study::Scaling& scaling);

}  // namespace glassbox::app
