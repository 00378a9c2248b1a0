#include "views/commands/picture_choice.h"

#include <cmath>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/arguments.h"
#include "cli/report/exit_codes.h"
#include "views/rings/ring.h"

#include <glassbox/base/printable.h>

namespace glassbox::views {

namespace {

// Parses numbers of pictures from 1, such as "1-8,12", to indices from 0.
std::vector<std::size_t> parse_pictures(const std::string& text) {
  std::vector<std::size_t> chosen;
  const auto number = [&](const std::string& part) {
    const double value = parse_number("--pictures", part);
    if (!(value >= 1 && value <= 1e6) || value != std::floor(value))
      throw CLI::ValidationError("--pictures",
                                 "needs numbers from 1, such as 1-8,12, not '" + text + "'");
    return std::size_t(value);
  };
  for (const std::string& part : split(text, ',')) {
    const std::vector<std::string> ends = split(part, '-');
    const std::size_t first = number(ends.front()), last = number(ends.back());
    if (ends.size() > 2 || last < first || last - first > std::size_t(views::kMaxRingViews))
      throw CLI::ValidationError("--pictures",
                                 "needs numbers from 1, such as 1-8,12, not '" + text + "'");
    for (std::size_t i = first; i <= last; ++i) chosen.push_back(i - 1);
  }
  return chosen;
}

}  // namespace

void add_picture_choice(CLI::App& command, PictureChoice& choice) {
  const std::string group = "Pictures";
  command
      .add_option("PICTURES", choice.path,
                  "a folder with pictures, or its file of cameras: *_par.txt, or COLMAP's "
                  "cameras and images (.bin or .txt), also in sparse/0")
      ->required();
  command
      .add_option_function<std::string>(
          "--pictures",
          [&choice](const std::string& text) { choice.chosen = parse_pictures(text); },
          "numbers of the pictures to use, counted from 1, such as 1-8,12 [all]")
      ->type_name("A-B,C")
      ->group(group);
  command
      .add_option(
          "--leave-out", choice.leave_out,
          "number of one picture, counted from 1, that is not used; the result is compared with it")
      ->type_name("N")
      ->group(group);
  command
      .add_option(
          "--matte-above", choice.matte_above,
          "makes a mask from each picture: a pixel belongs to the object if one of its channels is "
          "above this, 0 to 255 [masks come from the folder masks/, or from alpha]")
      ->type_name("LEVEL")
      ->check(CLI::Range(0, 255))
      ->group(group);
  command
      .add_flag("--no-mattes", choice.no_mattes, "use no masks: every pixel belongs to the object")
      ->group(group);
  command
      .add_option("--max-mb", choice.max_megabytes,
                  fmt::format("most memory, in megabytes; work that needs more is refused [{}]",
                              choice.max_megabytes))
      ->type_name("N")
      ->check(CLI::Range(1u, 1u << 20))
      ->group("Engine");
}

Result<void> check_choice(const PictureChoice& choice) {
  if (choice.no_mattes && choice.matte_above)
    return fail("--no-mattes", "--matte-above is given too", "leave one of them out");
  if (choice.leave_out && *choice.leave_out < 1)
    return fail("--leave-out", "pictures are counted from 1", "give 1 for the first");
  return {};
}

Result<ChosenPictures> read_pictures(const PictureChoice& choice, Progress& progress) {
  progress.phase("reading the pictures");
  views::PictureSetOptions options;
  options.wants_mattes = !choice.no_mattes;
  options.matte_above = choice.matte_above;
  options.most_bytes = choice.most_bytes();
  options.chosen = choice.chosen;
  // The left-out picture is read with the chosen ones, as the last of them.
  if (choice.leave_out && !options.chosen.empty()) {
    const auto index = std::size_t(*choice.leave_out - 1);
    std::erase(options.chosen, index);
    options.chosen.push_back(index);
  }
  auto set = views::read_picture_set(choice.path, options);
  if (!set) return tl::unexpected(set.error());
  for (const std::string& warning : set->warnings) progress.print_line("warning: " + warning);
  ChosenPictures all{std::move(*set), {}};
  if (!choice.leave_out) return all;
  auto& pictures = all.set.pictures;
  const std::size_t index =
      choice.chosen.empty() ? std::size_t(*choice.leave_out - 1) : pictures.size() - 1;
  if (index >= pictures.size()) {
    return fail("--leave-out",
                fmt::format("there are {} pictures, but number {} is requested", pictures.size(),
                            *choice.leave_out),
                "count from 1");
  }
  if (pictures.size() == 1)
    return fail("--leave-out", "the only picture cannot be left out",
                "use a set of several pictures");
  all.left_out = std::move(pictures[index]);
  pictures.erase(pictures.begin() + std::ptrdiff_t(index));
  return all;
}

Result<void> check_memory(const std::string& place, const std::string& what, double bytes,
                          std::uint64_t most_bytes) {
  if (bytes <= double(most_bytes)) return {};
  constexpr double kMegabyte = 1048576;
  return fail(place,
              fmt::format("{} would need {:.0f} MB, but {} MB are allowed", what,
                          std::ceil(bytes / kMegabyte), most_bytes >> 20),
              place == "--max-mb" ? "use fewer or smaller pictures, or allow more megabytes"
                                  : "use larger voxels, or allow more with --max-mb");
}

void add_box(CLI::App& command, BoxOption& box) {
  command
      .add_option_function<std::string>(
          "--box", [&box](const std::string& text) { box = parse_numbers<6>("--box", text); },
          "the box around the object, in world units [the folder's box.txt]")
      ->type_name("X0,Y0,Z0,X1,Y1,Z1")
      ->group("Voxels");
}

Result<views::WorldBox> box_of(const BoxOption& asked, const views::PictureSet& set) {
  if (!asked && !set.box)
    return fail("--box", "the folder has no box.txt that says where the object is",
                "give the box around it: --box X0,Y0,Z0,X1,Y1,Z1");
  views::WorldBox box;
  if (asked) {
    const auto& [x0, y0, z0, x1, y1, z1] = *asked;
    box = {{x0, y0, z0}, {x1, y1, z1}};
  } else {
    box = *set.box;
  }
  if (!((box.high - box.low).minCoeff() > 0))
    return fail("--box", "the box is empty", "give the corner of least coordinates first");
  return box;
}

std::string left_out_text(const std::string& picture, const views::TextureErrors& errors) {
  const std::string name = printable(picture, kLongestMessage);
  if (errors.covered == 0)
    return fmt::format("{} was left out: the polygons cover no pixel of its object\n", name);
  return fmt::format(
      "{} was left out: PSNR {:.2f} dB, RMS {:.2f}, over the {:.1f} % of its object that polygons "
      "cover\n",
      name, errors.psnr, errors.rms, 100 * errors.covered);
}

nlohmann::ordered_json left_out_json(const std::string& picture,
                                     const views::TextureErrors& errors) {
  return {{"picture", picture},
          {"psnr", errors.psnr},
          {"rms", errors.rms},
          {"covered", errors.covered},
          {"pixels", errors.pixels}};
}

}  // namespace glassbox::views
