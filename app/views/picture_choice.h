// What the commands that read calibrated pictures ask alike: which of a folder they take, which one they leave out to be judged by, and
// where the object is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/options/cli_fwd.h"
#include "views/rings/picture_set.h"

namespace glassbox::app {

struct PictureChoice {
  std::string path;
  std::vector<std::size_t> chosen;  // from 0; none: all
  std::optional<int> leave_out;     // from 1
  std::optional<int> matte_above;
  bool no_mattes = false;
  std::uint32_t max_megabytes = 4096;

  std::uint64_t most_bytes() const { return std::uint64_t(max_megabytes) << 20; }
};

struct ChosenPictures {
  views::PictureSet set;
  std::optional<views::CalibratedPicture> left_out;
};

// PICTURES, --pictures, --leave-out, --matte-above, --no-mattes and --max-mb.
void add_picture_choice(CLI::App& command, PictureChoice& choice);

// What cannot be asked together.
Result<void> check_choice(const PictureChoice& choice);

Result<ChosenPictures> read_pictures(const PictureChoice& choice);

// Refused: what would take more bytes than --max-mb allows. `place` is the option that makes it so large, `what` takes them.
Result<void> check_memory(const std::string& place, const std::string& what, double bytes,
                          std::uint64_t most_bytes);

using AskedBox =
    std::optional<std::array<double, 6>>;  // corners of least and of greatest coordinates

// --box.
void add_box(CLI::App& command, AskedBox& box);

// The box that is asked for, else the folder's.
Result<views::WorldBox> box_of(const AskedBox& asked, const views::PictureSet& set);

}  // namespace glassbox::app
