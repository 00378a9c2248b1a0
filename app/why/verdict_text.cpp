#include "app/why/verdict_text.h"

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>
#include <glassbox/matrices/convention_mistakes.h>

namespace glassbox {

namespace {

struct ResultText {
  const char *words, *meaning;
};
constexpr ResultText kResultTexts[kTriangleResults] = {
    {"no area as modelled", "their corners lie on a line or in a point, so they are never drawn"},
    {"not finite", "a corner overflows float on the way to clip space"},
    {"behind the eye",
     "w, the distance along the gaze, is 0 or less at every corner, because the camera looks the "
     "other way"},
    {"outside one plane", "all corners lie outside one plane: near, far or the guard band"},
    {"clipped away", "clipping at several planes removes all of them"},
    {"no area on the screen", "after snapping to 1/256 px they are lines or points"},
    {"turned away", "they show the side that is culled"},
    {"outside the picture", "they are outside the picture"},
    {"between pixel centres", "they are so small or thin that they cover no pixel's centre"},
    {"hidden", "at each of their pixels a nearer surface was drawn before them"},
    {"discarded", "their alpha is below the material's cutoff"},
    {"masked", "the colour mask lets no channel through"},
    {"overwritten", "nearer surfaces were drawn over them afterwards"},
    {"unchanged bytes", "they write the bytes that were there already"},
    {"partly visible", "some of their fragments are in the picture"},
    {"visible", "all their fragments are in the picture"},
    {"drawn as lines", "only their edges are drawn, as lines"},
};

const char* mistake_remedy(SetupChange change) {
  const auto all = convention_mistakes();
  return std::find_if(all.begin(), all.end(),
                      [&](const ConventionMistake& s) { return s.change == change; })
      ->remedy;
}

std::string lines_text(std::uint64_t pixels) {
  return fmt::format(
      "The picture is a wireframe: only the triangle's edges are drawn, which are visible in {}.",
      counted(pixels, "pixel"));
}

// What happened to each of the triangles into which clipping has cut this one.
std::string pieces_text(const TriangleVerdict& verdict) {
  std::vector<std::string> parts;
  if (verdict.pieces_set_up > 0) {
    parts.push_back(fmt::format("{} went on to coverage", verdict.pieces_set_up));
  }
  if (verdict.pieces_turned_away > 0) {
    parts.push_back(fmt::format("{} turned away", verdict.pieces_turned_away));
  }
  if (verdict.pieces_without_area > 0) {
    parts.push_back(fmt::format("{} without area on the screen", verdict.pieces_without_area));
  }
  const int pieces =
      verdict.pieces_set_up + verdict.pieces_turned_away + verdict.pieces_without_area;
  return fmt::format("Clipping cut it into {}: {}.", counted(pieces, "piece"),
                     list_in_words(parts));
}

// ---- fragments ----

std::string occluder_text(std::optional<std::uint32_t> number) {
  return number ? fmt::format("triangle {}", *number) : std::string("lines or points");
}

std::string occluders_text(const std::vector<Occluder>& occluders) {
  constexpr std::size_t kShown = 4;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(occluders.size(), kShown); ++i) {
    texts.push_back(
        fmt::format("{} ({})", occluder_text(occluders[i].number), occluders[i].pixels));
  }
  if (occluders.size() > kShown) texts.push_back(counted(occluders.size() - kShown, "other"));
  return list_in_words(texts);
}

std::string closest_text(const FragmentDetails::Hidden& h) {
  const std::string where = fmt::format(
      "The depths differ least at pixel ({}, {}), against {}: ", h.x, h.y, occluder_text(h.by));
  if (h.code == h.stored) {
    return where + fmt::format(
                       "both have depth code 0x{:08x} (distances {:.9g} and {:.9g}), and at equal "
                       "depths the first one drawn stays.",
                       h.code, h.distance, h.stored_distance);
  }
  return where +
         fmt::format(
             "depth code 0x{:08x} is larger than 0x{:08x} by {} (distances {:.9g} and {:.9g}).",
             h.code, h.stored, h.code - h.stored, h.distance, h.stored_distance);
}

// A part of the fragments in words: "all 12 fragments", "3 of 12 fragments".
std::string share_text(std::uint32_t part, std::uint32_t all) {
  if (part < all) return fmt::format("{} of {} fragments", part, all);
  return all == 1 ? "its only fragment" : fmt::format("all {} fragments", all);
}

std::string unchanged_text(const TriangleFragmentCounts& t, const FragmentDetails::Unchanged& u) {
  return fmt::format(
      "Of these, {} left the bytes of their pixel as they were, at ({}, {}) for one: ({}, {}, {}, "
      "{}){}.",
      t.unchanged == t.visible ? std::string("all") : std::to_string(t.unchanged), u.x, u.y,
      u.bytes.r, u.bytes.g, u.bytes.b, u.bytes.a,
      u.blended ? fmt::format(", with alpha {:.9g}", u.alpha) : "");
}

// One paragraph for each thing that happened to some fragments: visible, hidden, discarded and so
// on.
std::vector<std::string> explain_fragments(const TriangleVerdict& verdict) {
  std::vector<std::string> text;
  const TriangleFragmentCounts& t = verdict.fragments;
  const FragmentDetails& d = verdict.details;
  const auto share = [&](std::uint32_t part) { return share_text(part, t.covered); };
  if (t.visible > 0) {
    const PixelRect& box = d.visible_box;
    text.push_back(fmt::format("In the picture: {}, in columns {} .. {} and rows {} .. {}.",
                               share(t.visible), box.x0, box.x1 - 1, box.y0, box.y1 - 1));
    if (t.under_translucent > 0) {
      text.push_back(
          fmt::format("Translucent surfaces are drawn over {} of these.", t.under_translucent));
    }
    if (t.unchanged > 0) text.push_back(unchanged_text(t, *d.unchanged));
  }
  if (t.hidden > 0) {
    text.push_back(fmt::format("Failed the depth test: {}, behind {}.", share(t.hidden),
                               occluders_text(d.hidden_by)));
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
    text.push_back(
        fmt::format("Not written because of the colour mask, which lets no channel through: {}.",
                    share(t.masked)));
  }
  if (t.overwritten > 0) {
    text.push_back(fmt::format("Written, and later overwritten: {}, by {}.", share(t.overwritten),
                               occluders_text(d.overwritten_by)));
  }
  return text;
}

}  // namespace

