#include "app/views/picture_choice.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace glassbox::app {

void add_picture_choice(CLI::App& command, PictureChoice& choice) {
  const std::string group = "Pictures";
  command
      .add_option("--leave-out", choice.leave_out,
                  "a picture, counted from 1, that is not used, but judged by")
      ->type_name("N")
      ->group(group);
  command
      .add_option("--matte-above", choice.matte_above,
                  "the object is where a channel is brighter, 0 to 255 [masks/, or alpha]")
      ->type_name("LEVEL")
      ->check(CLI::Range(0, 255))
      ->group(group);
  command.add_flag("--no-mattes", choice.no_mattes, "every pixel is the object's")->group(group);
}

Result<void> check_choice(const PictureChoice& choice) {
  if (choice.no_mattes && choice.matte_above)
    return fail("--no-mattes", "there is a --matte-above as well", "leave one of them out");
  if (choice.leave_out && *choice.leave_out < 1)
    return fail("--leave-out", "pictures are counted from 1", "give 1 for the first");
  return {};
}

Result<ChosenPictures> read_pictures(const std::string& path, const PictureChoice& choice,
                                     std::uint64_t most_bytes) {
  views::PictureSetOptions options;
  options.wants_mattes = !choice.no_mattes;
  options.matte_above = choice.matte_above;
  options.most_bytes = most_bytes;
  auto set = views::read_picture_set(path, options);
  if (!set) return tl::unexpected(set.error());
  ChosenPictures chosen{std::move(*set), {}};
  if (!choice.leave_out) return chosen;
  const auto index = std::size_t(*choice.leave_out - 1);
  auto& pictures = chosen.set.pictures;
  if (index >= pictures.size())
    return fail("--leave-out", fmt::format("there are {} pictures", pictures.size()),
                "give the number of one of them, counted from 1");
  if (pictures.size() == 1)
    return fail("--leave-out", "it is the only picture", "take a set of more");
  chosen.left_out = std::move(pictures[index]);
  pictures.erase(pictures.begin() + std::ptrdiff_t(index));
  return chosen;
}

}  // namespace glassbox::app
