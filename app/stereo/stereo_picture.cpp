#include "app/stereo/stereo_picture.h"

#include <array>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/arguments.h"
#include "cli/options/choices.h"
#include "cli/report/number_json.h"

#include <glassbox/base/counted.h>
#include <glassbox/pipeline/stereo/parallax.h>

namespace glassbox::app {

namespace {

template <class Value>
void add_named(CLI::App& command, const std::string& name, std::optional<Value>& value,
               std::span<const NamedChoice<Value>> all, const std::string& help) {
  Choices<std::optional<Value>> choices;
  for (const NamedChoice<Value>& named : all) choices.emplace_back(named.name, named.value);
  add_choice(command, name, value, choices, help)->group("Eyes (stereo)");
}

void add_form(CLI::App& command, StereoForm& form) {
  Choices<StereoForm> choices{{"anaglyph", {true, std::nullopt}}};
  for (const auto& layout : all_stereo_layouts()) {
    choices.emplace_back(layout.name, StereoForm{true, layout.value});
  }
  add_choice(command, "--stereo", form, choices, "both eyes in one picture")
      ->group("Eyes (stereo)");
}

void add_strength(CLI::App& command, const std::string& name, double& value,
                  const std::string& help) {
  command
      .add_option_function<std::string>(
          name, [&value, name](const std::string& text) { value = parse_number(name, text); }, help)
      ->type_name("0..1")
      ->group("Eyes (stereo)");
}

// Parses the word that says how the second eye's picture is warped; returns nothing if it is drawn.
std::optional<views::SecondEyeSettings> parse_second_eye(const std::string& text) {
  const std::string word = CLI::detail::to_lower(text);
  if (word == "drawn") return std::nullopt;
  if (word == "warp") return views::SecondEyeSettings{};
  constexpr std::string_view kWarp = "warp:";
  if (word.size() == kWarp.size() + 1 && word.starts_with(kWarp) && word.back() >= '1' &&
      word.back() <= '8') {
    return views::SecondEyeSettings{.layers = word.back() - '0'};
  }
  throw CLI::ValidationError(
      "--second-eye", "needs drawn, warp, or warp:LAYERS with 1 to 8 layers, not '" + text + "'");
}

bool is_recoloured(const StereoPictureOptions& stereo) {
  return stereo.recolour.desaturate != 0 || stereo.recolour.brighten != 0;
}

// Whether each channel is copied unchanged from its eye, so that both eyes can be drawn into one
// colour buffer.
bool is_masked(const StereoPictureOptions& stereo) {
  return !stereo.form.layout && !is_recoloured(stereo) &&
         stereo.anaglyph.method.value_or(AnaglyphMethod::kMask) == AnaglyphMethod::kMask;
}

// Both eyes' pictures as an anaglyph or in the chosen layout.
Result<Image<Rgba8>> combine_eyes(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                  const StereoPictureOptions& stereo) {
  if (stereo.form.layout) return make_stereo_layout(left, right, *stereo.form.layout);
  return make_anaglyph(left, right, stereo.anaglyph.method.value_or(AnaglyphMethod::kMask),
                       stereo.anaglyph.glasses.value_or(Glasses::kRedCyan));
}

Result<Image<Rgba8>> recolour_and_combine(const Image<Rgba8>& left, const Image<Rgba8>& right,
                                          const StereoPictureOptions& stereo) {
  if (!is_recoloured(stereo)) return combine_eyes(left, right, stereo);
  const Result<Image<Rgba8>> new_left = recoloured(left, stereo.recolour);
  if (!new_left) return new_left;
  const Result<Image<Rgba8>> new_right = recoloured(right, stereo.recolour);
  if (!new_right) return new_right;
  return combine_eyes(*new_left, *new_right, stereo);
}

AnaglyphMasks masks_for(Glasses glasses) {
  const EyeMasks eyes = eye_masks(glasses);
  return {{eyes.left.r, eyes.left.g, eyes.left.b, false},
          {eyes.right.r, eyes.right.g, eyes.right.b, true}};
}

// Cuts `width` columns, starting at `first`, out of an image. Empty for an image that was not
// drawn.
template <class Pixel>
Image<Pixel> columns_of(const Image<Pixel>& wide, int first, int width) {
  if (wide.pixels.empty()) return {};
  Image<Pixel> cut(width, wide.height);
  for (int y = 0; y < wide.height; ++y) {
    for (int x = 0; x < width; ++x) cut.at(x, y) = wide.at(first + x, y);
  }
  return cut;
}

// Draws both eyes with symmetric frusta (not skewed), then aligns and crops the pictures.
Result<StereoPicture> draw_and_crop(Renderer& renderer, const ChosenEyes& chosen,
                                    const RenderSettings& settings,
                                    const StereoPictureOptions& stereo) {
  const Result<AlignAndCrop> cut = align_and_crop(chosen.centre, chosen.eyes.pair);
  if (!cut) return tl::unexpected(cut.error());
  const int width = int(chosen.centre.viewport.width());
  Rendering left = renderer.render(cut->left, settings);
  Rendering right = renderer.render(cut->right, settings);
  StereoPicture picture;
  picture.cropped = *cut;
  picture.rendering.passes = 2;
  picture.rendering.left_statistics = left.statistics;
  picture.rendering.right_statistics = right.statistics;
  picture.rendering.left.distance = columns_of(left.buffers.distance, cut->left_first, width);
  picture.rendering.right.distance = columns_of(right.buffers.distance, cut->right_first, width);
  Result<Image<Rgba8>> image =
      recolour_and_combine(columns_of(left.buffers.color, cut->left_first, width),
                           columns_of(right.buffers.color, cut->right_first, width), stereo);
  if (!image) return tl::unexpected(image.error());
  picture.image = std::move(*image);
  return picture;
}

// Draws the left eye and warps the right one from it.
Result<StereoPicture> draw_and_warp(Renderer& renderer, const Scene& scene,
                                    const ChosenEyes& chosen, const RenderSettings& settings,
                                    const StereoPictureOptions& stereo, views::SecondEye& second) {
  const views::SecondEyeSettings& by = *stereo.second_eye;
  if (const auto legal = views::check_second_eye(scene, settings, by.layers); !legal)
    return tl::unexpected(legal.error());
  views::WarpedPair pair;
  views::render_pair_by_warp(renderer, chosen.centre, chosen.eyes.pair, settings, by, second, pair);
  StereoPicture picture;
  picture.rendering = std::move(pair.rendering);
  Result<Image<Rgba8>> image =
      recolour_and_combine(picture.rendering.left.color, picture.rendering.right.color, stereo);
  if (!image) return tl::unexpected(image.error());
  picture.image = std::move(*image);
  const std::size_t pixels = picture.rendering.right.color.pixels.size();
  picture.warped = {by.layers, pixels, pair.holes, pair.left_ms, pair.layers_ms, pair.warp_ms};
  return picture;
}

Result<StereoPicture> draw_eyes(Renderer& renderer, const Scene& scene, const ChosenEyes& chosen,
                                const RenderSettings& settings, const StereoPictureOptions& stereo,
                                views::SecondEye& second) {
  if (stereo.second_eye) return draw_and_warp(renderer, scene, chosen, settings, stereo, second);
  if (stereo.eyes_by == EyeFrusta::kCrop) return draw_and_crop(renderer, chosen, settings, stereo);
  const StereoSettings both{settings, stereo.culling};
  const StereoPair& pair = chosen.eyes.pair;
  const Glasses glasses = stereo.anaglyph.glasses.value_or(Glasses::kRedCyan);
  StereoPicture picture;
  if (is_masked(stereo)) {
    picture.rendering =
        renderer.render_masked_anaglyph(chosen.centre, pair, both, masks_for(glasses));
    picture.image = std::move(picture.rendering.left.color);
    return picture;
  }
  picture.rendering = renderer.render_pair(chosen.centre, pair, both);
  Result<Image<Rgba8>> image =
      recolour_and_combine(picture.rendering.left.color, picture.rendering.right.color, stereo);
  if (!image) return tl::unexpected(image.error());
  picture.image = std::move(*image);
  return picture;
}

// ---- parallax in words and numbers ----

struct NamedParallax {
  const char* name;
  Parallax parallax;
};

std::array<NamedParallax, 3> named_parallaxes(const ChosenEyes& chosen) {
  const ParallaxTable table = parallax_table(chosen.centre, chosen.eyes.pair);
  return {{{"near", table.near}, {"window", table.window}, {"far", table.far}}};
}

}  // namespace

void add_anaglyph_options(CLI::App& command, AnaglyphOptions& anaglyph) {
  add_named(command, "--anaglyph", anaglyph.method, all_anaglyph_methods(),
            "how the colours of an anaglyph are made [mask]");
  add_named(command, "--glasses", anaglyph.glasses, all_glasses(),
            "colours of the glasses, left eye first [red-cyan]");
}

void add_stereo_picture_options(CLI::App& command, StereoPictureOptions& stereo) {
  const std::size_t before = command.get_options().size();
  add_form(command, stereo.form);
  add_anaglyph_options(command, stereo.anaglyph);
  add_choice(command, "--stereo-cull", stereo.culling,
             {{"union", StereoCulling::kUnion}, {"centre", StereoCulling::kCentre}},
             "triangles to cull: those that neither eye can see, or those that the camera between "
             "the eyes cannot see, which loses some [union]")
      ->group("Eyes (stereo)");
  add_choice(command, "--eyes-by", stereo.eyes_by,
             {{"skew", EyeFrusta::kSkew}, {"crop", EyeFrusta::kCrop}},
             "projection of each eye: a skewed frustum, or a wider symmetric one whose picture is "
             "aligned and cropped [skew]")
      ->group("Eyes (stereo)");
  command
      .add_option_function<std::string>(
          "--second-eye",
          [&stereo](const std::string& text) { stereo.second_eye = parse_second_eye(text); },
          "how the right eye's picture is made: drawn, or approximated by warping 1 .. 8 layers of "
          "the left eye's view [drawn]")
      ->type_name("drawn|warp[:LAYERS]")
      ->group("Eyes (stereo)");
  add_strength(command, "--desaturate", stereo.recolour.desaturate,
               "how far colours are moved towards grey before the anaglyph is made, 0 .. 1 [0]");
  add_strength(command, "--brighten", stereo.recolour.brighten,
               "how far colours are moved towards white after --desaturate, 0 .. 1 [0]");
  add_named(command, "--cable", stereo.cable, all_cables(),
            "simulate an analogue video cable, which mixes the anaglyph's two eyes");
  const auto all = command.get_options();
  stereo.options.assign(all.begin() + std::ptrdiff_t(before), all.end());
}

Result<void> check_stereo_picture(const PictureOptions& picture,
                                  const StereoPictureOptions& stereo) {
  if (!stereo.form.wanted) {
    for (const CLI::Option* option : stereo.options) {
      if (option->count() == 0) continue;
      return fail(option->get_name(), "it is an option for pictures of two eyes",
                  "give --stereo too, or leave this option out");
    }
    return {};
  }
  if (picture.eyes.seen_by) {
    return fail("--seen-by", "--stereo makes a picture for both eyes", "give one of them");
  }
  if (stereo.form.layout && (stereo.anaglyph.method || stereo.anaglyph.glasses)) {
    return fail(stereo.anaglyph.method ? "--anaglyph" : "--glasses",
                fmt::format("--stereo {} is not an anaglyph", name_of(*stereo.form.layout)),
                "leave this option out, or give --stereo anaglyph");
  }
  if (stereo.form.layout && stereo.cable) {
    return fail("--cable",
                fmt::format("--stereo {} is not an anaglyph", name_of(*stereo.form.layout)),
                "leave --cable out, or give --stereo anaglyph");
  }
  if (stereo.eyes_by == EyeFrusta::kCrop && stereo.culling == StereoCulling::kCentre) {
    return fail("--stereo-cull centre",
                "--eyes-by crop draws each eye by itself, so nothing is culled for both",
                "leave out one of the two options");
  }
  if (stereo.second_eye && stereo.eyes_by == EyeFrusta::kCrop) {
    return fail("--eyes-by crop", "--second-eye warp works with skewed frusta only",
                "leave out one of the two options");
  }
  if (stereo.second_eye && stereo.culling == StereoCulling::kCentre) {
    return fail("--stereo-cull centre",
                "--second-eye warp draws the left eye alone, so nothing is culled for both",
                "leave out one of the two options");
  }
  if (const auto legal = check_recolour(stereo.recolour); !legal) return legal;
  if (stereo.form.layout == StereoLayout::kInterlaced && picture.size.height == 1) {
    return fail("--stereo interlaced", "a picture of one row has no row for the right eye",
                "give a picture of two rows or more");
  }
  if (!stereo.form.layout && stereo.anaglyph.method) {
    const auto matrix = anaglyph_matrix(*stereo.anaglyph.method,
                                        stereo.anaglyph.glasses.value_or(Glasses::kRedCyan));
    if (!matrix) return tl::unexpected(matrix.error());
  }
  return {};
}

Result<StereoPicture> render_stereo_picture(Renderer& renderer, const Scene& scene,
                                            const ChosenEyes& chosen,
                                            const RenderSettings& settings,
                                            const StereoPictureOptions& stereo,
                                            views::SecondEye& second) {
  Result<StereoPicture> picture = draw_eyes(renderer, scene, chosen, settings, stereo, second);
  if (!picture || !stereo.cable) return picture;
  return send_through_cable(picture->image, *stereo.cable).map([&](Image<Rgba8> arrived) {
    picture->image = std::move(arrived);
    return std::move(*picture);
  });
}

std::string eyes_text(const ChosenEyes& chosen, const StereoRendering& rendering) {
  const StereoPair& pair = chosen.eyes.pair;
  if (pair.half_separation == 0)
    return "stereo: both eyes are in one place, so one pass drew both pictures\n";
  std::string text = fmt::format("stereo: eyes {:.6g} apart, window at {:.6g} ({})\n",
                                 2 * pair.half_separation, pair.window, chosen.eyes.window_is_at);
  text += fmt::format("  {:<10}{:>12}{:>16}{:>14}\n", "", "distance", "parallax", "of the width");
  for (const auto& [name, parallax] : named_parallaxes(chosen)) {
    text += fmt::format("  {:<10}{:>12.6g}{:>13.2f} px{:>12.2f} %\n", name, parallax.distance,
                        parallax.px, parallax.percent);
  }
  if (!chosen.centre.perspective) {
    text +=
        "  a parallel projection: both views are oblique, and parallax grows linearly with depth\n";
  }
  if (rendering.lost > 0) {
    text += fmt::format("  culling by the camera between the eyes lost {} that an eye can see\n",
                        counted(rendering.lost, "triangle"));
  }
  return text;
}

std::string cropped_text(const StereoPicture& picture) {
  if (!picture.cropped) return "";
  const AlignAndCrop& cut = *picture.cropped;
  return fmt::format(
      "  cropped from pictures {} columns wider; infinity is shifted by {:.4f} px, so each eye's "
      "picture\n"
      "  is shifted by {:.4f} px from that of a skewed frustum\n",
      cut.shift, cut.shift_px, std::abs(cut.shift_px - cut.shift) / 2);
}

std::string warped_text(const StereoPicture& picture) {
  if (!picture.warped) return "";
  const WarpedRightEye& eye = *picture.warped;
  const std::string layers = eye.layers == 1
                                 ? "the surfaces that the left one sees"
                                 : fmt::format("{} layers from the left one", eye.layers);
  std::string text = fmt::format(
      "  the right eye is warped from {}: {:.2f} % of it are holes, filled from behind;\n"
      "  {:.1f} ms, after {:.1f} ms for drawing the left one",
      layers, 100 * double(eye.holes) / double(eye.pixels), eye.warp_ms, eye.left_ms);
  if (eye.layers > 1) text += fmt::format(" and {:.0f} ms for the layers behind it", eye.layers_ms);
  return text + "\n";
}

nlohmann::ordered_json warped_json(const WarpedRightEye& warped) {
  return {{"layers", warped.layers},
          {"holes", warped.holes},
          {"left_ms", warped.left_ms},
          {"layers_ms", warped.layers_ms},
          {"warp_ms", warped.warp_ms}};
}

nlohmann::ordered_json eyes_json(const ChosenEyes& chosen, const StereoRendering& rendering) {
  const StereoPair& pair = chosen.eyes.pair;
  nlohmann::ordered_json json{{"separation", 2 * pair.half_separation},
                              {"window", finite_or_inf(pair.window)},
                              {"separation_is_from", chosen.eyes.separation_is_from},
                              {"window_is_at", chosen.eyes.window_is_at},
                              {"passes", rendering.passes},
                              {"culled", rendering.culled},
                              {"lost", rendering.lost}};
  if (pair.half_separation == 0) return json;
  for (const auto& [name, parallax] : named_parallaxes(chosen)) {
    json["parallax"][name] = {{"distance", finite_or_inf(parallax.distance)},
                              {"px", parallax.px},
                              {"percent_of_width", parallax.percent}};
  }
  return json;
}

}  // namespace glassbox::app
