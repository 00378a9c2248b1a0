#include "student.h"

double twice(double x) {
  // BEGIN SOLUTION
  return 2 * x;
  // STUB: return 0 * x;
  // END SOLUTION
}

double reciprocal(double x) {
  // BEGIN SOLUTION
  return 1 / x;
  // STUB: return 0 * x;
  // END SOLUTION
}
