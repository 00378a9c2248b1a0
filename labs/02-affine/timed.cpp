// Turns a rotation in small steps and lets your function repair it now and then, for glassbox lab
// measure.
#include "labs/framework/stages.h"
#include "student.h"

namespace lab_02 {
namespace {

using glassbox::labs::Numbers;
using glassbox::labs::RecordReader;
using Rotation = std::array<std::array<double, 3>, 3>;

// The product of the steps so far, which is repaired after every `every` steps.
class Turning {
public:
  Turning(const Rotation& step, int every) : step_(step), every_(every) {}

  void advance() {
    Rotation product{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        product[i][j] = r_[i][0] * step_[0][j] + r_[i][1] * step_[1][j] + r_[i][2] * step_[2][j];
    }
    r_ = product;
    if (++since_ == every_) repair();
  }
  bool is_worst() const { return since_ == every_ - 1; }
  const Rotation& matrix() const { return r_; }

private:
  void repair() {
    Transform<World, World> m;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) m.at(i, j) = r_[std::size_t(i)][std::size_t(j)];
    }
    m = repaired(m);
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) r_[std::size_t(i)][std::size_t(j)] = m.at(i, j);
    }
    since_ = 0;
  }

  Rotation step_, r_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  int every_, since_ = 0;
};

struct ParsedQuestion {
  int steps = 0, every = 1;
  Rotation step{};
};

// Reads the number of steps, the number of steps between repairs, and the rotation of one step, row
// by row.
ParsedQuestion read(RecordReader& in) {
  ParsedQuestion asked;
  asked.steps = in.integer();
  asked.every = in.integer();
  for (auto& row : asked.step) {
    for (double& entry : row) entry = in.number();
  }
  return asked;
}

// Writes the matrix at about a thousand moments on the way, each just before a repair, when it has
// drifted most, and at the end.
void answer(RecordReader& in, Numbers& out) {
  const ParsedQuestion asked = read(in);
  Turning turning(asked.step, asked.every);
  const int looks = asked.steps < 1000 ? 1 : asked.steps / 1000;
  for (int i = 1, due = looks; i <= asked.steps; ++i) {
    turning.advance();
    if (i < due && i != asked.steps) continue;
    if (!turning.is_worst() && i != asked.steps) continue;
    for (const auto& row : turning.matrix()) out.insert(out.end(), row.begin(), row.end());
    due = i + looks;
  }
}

std::function<void()> prepare(RecordReader& in) {
  return [asked = read(in)] {
    Turning turning(asked.step, asked.every);
    for (int i = 0; i < asked.steps; ++i) turning.advance();
  };
}

}  // namespace
}  // namespace lab_02

std::vector<glassbox::labs::StageFunction> glassbox::labs::stage_functions() {
  return {{"measured", lab_02::answer, lab_02::prepare}};
}
