// Which pictures of a folder a command takes, and which one it leaves out to be judged by.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/options/cli_fwd.h"
#include "views/rings/picture_set.h"

namespace glassbox::app {

struct PictureChoice {
  std::optional<int> leave_out;  // from 1
  std::optional<int> matte_above;
  bool no_mattes = false;
};

struct ChosenPictures {
  views::PictureSet set;
  std::optional<views::CalibratedPicture> left_out;
};

// --leave-out, --matte-above and --no-mattes.
void add_picture_choice(CLI::App& command, PictureChoice& choice);

// What cannot be asked together.
Result<void> check_choice(const PictureChoice& choice);

Result<ChosenPictures> read_pictures(const std::string& path, const PictureChoice& choice,
                                     std::uint64_t most_bytes);

}  // namespace glassbox::app
