// The options shared by commands that read calibrated pictures: which pictures of a folder they
// use, which one is left out, so that the result can be compared with it, and where the object is.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "cli/options/cli_fwd.h"
#include "cli/report/progress.h"
#include "views/rings/picture_set.h"
#include "views/texture/textured_surface.h"

namespace glassbox::views {

struct PictureChoice {
  std::string path;
  std::vector<std::size_t> chosen;  // counted from 0; empty: all
  std::optional<int> leave_out;     // counted from 1
  std::optional<int> matte_above;
  bool no_mattes = false;
  std::uint32_t max_megabytes = 4096;

  std::uint64_t most_bytes() const { return std::uint64_t(max_megabytes) << 20; }
};

struct ChosenPictures {
  views::PictureSet set;
  std::optional<views::CalibratedPicture> left_out;
};

// Adds PICTURES, --pictures, --leave-out, --matte-above, --no-mattes and --max-mb.
void add_picture_choice(CLI::App& command, PictureChoice& choice);

// Refuses options that contradict each other.
Result<void> check_choice(const PictureChoice& choice);

// Reads the pictures as a phase of a command's progress, and prints their warnings there.
Result<ChosenPictures> read_pictures(const PictureChoice& choice, Progress& progress);

// An error if `what` takes more bytes than --max-mb allows. `place` names the option that decides
// the number of bytes.
Result<void> check_memory(const std::string& place, const std::string& what, double bytes,
                          std::uint64_t most_bytes);

// The corners with the least and the greatest coordinates.
using BoxOption = std::optional<std::array<double, 6>>;

// Adds --box.
void add_box(CLI::App& command, BoxOption& box);

// The box given with --box, or else the one in the pictures' folder.
Result<views::WorldBox> box_of(const BoxOption& asked, const views::PictureSet& set);

// Reports how well a picture that was left out is reconstructed from a surface.
std::string left_out_text(const std::string& picture, const views::TextureErrors& errors);

// psnr is null if it is infinite. psnr and rms are null if no pixel is covered.
nlohmann::ordered_json left_out_json(const std::string& picture,
                                     const views::TextureErrors& errors);

}  // namespace glassbox::views
