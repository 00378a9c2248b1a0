// The benchmark's results as text.
#pragma once

#include <string>

#include "study/commands/bench/report.h"

namespace glassbox::study {

std::string bench_text(const BenchReport& report);

// "12.3", "0.0123": three significant digits, since repeated measurements agree in no more.
std::string three_digits(double value);

// The result of the comparison with the peer: "5 edge pixels differ, the others by at most 1/255".
std::string match_text(const study::PictureMatch& match);

// The fitted growth of the time: "t = 0.12 x^0.98; from 3e+05 on x^1.03 instead of x^0.71"
std::string scaling_text(const study::Scaling& scaling);

}  // namespace glassbox::study
