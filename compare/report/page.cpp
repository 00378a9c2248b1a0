#include <glassbox/compare/report/page.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glassbox/compare/pixels/heat_map.h>
#include <glassbox/compare/report/json.h>
#include <glassbox/compare/report/page_blob.h>
#include <glassbox/html/blob.h>
#include <glassbox/html/page.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/out_of_memory.h>
#include <glassbox/images/recipe.h>
#include <glassbox/images/stored_image.h>

#include "diff_page.h"  // made by html/embed.cmake

namespace glassbox {
namespace {

using Json = nlohmann::ordered_json;

// A picture of a pair as the page's script knows it: "reference", "test" or "heat".
struct Picture {
  const char* name;
  StoredImage image;
};

// The picture, unless it cannot be read or is not what was compared.
std::optional<StoredImage> read_again(const PictureFacts& facts) {
  auto image = read_stored(facts.path);
  if (!image) return {};
  const bool changed = image->width != facts.width || image->height != facts.height ||
                       channel_names(*image) != facts.channels ||
                       format_name(*image) != facts.format;
  const bool was_read = facts.width > 0;
  if (was_read && changed) return {};
  return std::move(*image);
}

// The levels of the heat map as a picture; none where other pixels differ than when they were compared.
std::optional<StoredImage> heat_of(const Comparison& comparison, const StoredImage& reference,
                                   const StoredImage& test) {
  const auto selection = selection_of(reference, comparison.ignore, comparison.mask);
  if (!selection) return {};
  auto levels = heat_map({reference, test, *selection, comparison.nan_equals_nan});
  const auto differing =
      std::count_if(levels.pixels.begin(), levels.pixels.end(),
                    [](std::uint8_t level) { return level != kHeatSame && level != kHeatLeftOut; });
  if (std::uint64_t(differing) != comparison.differences->differing) return {};
  return StoredImage{levels.width, levels.height, 1,
                     std::vector(levels.pixels.begin(), levels.pixels.end())};
}

// What there is to show of a comparison; nothing where the files have changed since, as its numbers would be of others.
std::vector<Picture> pictures_of(const Comparison& comparison) {
  auto reference = read_again(comparison.reference);
  auto test = read_again(comparison.test);
  if (!comparison.error && (!reference || !test)) return {};
  std::optional<StoredImage> heat;
  if (comparison.differences && reference && test) {
    heat = heat_of(comparison, *reference, *test);
    if (!heat) return {};
  }
  std::vector<Picture> pictures;
  if (reference) pictures.push_back({"reference", std::move(*reference)});
  if (test) pictures.push_back({"test", std::move(*test)});
  if (heat) pictures.push_back({"heat", std::move(*heat)});
  return pictures;
}

// The worst first, otherwise in the order given.
std::vector<const Comparison*> worst_first(std::span<const Comparison> comparisons) {
  std::vector<const Comparison*> order;
  for (const Comparison& one : comparisons) order.push_back(&one);
  const auto badness = [](const Comparison* one) {
    constexpr std::array kVerdicts{Verdict::kSame,       Verdict::kWithinTolerance,
                                   Verdict::kNew,        Verdict::kMissing,
                                   Verdict::kUncompared, Verdict::kDifferent};
    const auto verdict = std::find(kVerdicts.begin(), kVerdicts.end(), one->verdict);
    // Pictures of different sizes have no differences: nothing is worse.
    const auto steps = one->differences ? one->differences->largest : kUnbounded;
    const auto pixels = one->differences ? one->differences->differing : ~std::uint64_t(0);
    return std::tuple(verdict - kVerdicts.begin(), steps, pixels);
  };
  std::stable_sort(order.begin(), order.end(), [&](const Comparison* a, const Comparison* b) {
    return badness(a) > badness(b);
  });
  return order;
}

std::string_view type_name(const StoredImage& image) {
  constexpr std::array<std::string_view, 3> kNames{"u8", "u16", "f32"};
  return kNames[image.samples.index()];
}

std::uint64_t bytes_in(const StoredImage& image, std::span<const PixelBox> boxes) {
  std::uint64_t pixels = 0;
  for (const PixelBox& box : boxes) pixels += std::uint64_t(box.width) * std::uint64_t(box.height);
  return pixels * std::uint64_t(image.channels) * sample_bytes(image);
}

// Collects the samples of a page and what its script needs to know of them.
class PageWriter {
public:
  explicit PageWriter(const PageOptions& options) : options_(options), left_(options.max_bytes) {}

