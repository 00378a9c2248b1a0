#include "cli/options/ignored_options.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace glassbox {

namespace {

// The option as it was given, "--shade flat"; empty if it was not given.
std::string option_as_given(const PictureOptions& picture, const std::string& name) {
  const std::vector<std::string> words = given_option_words(picture);
  const auto option = std::ranges::find(words, name);
  if (option == words.end()) return {};
  return name + " " + *std::next(option);
}

void print_note(const std::string& words, const std::string& why) {
  if (!words.empty()) fmt::print(stderr, "glassbox: note: {} is ignored: {}\n", words, why);
}

// Whether the picture shows another quantity than colour, and is made from the framebuffer after
// everything is drawn.
bool is_of_a_plane(Show show) {
  return show == Show::kDepth || show == Show::kId || show == Show::kOverdraw;
}

}  // namespace

void print_ignored_options(const PictureOptions& picture) {
  const RenderSettings& settings = picture.settings;
  const std::string show = option_as_given(picture, "--show");
  if (is_of_a_plane(settings.show)) {
    if (settings.samples > 1) {
      print_note(option_as_given(picture, "--samples"),
                 show + " shows values at pixel centres, as with --samples 1");
    }
  }
  if (settings.show != Show::kColor) {
    // Flat shading uses face normals, so --shade does change a picture of normals.
    const bool flat_normals = settings.show == Show::kNormal && settings.shading == Shading::kFlat;
    if (!flat_normals) print_note(option_as_given(picture, "--shade"), show + " shows no lighting");
    print_note(option_as_given(picture, "--transfer"),
               show + " stores values that are not encoded");
  }
  if (picture.eyes.separation == 0.0) {
    print_note(option_as_given(picture, "--window"),
               "with --eye-separation 0 nothing has parallax");
  }
}

void print_ignored_options(const CLI::App& command, const std::vector<IgnoredOptions>& all) {
  for (const IgnoredOptions& some : all) {
    for (const std::string& name : some.names) {
      if (some.are_ignored && command.count(name) > 0) print_note(name, some.why);
    }
  }
}

}  // namespace glassbox
