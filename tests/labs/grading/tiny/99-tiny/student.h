// A lab of two functions, for the tests of the grader.
#pragma once

double twice(double x);       // 2 x
double reciprocal(double x);  // 1 / x, for x != 0
