// --frames N, or FIRST-LAST/N: which frames of a sequence are drawn.
#pragma once

#include <string>

namespace glassbox {

// The frames from `first` to `last` of `count` frames, numbered from 1.
struct FrameRange {
  int first = 1, last = 1, count = 1;

  bool is_slice() const { return last - first + 1 < count; }
};

// Throws CLI::ValidationError if the text has neither form.
FrameRange parse_frames(const std::string& text);

}  // namespace glassbox