const char* result_words(TriangleResult result) {
  return kResultTexts[std::size_t(result)].words;
}

const char* result_meaning(TriangleResult result) {
  return kResultTexts[std::size_t(result)].meaning;
}

std::string mesh_text(const Scene& scene, std::uint32_t instance) {
  const std::uint32_t mesh = scene.instances[instance].mesh;
  const std::string& name = scene.meshes[mesh].name;
  return "mesh " + (name.empty() ? std::to_string(mesh) : in_quotes(name));
}

std::string face_text(const Scene& scene, std::uint32_t instance, std::uint32_t face) {
  return fmt::format("face {} of {} (instance {})", face, mesh_text(scene, instance), instance);
}

std::string subpixels_text(double subpixels) {
  if (subpixels < kSubpixels) return fmt::format("{:.4g}/{} px", subpixels, kSubpixels);
  return fmt::format("{:.6g} px", subpixels / kSubpixels);
}

std::string list_in_words(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i > 0) text += i + 1 == parts.size() ? " and " : ", ";
    text += parts[i];
  }
  return text;
}

std::vector<std::string> explain(const ViewConventions& conventions) {
  std::vector<std::string> text;
  if (conventions.hands_mixed) {
    text.push_back(fmt::format(
        "Handedness is mixed: eye_from_world gives a {}-handed eye, which looks down {}z, but "
        "clip_from_eye takes {}z for the gaze. Points in front of the camera get w < 0, and points "
        "behind it are drawn. Remedy: {}.",
        conventions.right_handed_eye ? "right" : "left", conventions.right_handed_eye ? "-" : "+",
        conventions.gaze_is_minus_z ? "-" : "+", mistake_remedy(SetupChange::kEyeHand)));
  }
  if (conventions.opengl_range) {
    text.push_back(fmt::format(
        "The projection maps the near plane to depth {:.9g}, as for OpenGL's -w <= z <= w; but "
        "here only 0 <= z <= w is kept, so the nearest part of the scene is cut off. Remedy: {}.",
        conventions.near_depth, mistake_remedy(SetupChange::kDepthRange)));
  }
  return text;
}

std::vector<std::string> explain(const View& view, const TriangleVerdict& verdict) {
  std::vector<std::string> text;
  if (verdict.result == TriangleResult::kLines) {
    text.push_back(lines_text(verdict.line_pixels));
  } else if (verdict.result < TriangleResult::kHidden) {
    text = explain_geometry(view, verdict);
  } else {
    text = explain_fragments(verdict);
  }
  if (verdict.pieces_without_area + verdict.pieces_turned_away + verdict.pieces_set_up > 1) {
    text.push_back(pieces_text(verdict));
  }
  for (std::string& slip : explain(verdict.conventions)) text.push_back(std::move(slip));
  return text;
}

}  // namespace glassbox
