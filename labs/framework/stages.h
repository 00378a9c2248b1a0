// The program in which a student's code runs while a picture is drawn (glassbox lab render). It
// reads records, the inputs of the student's functions, and writes their results. A record is a
// list of doubles; floats and whole numbers up to 2^53 are exact in it.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace glassbox::labs {

using Numbers = std::vector<double>;

// Reads a record, one number after the other.
class RecordReader {
public:
  RecordReader(const double* numbers, std::size_t count) : at_(numbers), end_(numbers + count) {}

  bool more() const { return at_ != end_; }
  double number() { return more() ? *at_++ : 0; }
  float real() { return float(number()); }
  int integer() { return int(number()); }

  // Reads a point or vector of floats or doubles, with four numbers if it is in clip space.
  template <class P>
  P point() {
    using T = typename P::scalar;
    const T x = T(number()), y = T(number()), z = T(number());
    if constexpr (requires(P p) { p.w; }) {
      return {x, y, z, T(number())};
    } else {
      return {x, y, z};
    }
  }
  // Reads a matrix of sixteen numbers, row by row.
  template <class M>
  M matrix() {
    M m;
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) m.at(row, column) = number();
    }
    return m;
  }

private:
  const double *at_, *end_;
};

template <class P>
void append_point(Numbers& out, const P& p) {
  out.insert(out.end(), {double(p.x), double(p.y), double(p.z)});
  if constexpr (requires { p.w; }) out.push_back(double(p.w));
}

template <class M>
void append_matrix(Numbers& out, const M& m) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) out.push_back(double(m.at(row, column)));
  }
}

// One stage of the pipeline, done by the student's functions: appends their result for one record
// to `out`.
struct StageFunction {
  std::string name;
  std::function<void(RecordReader& in, Numbers& out)> run;
  // Only in timed.cpp (glassbox lab measure): reads one input and returns a function that does all
  // of its work once. Only that function is timed.
  std::function<std::function<void()>(RecordReader& in)> prepare = {};
};

// Defined by the lab's stages.cpp; for the program that is timed, by its timed.cpp.
std::vector<StageFunction> stage_functions();

}  // namespace glassbox::labs
