// Numbers with what is known about them: value, bound, bits.
#pragma once

#include <string>

namespace glassbox::app {

std::string bound_text(double bound);  // "+- 1.2e-08", "exact", "+- unknown"
std::string bits_text(float value);    // "3f800000"
std::string bits_text(double value);   // "3ff0000000000000"

// "x   0.123456789  +- 1.2e-08  3dfcd6e9": floats with nine digits, doubles with seventeen.
std::string number_line(const char* name, float value, double bound, bool bits);
std::string number_line(const char* name, double value, double bound, bool bits);

}  // namespace glassbox::app
