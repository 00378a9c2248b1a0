// Measures the cost of watching a run (D-29).
#include <memory>

#include <glassbox/mesh/builtin/scenes.h>
#include <glassbox/pipeline/framing.h>
#include <glassbox/render/staged/staged.h>
#include <glassbox/render/trace/tracer.h>

#include "study/experiment/experiment.h"

namespace glassbox::study {

namespace d29 {

struct TracedScene {
  std::string name;
  Scene scene;
  View view;
  RenderSettings settings;
};

std::shared_ptr<const TracedScene> make_traced_scene(const std::string& name, int width,
                                                     int height) {
  auto made = std::make_shared<TracedScene>();
  made->name = name;
  made->scene = make_builtin(name).value();
  const double aspect = double(width) / height;
  const Camera camera = made->scene.cameras.empty() ? framing_camera(made->scene, aspect).value()
                                                    : made->scene.cameras.front();
  made->view = make_view(camera, width, height).value();
  made->settings.want_depth = true;
  return made;
}

// ---- methods to run it ----

// An observer that every stage calls; it counts the events and stores nothing else.
class Counter : public Observer {
public:
  void projected(const Draw&, std::uint32_t, Point<Clip>&) override { ++events; }
  void clipped(const PrimitiveStage&, const Triangle&, const std::array<ClipVertex, 3>&,
               ClipPolygon&) override {
    ++events;
  }
  void divided(const ClipVertex&, NdcVertex&) override { ++events; }
  void mapped_to_screen(const NdcVertex&, ScreenVertex&) override { ++events; }
  void set_up(std::uint32_t, const std::array<ScreenVertex, 3>&,
              std::optional<TriangleSetup>&) override {
    ++events;
  }
  void interpolated(const FragmentSource&, const Coverage&, Fragment&) override { ++events; }
  void compared(const FragmentSource&, const Fragment&, std::uint32_t, std::uint32_t,
                bool&) override {
    ++events;
  }
  void lit(const Varyings&, const Rgba&, Rgba&) override { ++events; }
  void fragment_finished(const FragmentSource&, const Fragment&, FragmentResult) override {
    ++events;
  }

  std::uint64_t events = 0;
};

Rendering run_untraced(const TracedScene& w) {
  return render_staged(w.scene, w.view, w.settings);
}
Rendering run_counted(const TracedScene& w) {
  Counter counter;
  return render_staged(w.scene, w.view, w.settings, &counter);
}
Rendering run_filtered(const TracedScene& w) {
  TraceFilter filter;
  const int x = int(w.view.viewport.width()) / 2, y = int(w.view.viewport.height()) / 2;
  filter.pixels = PixelRect{x, y, x + 1, y + 1};
  return trace(w.scene, w.view, w.settings, filter).rendering;
}
Rendering run_dumped(const TracedScene& w) {
  return trace(w.scene, w.view, w.settings, TraceFilter{}).rendering;
}
// Every stage calls an observer that does nothing.
Rendering run_observed(const TracedScene& w) {
  Observer nothing;
  return render_staged(w.scene, w.view, w.settings, &nothing);
}

struct Method {
  const char* name;
  double records;  // value on the axis
  Rendering (*run)(const TracedScene&);
};
constexpr Method kMethods[] = {
    {"no observer: its calls are not compiled", 0, run_untraced},
    {"an observer that is called at every stage and does nothing", 1, run_observed},
    {"an observer that counts at every stage", 2, run_counted},
    {"a trace of one pixel", 3, run_filtered},
    {"full trace", 4, run_dumped}};

double differing_pixels(const Framebuffer& one, const Framebuffer& other) {
  double count = 0;
  for (std::size_t i = 0; i < one.color.pixels.size(); ++i)
    count += one.color.pixels[i] != other.color.pixels[i] ||
             one.depth.pixels[i] != other.depth.pixels[i];
  return count;
}

std::vector<Configuration> configurations(Effort effort) {
  std::vector<std::string> names{"cube", "teapot:4"};
  if (effort == Effort::kFull) names = {"cube", "teapot", "forest", "room", "f-glyph", "checker"};
  std::vector<Configuration> all;
  for (const std::string& name : names) {
    const auto w = make_traced_scene(name, 160, 120);
    for (const Method& method : kMethods) {
      all.push_back(
          {.series = method.name,
           .parameter = method.records,
           .scene = name,
           .error =
               [=] { return differing_pixels(method.run(*w).buffers, run_untraced(*w).buffers); },
           .predicted_error = 0,
           .work = [=](int) { method.run(*w); }});
    }
  }
  return all;
}

}  // namespace d29

Experiment d29_trace() {
  using namespace d29;
  return {
      .id = "D-29",
      .name = "Trace: the cost of observing a run",
      .question =
          "How much time does it cost to make a run observable, and how much to observe it?",
      .axis =
          "0: no calls in the code, 1: all stages call an observer, 2: it counts at all stages, 3: "
          "one pixel is recorded, 4: everything is recorded",
      .logarithmic_axis = false,
      .error = "pixels whose colour or depth differ",
      .error_unit = "pixels",
      .reference = "the picture of a run without an observer",
      .theory =
          "An observer changes no pixel, so the number is 0. The observer is a template parameter, "
          "so a run without an observer is compiled without its calls.",
      .item = "picture",
      .configurations = configurations,
  };
}

}  // namespace glassbox::study
