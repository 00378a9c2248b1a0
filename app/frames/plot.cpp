#include "app/frames/frames_report.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <glassbox/base/elementary.h>
#include <glassbox/html/escaped_html.h>

namespace glassbox::app {

namespace {

// Sizes in the SVG picture's own units, which are px if it is shown at full size.
constexpr double kWidth = 960, kLeft = 78, kRight = 170, kTop = 86, kGap = 62, kBottom = 52;
constexpr double kPlotWidth = kWidth - kLeft - kRight;

constexpr const char* kStyle = R"(
    svg { background: #fff; font: 13px system-ui, sans-serif; }
    text { fill: #171b22; } .quiet { fill: #566071; } .head { font-weight: 600; }
    .grid { stroke: #d3d7de; } .axis { stroke: #566071; }
    .line { fill: none; stroke-width: 2; stroke-linejoin: round; } .limit { stroke: #b3261e; stroke-dasharray: 7 5; }
    .main { stroke: #1456c4; } .front { stroke: #b35300; } .behind { stroke: #1456c4; }
    circle.main, circle.behind { fill: #1456c4; } circle.front { fill: #b35300; }
    .front-text { fill: #b35300; } .behind-text { fill: #1456c4; } .limit-text { fill: #b3261e; }
    @media (prefers-color-scheme: dark) {
      svg { background: #14171c; } text { fill: #eef1f5; } .quiet { fill: #a6b0bf; }
      .grid { stroke: #353c47; } .axis { stroke: #a6b0bf; } .limit { stroke: #ff8a80; }
      .main, .behind { stroke: #7fb2ff; } .front { stroke: #ff9a4d; }
      circle.main, circle.behind { fill: #7fb2ff; } circle.front { fill: #ff9a4d; }
      .front-text { fill: #ff9a4d; } .behind-text { fill: #7fb2ff; } .limit-text { fill: #ff8a80; }
    }
)";

struct PlottedCurve {
  std::string style;
  std::vector<double> values;
};

// A text to the right of the plot, at the height of the value that it names.
struct Label {
  std::string style, text;
  double at = 0;
};

struct Panel {
  std::string title;
  double height = 0;
  std::vector<PlottedCurve> curves;
  std::vector<double> limits;
  std::vector<Label> labels;
  double low = 0, high = 1;  // the range of the vertical axis
};

// ---- marks; a `style` is a class of the style sheet ----

// `anchor`: which end of the text stands at x, "start", "middle" or "end".
std::string svg_text(double x, double y, const std::string& style, const char* anchor,
                     const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"{}\" text-anchor=\"{}\">{}</text>\n",
                     x, y, style, anchor, escaped_html(text));
}

std::string svg_line(const std::string& style, double x0, double y0, double x1, double y1) {
  return fmt::format(
      "<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", style, x0,
      y0, x1, y1);
}

// The distance between tick marks: 1, 2 or 5 times a power of ten, so that the range has at most
// `most` steps.
double tick_step(double range, int most) {
  const double least = range / most;
  const double power = power_of_ten(int(std::floor(logarithm_10(least))));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

// ---- axes ----

std::string number(double value) {
  return fmt::format("{:.6g}", value == 0 ? 0.0 : value);
}

// Sets the vertical range so that it contains all curves and limits, and zero.
void fit(Panel& panel) {
  double low = 0, high = 0;
  const auto show = [&](double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const PlottedCurve& curve : panel.curves) std::ranges::for_each(curve.values, show);
  std::ranges::for_each(panel.limits, show);
  if (!(high - low > 0)) high = 1;
  const double margin = (high - low) * 0.06;
  panel.low = low < 0 ? low - margin : low;
  panel.high = high + margin;
}

class Drawing {
public:
  explicit Drawing(const FramesReport& report) : report_(report) {}

  void draw(const Panel& panel, double top) {
    const auto y_of = [&](double value) {
      return top + panel.height * (panel.high - value) / (panel.high - panel.low);
    };
    text(kLeft - 60, top - 12, "head", "start", panel.title);
    const double step = tick_step(panel.high - panel.low, panel.height > 150 ? 8 : 4);
    for (double k = std::ceil(panel.low / step); k * step <= panel.high; ++k) {
      line(k == 0 ? "axis" : "grid", kLeft, y_of(k * step), kLeft + kPlotWidth, y_of(k * step));
      text(kLeft - 8, y_of(k * step) + 4, "quiet", "end", number(k * step));
    }
    draw_frame_ticks(top, panel.height);
    for (const double limit : panel.limits) {
      line("line limit", kLeft, y_of(limit), kLeft + kPlotWidth, y_of(limit));
    }
    for (const PlottedCurve& curve : panel.curves) draw_curve(curve, y_of);
    for (const Label& label : panel.labels) {
      text(kLeft + kPlotWidth + 10, y_of(label.at) + 4, label.style, "start", label.text);
    }
  }

  void text(double x, double y, const std::string& style, const char* anchor,
            const std::string& what) {
    body_ += svg_text(x, y, style, anchor, what);
  }

  const std::string& body() const { return body_; }

private:
  double x_of(std::size_t i) const {
    const std::size_t count = report_.frames.size();
    return kLeft + (count == 1 ? 0.5 : double(i) / double(count - 1)) * kPlotWidth;
  }

  void line(const std::string& style, double x0, double y0, double x1, double y1) {
    body_ += svg_line(style, x0, y0, x1, y1);
  }

  void draw_frame_ticks(double top, double height) {
    const std::size_t count = report_.frames.size();
    const auto step = std::size_t(std::max(1.0, tick_step(double(count), 10)));
    const double bottom = top + height;
    // Tick marks are at the first frame and at round frame numbers.
    for (std::size_t number = 1; number <= count;
         number += number == 1 && step > 1 ? step - 1 : step) {
      const double x = x_of(number - 1);
      line("axis", x, bottom, x, bottom + 5);
      text(x, bottom + 19, "quiet", "middle", std::to_string(number));
    }
  }

  template <class YOf>
  void draw_curve(const PlottedCurve& curve, const YOf& y_of) {
    std::string points;
    for (std::size_t i = 0; i < curve.values.size(); ++i) {
      points += fmt::format("{}{:.1f},{:.2f}", i == 0 ? "" : " ", x_of(i), y_of(curve.values[i]));
    }
    if (curve.values.size() == 1) {
      body_ += fmt::format("  <circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.2f}\" r=\"4\"/>\n",
                           curve.style, x_of(0), y_of(curve.values[0]));
      return;
    }
    body_ += fmt::format("  <polyline class=\"line {}\" points=\"{}\"/>\n", curve.style, points);
  }

  const FramesReport& report_;
  std::string body_;
};

// ---- what is shown ----

template <class ValueOf>
std::vector<double> values_of(const FramesReport& report, const ValueOf& value_of) {
  std::vector<double> values;
  for (const FrameRecord& frame : report.frames) values.push_back(value_of(frame));
  return values;
}

std::vector<Panel> panels_of(const FramesReport& report) {
  const double per_px = 100.0 / report.size.width;
  std::vector<Panel> panels;
  panels.push_back({"Separation of the eyes (world units)", 140, {}, {}, {}});
  panels.back().curves.push_back(
      {"main", values_of(report, [](const FrameRecord& f) { return 2 * f.pair.half_separation; })});
  const std::vector<double> windows =
      values_of(report, [](const FrameRecord& f) { return f.pair.window; });
  if (std::ranges::all_of(windows, [](double window) { return std::isfinite(window); })) {
    panels.push_back({"Distance of the window (world units)", 110, {}, {}, {}});
    panels.back().curves.push_back({"main", windows});
  }
  const double front_limit = -report.budget.in_front_px * per_px;
  const double behind_limit = report.budget.behind_px * per_px;
  Panel parallax{
      "Largest parallax (per cent of the width)", 230, {}, {front_limit, behind_limit}, {}};
  parallax.curves = {
      {"behind", values_of(report, [&](const FrameRecord& f) { return f.behind_px * per_px; })},
      {"front", values_of(report, [&](const FrameRecord& f) { return -f.in_front_px * per_px; })}};
  panels.push_back(std::move(parallax));
  for (Panel& panel : panels) fit(panel);
  Panel& last = panels.back();
  last.labels = {{"behind-text", "behind the window", last.high * 0.5},
                 {"front-text", "in front of it", last.low * 0.5},
                 {"limit-text", "budget " + number(behind_limit) + " %", behind_limit},
                 {"limit-text", "budget " + number(-front_limit) + " %", front_limit}};
  return panels;
}

std::string plot_description(const FramesReport& report) {
  const auto largest = [&](const auto& value_of) {
    const std::vector<double> values = values_of(report, value_of);
    return *std::ranges::max_element(values);
  };
  const double per_px = 100.0 / report.size.width;
  return fmt::format(
      "Over {} frames the eye separation begins at {:.4g}, is at most {:.4g} and ends at {:.4g}. "
      "The largest parallax in front of the window is {:.2f} per cent of the width ({:.2f} "
      "allowed), and behind it {:.2f} ({:.2f} allowed).",
      report.frames.size(), 2 * report.frames.front().pair.half_separation,
      largest([](const FrameRecord& f) { return 2 * f.pair.half_separation; }),
      2 * report.frames.back().pair.half_separation,
      largest([](const FrameRecord& f) { return f.in_front_px; }) * per_px,
      report.budget.in_front_px * per_px,
      largest([](const FrameRecord& f) { return f.behind_px; }) * per_px,
      report.budget.behind_px * per_px);
}

}  // namespace

std::string plot_svg(const FramesReport& report) {
  const std::vector<Panel> panels = panels_of(report);
  const std::string title = report.path.empty()
                                ? report.scene + " on a turntable"
                                : fmt::format("{} along {}", report.scene, report.path);
  Drawing drawing(report);
  drawing.text(kLeft - 60, 28, "head", "start", title);
  drawing.text(kLeft - 60, 48, "quiet", "start",
               fmt::format("{} frames of {} x {} px", report.frames.size(), report.size.width,
                           report.size.height));
  double top = kTop;
  for (const Panel& panel : panels) {
    drawing.draw(panel, top);
    top += panel.height + kGap;
  }
  const double height = top - kGap + kBottom;
  drawing.text(kLeft + kPlotWidth / 2, height - 12, "quiet", "middle", "frame");
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\" "
      "role=\"img\" aria-labelledby=\"title desc\">\n"
      "  <title id=\"title\">Comfort of {2}</title>\n  <desc id=\"desc\">{3}</desc>\n"
      "  <style>{4}  </style>\n{5}</svg>\n",
      kWidth, height, escaped_html(title), escaped_html(plot_description(report)), kStyle,
      drawing.body());
}

}  // namespace glassbox::app
