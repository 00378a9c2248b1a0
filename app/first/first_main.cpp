// A smaller program, with only what the first picture needs. ./glassbox runs it while the rest is
// not built yet.
#include <exception>

#include "app/first/first_picture.h"
#include "cli/report/begin_and_end_run.h"

int main() {
  glassbox::begin_run();
  try {
    return glassbox::end_run(glassbox::app::draw_first_picture());
  } catch (const std::exception& error) {
    return glassbox::report_exception(error);
  }
}
