#include <algorithm>

#include <fmt/format.h>

#include "app/why/verdict_paragraphs.h"

namespace glassbox {

namespace {

std::string rival_text(std::optional<std::uint32_t> number) {
  return number ? fmt::format("triangle {}", *number) : std::string("lines or points");
}

std::string rivals_text(const std::vector<Rival>& rivals) {
  constexpr std::size_t kShown = 4;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(rivals.size(), kShown); ++i) {
    texts.push_back(fmt::format("{} ({})", rival_text(rivals[i].number), rivals[i].pixels));
  }
  if (rivals.size() > kShown) texts.push_back(fmt::format("{} others", rivals.size() - kShown));
  return listed(texts);
}

std::string closest_text(const FragmentDetails::Hidden& h) {
  const std::string where = fmt::format("The closest call is at pixel ({}, {}), against {}: ", h.x,
                                        h.y, rival_text(h.by));
  if (h.code == h.stored) {
    return where + fmt::format(
                       "both have depth code 0x{:08x} (distances {:.9g} and {:.9g}), and of equal "
                       "depths the first drawn stays.",
                       h.code, h.distance, h.stored_distance);
  }
  return where + fmt::format(
                     "depth code 0x{:08x} is not below 0x{:08x}, by {} codes; distance {:.9g} "
                     "behind {:.9g}.",
                     h.code, h.stored, h.code - h.stored, h.distance, h.stored_distance);
}

// "all 12 fragments", "3 of 12 fragments".
std::string share_text(std::uint32_t part, std::uint32_t all) {
  if (part < all) return fmt::format("{} of {} fragments", part, all);
  return all == 1 ? "its only fragment" : fmt::format("all {} fragments", all);
}

std::string unchanged_text(const FragmentTally& t, const FragmentDetails::Unchanged& u) {
  return fmt::format(
      "Of these, {} left the bytes of their pixel as they were, at ({}, {}) for one: ({}, {}, {}, "
      "{}){}.",
      t.unchanged == t.visible ? std::string("all") : std::to_string(t.unchanged), u.x, u.y,
      u.bytes.r, u.bytes.g, u.bytes.b, u.bytes.a,
      u.blended ? fmt::format(", with alpha {:.9g}", u.alpha) : "");
}

}  // namespace

std::vector<std::string> explain_fragments(const TriangleVerdict& verdict) {
  std::vector<std::string> text;
  const FragmentTally& t = verdict.fragments;
  const FragmentDetails& d = verdict.details;
  const auto share = [&](std::uint32_t part) { return share_text(part, t.covered); };
  if (t.visible > 0) {
    const PixelRect& box = d.visible_box;
    text.push_back(fmt::format("In the picture: {}, in columns {} .. {} and rows {} .. {}.",
                               share(t.visible), box.x0, box.x1 - 1, box.y0, box.y1 - 1));
    if (t.veiled > 0) {
      text.push_back(fmt::format("Translucent surfaces lie over {} of these.", t.veiled));
    }
    if (t.unchanged > 0) text.push_back(unchanged_text(t, *d.unchanged));
  }
  if (t.hidden > 0) {
    text.push_back(fmt::format("Failed the depth test: {}, behind {}.", share(t.hidden),
                               rivals_text(d.hidden_by)));
    text.push_back(closest_text(*d.closest_hidden));
  }
  if (t.discarded > 0) {
    const FragmentDetails::Discarded& found = *d.closest_discarded;
    text.push_back(fmt::format(
        "Discarded, with an alpha below the material's cutoff of {:.9g}: {}. The highest alpha "
        "is {:.9g}, at pixel ({}, {}).",
        found.cutoff, share(t.discarded), found.alpha, found.x, found.y));
  }
  if (t.masked > 0) {
    text.push_back(fmt::format("Kept out by the colour mask, which lets no channel through: {}.",
                               share(t.masked)));
  }
  if (t.overwritten > 0) {
    text.push_back(fmt::format("Written, and then written over: {}, by {}.", share(t.overwritten),
                               rivals_text(d.overwritten_by)));
  }
  return text;
}

}  // namespace glassbox
