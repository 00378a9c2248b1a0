#include "app/pixel/history_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/why/verdict_text.h"
#include "cli/report/text_layout.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/printable.h>

namespace glassbox::app {

namespace {

constexpr std::size_t kMissesShown = 3;

std::string shortened(const std::string& text, std::size_t width) {
  return printable(text, text.size() > width ? width - 3 : width);
}

// The face and its mesh, "12 of teapot", with the material if it has a name.
std::string surface_text(const Scene& scene, const PixelEvent& event) {
  const Mesh& mesh = scene.meshes[scene.instances[event.instance].mesh];
  const std::string& material = scene.materials[mesh.material].name;
  const std::string whose = mesh.name.empty() ? mesh_text(scene, event.instance) : mesh.name;
  std::string text = event.source.is_triangle ? fmt::format("{} of {}", event.face, whose)
                                              : "line/point of " + whose;
  if (!material.empty() && material != mesh.name) text += ", " + material;
  return text;
}

std::string row(const std::string& number, const std::string& triangle, const std::string& surface,
                const std::string& fate, const std::string& distance, const std::string& code,
                const std::string& bytes) {
  std::string text = fmt::format("  {:>3} {:>8}  {:<28}{:<13}{:<12}{:<10}{}", number, triangle,
                                 shortened(surface, 27), fate, distance, code, bytes);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

std::string indented_note(const std::string& text) {
  return wrapped(std::string(15, ' '), text);
}

std::string depth_note(const PixelEvent& event, const std::vector<PixelEvent>& events) {
  if (!event.stored_by) return {};
  const PixelEvent& by = events[*event.stored_by];
  if (event.code == event.stored) {
    return fmt::format("the same depth code as #{}; at equal depths the first one drawn stays",
                       *event.stored_by);
  }
  return fmt::format(
      "behind #{}: depth code {:08x} is not below {:08x}; the distance is {:.9g} larger",
      *event.stored_by, event.code, event.stored, event.distance - by.distance);
}

// What there is to say about an event besides its row in the table; empty if the row says all.
std::string event_note(const PixelHistory& history, const PixelEvent& event) {
  std::string text;
  switch (event.kind) {
    case PixelEventKind::kClipped:
      return fmt::format(
          "the {} plane cut off its {}, which would be at this pixel (it is {:.9g} outside)",
          event.plane, event.front ? "front" : "back", -event.inside);
    case PixelEventKind::kTurnedAway:
      return fmt::format("shows its {}: signed area {:.9g} px^2, counter-clockwise is positive",
                         event.front ? "front" : "back", event.area_px2);
    case PixelEventKind::kHidden:
      return depth_note(event, history.events);
    case PixelEventKind::kDiscarded:
      return fmt::format("alpha {:.9g} is below the cutoff, {:.9g}", event.alpha, event.cutoff);
    case PixelEventKind::kMasked:
      return event.writes_depth ? "the colour mask lets nothing through; its depth is written"
                                : "the colour mask lets nothing through";
    case PixelEventKind::kBlended:
      text = fmt::format("light ({:.4g}, {:.4g}, {:.4g}) with alpha {:.4g} over {}", event.light.r,
                         event.light.g, event.light.b, event.alpha, bytes_text(event.before));
      break;
    case PixelEventKind::kWritten:
      break;
  }
  if (event.overwritten_by) {
    text += (text.empty() ? "" : "; ") + fmt::format("overwritten by #{}", *event.overwritten_by);
  }
  return text;
}

std::string event_text(const Scene& scene, const PixelHistory& history, std::size_t i) {
  const PixelEvent& event = history.events[i];
  const bool drawn = event.kind >= PixelEventKind::kMasked;
  std::string text = row(
      fmt::format("#{}", i), event.source.is_triangle ? std::to_string(event.source.number) : "",
      surface_text(scene, event), name_of(event.kind),
      event.kind == PixelEventKind::kTurnedAway ? "" : fmt::format("{:.9g}", event.distance),
      is_fragment(event) ? fmt::format("{:08x}", event.code) : "",
      drawn ? bytes_text(event.after) : "");
  const std::string more = event_note(history, event);
  return more.empty() ? text : text + indented_note(more);
}

std::string misses_text(const Scene& scene, const PixelHistory& history, bool all) {
  const std::size_t shown =
      all ? history.misses.size() : std::min(kMissesShown, history.misses.size());
  std::string text = fmt::format("\n{} whose box reaches into the pixel {} its centre{}\n",
                                 counted(history.misses.size(), "triangle"),
                                 singular_or_plural(history.misses.size(), "misses", "miss"),
                                 shown < history.misses.size()
                                     ? fmt::format("; the nearest {} (--all lists them):", shown)
                                     : ":");
  for (std::size_t i = 0; i < shown; ++i) {
    const PixelMiss& missed = history.misses[i];
    const std::string how =
        missed.miss.value == 0
            ? std::string("the centre is on an edge that belongs to the neighbour")
            : fmt::format("past an edge by {} (edge function {})",
                          subpixels_text(missed.miss.subpixels), missed.miss.value);
    PixelEvent event;
    event.instance = missed.instance;
    event.face = missed.face;
    text += fmt::format("      {:>8}  {:<28}{}\n", missed.number,
                        shortened(surface_text(scene, event), 27), how);
  }
  return text;
}

std::string last_line(const Scene& scene, const PixelHistory& history) {
  const std::string bytes = bytes_text(history.shown);
  if (!history.shows_bytes) {
    return fmt::format("the picture shows {}, which --show computes after the last fragment\n",
                       bytes);
  }
  if (!history.shows) return fmt::format("the picture shows {}, which is the background\n", bytes);
  const PixelEvent& event = history.events[*history.shows];
  const std::string what = event.source.is_triangle
                               ? fmt::format("triangle {}", event.source.number)
                               : "a line or a point of " + mesh_text(scene, event.instance);
  return fmt::format("the picture shows {}: #{}, {}{}\n", bytes, *history.shows, what,
                     event.kind == PixelEventKind::kBlended
                         ? ", blended over the colour that was there before"
                         : "");
}

}  // namespace

std::string history_text(const Scene& scene, const PixelHistory& history, bool all_misses,
                         const std::vector<std::string>& notes) {
  std::string text =
      row("", "triangle", "face of mesh, material", "fate", "distance", "depth", "pixel after");
  text += row("", "", "", "cleared", "", "ffffffff", bytes_text(history.cleared));
  for (std::size_t i = 0; i < history.events.size(); ++i) text += event_text(scene, history, i);
  if (!history.misses.empty()) text += misses_text(scene, history, all_misses);
  if (history.without_area > 0) {
    text += fmt::format("\n{} without area after snapping, not in this list\n",
                        counted(history.without_area, "triangle"));
  }
  if (!history.complete)
    text += "\nthe history is incomplete: all of it would take too much memory\n";
  for (const std::string& note : notes) text += "\n" + wrapped("", note);
  return text + "\n" + last_line(scene, history);
}

}  // namespace glassbox::app
