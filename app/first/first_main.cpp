// The program as far as its first picture needs it; ./glassbox runs it while the rest is not built yet.
#include <cstdio>
#include <exception>

#include <fmt/format.h>

#include "app/first/first_picture.h"
#include "app/report/exit_codes.h"

int main() {
  try {
    return glassbox::app::draw_first_picture();
  } catch (const std::exception& error) {
    fmt::print(stderr, "glassbox: {}\n", error.what());
  }
  return glassbox::app::kFailure;
}
