// Stage 9 of a stepped triangle: one of its fragments.
#include <fmt/format.h>

#include "app/step/number_text.h"
#include "app/step/stage_texts.h"
#include "cli/report/text_layout.h"

#include <glassbox/matrices/decimal.h>

namespace glassbox::app {

namespace {

std::string line(const std::string& text) {
  return "     " + text + "\n";
}

std::string color_text(const Rgba& c) {
  return fmt::format("({}, {}, {}, {})", short_number(double(c.r)), short_number(double(c.g)),
                     short_number(double(c.b)), short_number(double(c.a)));
}

std::string weights_text(const TracedFragment& traced, const TriangleSetup& setup,
                         const FragmentBounds& bounds) {
  std::string text = sentence(
      "at each corner, in the order of the setup: the edge function E, lambda = E over twice the "
      "area, and the weight after perspective");
  for (std::size_t k = 0; k < 3; ++k) {
    text += line(fmt::format(
        "  {}  {:>16} / {}   {:>12} {:<11} {:>12} {}", setup.order[k], traced.coverage.edges[k],
        setup.double_area, short_number(double(traced.fragment.lambda[k])),
        bound_text(bounds.lambda[k]), short_number(double(traced.fragment.weights[k])),
        bound_text(bounds.weights[k])));
  }
  return text;
}

std::string depth_text(const SteppedTriangle& stepped, const TracedFragment& traced,
                       const FragmentBounds& bounds, bool bits) {
  const View& view = stepped.chosen.view;
  const Fragment& f = traced.fragment;
  std::string text = line(number_line("z", f.depth, bounds.depth, bits) + "  depth of NDC");
  text += line(number_line("1/w", f.inverse_w, bounds.inverse_w, bits));
  if (view.perspective) {
    const double distance = 1 / double(f.inverse_w);
    text += line(fmt::format("{:<4} {:>16}  {:<12}  distance along the gaze", "w",
                             short_number(distance, 9), bound_text(bounds.distance)));
    text += sentence(fmt::format(
        "the bound of z corresponds to a distance of {} here",
        short_number(distance_of_depth(distance, view.near, view.far, bounds.depth), 2)));
  }
  const std::string stored = traced.stored == kEmptyDepth ? "the depth code of the cleared buffer"
                                                          : fmt::format("{:#010x}", traced.stored);
  return text +
         sentence(fmt::format("depth test: code {:#010x} is {}below {}", traced.code,
                              traced.result == FragmentResult::kHidden ? "not " : "", stored));
}

std::string colour_text(const TracedFragment& traced, const RenderSettings& settings) {
  std::string text = sentence("surface " + color_text(traced.surface) +
                              ", linear: the product of material, vertex colour and texture");
  if (traced.result == FragmentResult::kDiscarded)
    return text + sentence("its alpha is below the material's cutoff: discarded");
  if (settings.show == Show::kColor) {
    const auto& [r, g, b] = traced.emission;
    const bool emits = r != 0 || g != 0 || b != 0;
    if (emits) {
      text += line(fmt::format("emitted  ({}, {}, {}), linear", short_number(double(r)),
                               short_number(double(g)), short_number(double(b))));
    }
    text += line("lit      " + color_text(traced.light) + ", linear" +
                 (emits ? ", with the emitted light" : ""));
  }
  text += sentence(fmt::format(
      "pixel   {} -> {}{}", bytes_text(traced.before), bytes_text(traced.after),
      traced.result == FragmentResult::kBlended ? ", blended over what was there" : ""));
  return text;
}

}  // namespace

std::string fragment_text(const SteppedTriangle& stepped, const TracedFragment& traced, bool bits) {
  const TracedPiece& piece = stepped.triangle->pieces[traced.source.piece];
  const FragmentBounds bounds =
      fragment_bounds(*piece.setup, traced.fragment, setup_bounds(piece, stepped.bounds));
  std::string text = sentence(fmt::format(
      "the fragment of pixel ({}, {}){}", traced.fragment.x, traced.fragment.y,
      stepped.triangle->pieces.size() > 1 ? fmt::format(", of piece {}", traced.source.piece)
                                          : ""));
  text += weights_text(traced, *piece.setup, bounds);
  text += depth_text(stepped, traced, bounds, bits);
  if (traced.result != FragmentResult::kHidden) text += colour_text(traced, stepped.trace.settings);
  return text;
}

}  // namespace glassbox::app