  // Adds the pictures to what the script knows of the pair, or the reason why they are not there.
  Result<void> add_pictures(const Comparison& comparison, Json& pair) {
    if (least_bytes(comparison) > left_) return leave_out(comparison, pair);
    const std::vector<Picture> pictures = pictures_of(comparison);
    if (pictures.empty()) {
      pair["left_out"] = comparison.error ? "There is no picture to show."
                                          : "The files have changed since they were compared.";
      return {};
    }
    std::uint64_t bytes = 0;
    for (const Picture& picture : pictures)
      bytes += bytes_in(picture.image, crops(comparison, picture.image));
    if (bytes > left_) return leave_out(comparison, pair);
    left_ -= bytes;
    for (const auto& [name, image] : pictures) {
      auto added = add_picture(image, crops(comparison, image));
      if (!added) return tl::unexpected(added.error());
      pair["pictures"][name] = std::move(*added);
    }
    return {};
  }

  const std::string& blobs() const { return blobs_; }

private:
  std::vector<PixelBox> crops(const Comparison& comparison, const StoredImage& image) const {
    const Differences* differences = comparison.differences ? &*comparison.differences : nullptr;
    return crops_of(image.width, image.height, differences, options_.crops);
  }

  // What the pictures take at the very least, known before they are read: a byte a pixel where they are not cropped.
  std::uint64_t least_bytes(const Comparison& comparison) const {
    std::uint64_t bytes = 0;
    for (const PictureFacts* facts : {&comparison.reference, &comparison.test}) {
      const auto pixels = std::uint64_t(facts->width) * std::uint64_t(facts->height);
      if (pixels <= options_.crops.whole_pixels) bytes += pixels;
    }
    return bytes;
  }

  Result<void> leave_out(const Comparison& comparison, Json& pair) {
    pair["left_out"] =
        "The pictures of this pair would make the page too large. This makes a page of them alone:";
    pair["alone_command"] =
        "glassbox diff " + shell_quoted(comparison.reference.path).value_or("REFERENCE") + " " +
        shell_quoted(comparison.test.path).value_or("TEST") + " --html pair.html";
    return {};
  }

  Result<Json> add_picture(const StoredImage& image, const std::vector<PixelBox>& tiles) {
    const auto blob = encode_blob(image, tiles);
    if (!blob) return tl::unexpected(blob.error());
    const std::string id = fmt::format("blob-{}", blob_count_++);
    blobs_ += data_block(id, *blob);
    Json json{{"width", image.width},
              {"height", image.height},
              {"channels", image.channels},
              {"type", type_name(image)},
              {"blob", id}};
    for (const auto& [x, y, width, height] : tiles) json["tiles"].push_back({x, y, width, height});
    return json;
  }

  const PageOptions& options_;
  std::uint64_t left_;  // bytes
  int blob_count_ = 0;
  std::string blobs_;
};

Json colour_names() {
  Json names = Json::array();
  for (const Rgba8& colour : heat_colours()) {
    names.push_back(fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b));
  }
  return names;
}

Result<std::string> make_page(std::span<const Comparison> comparisons, const PageOptions& options) {
  PageWriter writer(options);
  Json manifest{{"title", options.title},     {"program", options.program},
                {"command", options.command}, {"heat_colours", colour_names()},
                {"pairs", Json::array()},     {"same", Json::array()}};
  for (const Comparison* comparison : worst_first(comparisons)) {
    if (comparison->verdict == Verdict::kSame && comparisons.size() > 1) {
      manifest["same"].push_back(comparison->name);
      continue;
    }
    Json pair = to_json(*comparison);
    pair["nan_equals_nan"] = comparison->nan_equals_nan;
    if (auto added = writer.add_pictures(*comparison, pair); !added) {
      return tl::unexpected(added.error());
    }
    manifest["pairs"].push_back(std::move(pair));
  }
  return assemble_page(kDiffPage, "glassbox diff",
                       json_block("manifest", manifest) + writer.blobs());
}

}  // namespace

Result<void> write_page(const std::string& path, std::span<const Comparison> comparisons,
                        const PageOptions& options) {
  return unless_out_of_memory([&]() -> Result<void> {
    const auto page = make_page(comparisons, options);
    if (!page) return tl::unexpected(page.error());
    return write_file(path, std::as_bytes(std::span(*page)));
  });
}

}  // namespace glassbox
