// What the pictures of a sequence are called.
#pragma once

#include <string>

#include <glassbox/base/error.h>

namespace glassbox::app {

class FrameNames {
public:
  // `output` is -o: "walk.png" gives walk-0001.png; "walk%03d.png" walk001.png, with %% for a per cent sign; a directory
  // (one that exists, or with a slash at the end) pictures named after `usual` in it. Where it is empty, `usual` stands
  // for it. Four digits or, in a sequence of more, as many as it needs.
  static Result<FrameNames> of(const std::string& output, const std::string& usual, int count);

  std::string name(int number) const;

  // "walk.svg", or "frames.svg" where the pictures are mere numbers.
  std::string plot() const;

private:
  std::string before_, after_;
  int digits_ = 4;
};

}  // namespace glassbox::app
