// The one error type: it says what was wrong, where, and what to do about it.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace glassbox {

// The reason why an input is refused. `file` and `place` ("node 3", "accessor 7, byte 120",
// "--fov") may be empty; `cause` and `remedy` never are. The program prints message() on one line
// and exits with 2.
struct Error {
  std::string file;
  std::string place;
  std::string cause;
  std::string remedy;

  // For example "duck.glb: accessor 7: names buffer view 9 of 4; export the file again".
  std::string message() const {
    std::string text;
    for (const std::string* part : {&file, &place}) {
      if (!part->empty()) text += *part + ": ";
    }
    text += cause;
    if (!remedy.empty()) text += "; " + remedy;
    return text;
  }
};

// A value, or the error that says why there is none. Stages, cameras and loaders return it.
template <class T>
using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(std::string place, std::string cause, std::string remedy) {
  return tl::unexpected<Error>(Error{{}, std::move(place), std::move(cause), std::move(remedy)});
}

}  // namespace glassbox
