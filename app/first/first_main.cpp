// The program with only as much as its first picture needs. ./glassbox runs it while the rest is
// not built yet.
#include <exception>

#include "app/first/first_picture.h"
#include "app/report/whole_run.h"

int main() {
  glassbox::app::begin_run();
  try {
    return glassbox::app::end_run(glassbox::app::draw_first_picture());
  } catch (const std::exception& error) {
    return glassbox::app::tell(error);
  }
}
