#include "app/why/verdict_text.h"

#include <algorithm>

#include <fmt/format.h>

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

#include "app/step/matrices/slips.h"
#include "app/why/verdict_paragraphs.h"

namespace glassbox {

namespace {

const char* slip_remedy(Change change) {
  const auto all = slips();
  return std::find_if(all.begin(), all.end(), [&](const Slip& s) { return s.change == change; })
      ->remedy;
}

std::string lines_text(std::uint64_t pixels) {
  return fmt::format(
      "The picture is a wireframe: of the triangle its edges are drawn, which are seen in {}.",
      counted(pixels, "pixel"));
}

// Of cut triangles, pieces may fare differently.
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
  return fmt::format("Clipping cut it into {} pieces: {}.", pieces, listed(parts));
}

}  // namespace

const char* words_for(End end) {
  constexpr const char* kWords[kEnds] = {"no area as modelled",
                                         "not finite",
                                         "behind the eye",
                                         "outside one plane",
                                         "clipped away",
                                         "no area on the screen",
                                         "turned away",
                                         "outside the picture",
                                         "between pixel centres",
                                         "hidden",
                                         "discarded",
                                         "masked",
                                         "overwritten",
                                         "unchanged bytes",
                                         "partly visible",
                                         "visible",
                                         "drawn as lines"};
  return kWords[std::size_t(end)];
}

const char* meaning_of(End end) {
  constexpr const char* kMeanings[kEnds] = {
      "their corners lie on a line or in a point, so they are never drawn",
      "a corner overflows float on the way to clip space",
      "every w, the distance along the gaze, is 0 or less: the camera looks the other way",
      "all corners lie outside one plane: near, far or the guard band",
      "several planes together leave nothing of them",
      "after snapping to 1/256 px they are lines or points",
      "they show the side that is culled",
      "they lie beside the picture",
      "they are so small or thin that they cover no pixel's centre",
      "something nearer was drawn before them wherever they are",
      "their alpha is below the material's cutoff",
      "the colour mask lets no channel through",
      "something nearer was drawn over them afterwards",
      "what they write are the bytes that were there",
      "some of their fragments are in the picture",
      "all their fragments are in the picture",
      "their edges are drawn, not their insides"};
  return kMeanings[std::size_t(end)];
}

std::string mesh_text(const Scene& scene, std::uint32_t instance) {
  const std::uint32_t mesh = scene.instances[instance].mesh;
  const std::string& name = scene.meshes[mesh].name;
  return "mesh " + (name.empty() ? std::to_string(mesh) : in_quotes(name));
}

std::string place_of(const Scene& scene, std::uint32_t instance, std::uint32_t face) {
  return fmt::format("face {} of {} (instance {})", face, mesh_text(scene, instance), instance);
}

std::string subpixels_text(double subpixels) {
  if (subpixels < kSubpixels) return fmt::format("{:.4g}/{} px", subpixels, kSubpixels);
  return fmt::format("{:.6g} px", subpixels / kSubpixels);
}

std::string listed(const std::vector<std::string>& parts) {
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
        "clip_from_eye takes {}z for the gaze. Whatever is in front of the camera gets w < 0, and "
        "what is behind it is drawn. Remedy: {}.",
        conventions.right_handed_eye ? "right" : "left", conventions.right_handed_eye ? "-" : "+",
        conventions.gaze_is_minus_z ? "-" : "+", slip_remedy(Change::kEyeHand)));
  }
  if (conventions.opengl_range) {
    text.push_back(fmt::format(
        "The projection carries the near plane to depth {:.9g}, as OpenGL's -w <= z <= w has it; "
        "here what is kept has 0 <= z <= w, so the nearest part of the scene is cut off. Remedy: "
        "{}.",
        conventions.near_depth, slip_remedy(Change::kDepthRange)));
  }
  return text;
}

std::vector<std::string> explain(const View& view, const TriangleVerdict& verdict) {
  std::vector<std::string> text;
  if (verdict.end == End::kLines) {
    text.push_back(lines_text(verdict.line_pixels));
  } else if (verdict.end < End::kHidden) {
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
