// Which frames of a sequence are drawn (--frames N, or FIRST-LAST/N), and the names of their
// pictures.
#pragma once

#include <string>

#include <glassbox/base/error.h>

namespace glassbox {

// The frames from `first` to `last` of `count` frames, numbered from 1.
struct FrameRange {
  int first = 1, last = 1, count = 1;

  bool is_slice() const { return last - first + 1 < count; }
};

// Throws CLI::ValidationError if the text has neither form.
FrameRange parse_frames(const std::string& text);

// The file names of the pictures of a sequence.
class FrameNames {
public:
  // `output` is the value of -o: "walk.png" gives walk-0001.png; "walk%03d.png" gives walk001.png,
  // with %% for a per cent sign; a directory (one that exists, or with a slash at the end) gives
  // pictures in it with the name `usual`. `usual` is also the name if `output` is empty. Numbers
  // have four digits, or more if `count` needs more.
  static Result<FrameNames> from_output(const std::string& output, const std::string& usual,
                                        int count);

  std::string name(int number) const;

  // The plot's file: "walk.svg", or "frames.svg" if the pictures' names are only numbers.
  std::string plot() const;

private:
  std::string before_, after_;
  int digits_ = 4;
};

}  // namespace glassbox
