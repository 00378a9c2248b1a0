#include "app/bench/page.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/bench/text.h"
#include "app/report/svg.h"
#include "bench_page.h"  // made by html/embed.cmake

#include <glassbox/base/counted.h>
#include <glassbox/html/escaped.h>

namespace glassbox::app {

namespace {

using study::Measurement;
using study::Scaling;
using study::ScalingPoint;

// In the picture's own units.
constexpr double kWidth = 960, kLeft = 150, kRight = 150;
constexpr double kPlotWidth = kWidth - kLeft - kRight;
constexpr double kLetter = 7.2;  // the width of an average one in the font of the pictures

std::string svg(double height, const std::string& told, const std::string& body) {
  return fmt::format("<svg viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"{}\">\n{}</svg>\n",
                     kWidth, height, told, body);
}

// ---- bars ----

struct Bar {
  const char* style;
  double ms;
};

std::vector<Bar> bars_of(const BenchReport& report, const Measurement& result) {
  std::vector<Bar> bars{{"ours", result.ms.median}};
  if (result.against) bars.push_back({"peer", result.against->ms.median});
  if (const study::Floor* floor = report.floor_of(result)) {
    bars.push_back({"floor", study::floor_ms(*floor, result.least)});
  }
  return bars;
}

// UTF-8: a letter begins at a byte that does not continue one.
bool begins_letter(char c) {
  return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
}
std::ptrdiff_t letters_of(const std::string& text) {
  return std::ranges::count_if(text, begins_letter);
}

// The end of a text of more than so many letters: of a path, the file's name.
std::string shortened(const std::string& text, std::ptrdiff_t letters) {
  std::ptrdiff_t left_out = letters_of(text) - letters;
  if (left_out <= 0) return text;
  const auto from =
      std::ranges::find_if(text, [&](char c) { return begins_letter(c) && --left_out < 0; });
  return "…" + std::string(from, text.end());
}

// Where the bars lie: all on one scale, so that their lengths compare from scene to scene.
struct BarPlot {
  double left = 0, width = 0;
  double longest_ms = 0, step_ms = 0;

  double length(double ms) const { return width * ms / longest_ms; }
};

constexpr std::ptrdiff_t kLabelLetters = 40;
std::string label_of(const Measurement& result) {
  return shortened(result.scene, kLabelLetters) + ", " + counted(result.threads, "thread");
}

BarPlot plot_of(const BenchReport& report) {
  BarPlot plot;
  std::ptrdiff_t letters = 0;
  for (const Measurement& result : report.results) {
    letters = std::max(letters, letters_of(label_of(result)));
    for (const Bar& bar : bars_of(report, result)) {
      plot.longest_ms = std::max(plot.longest_ms, bar.ms);
    }
  }
  plot.left = kLetter * double(letters) + 10;
  plot.width = kWidth - plot.left - kRight - 70;  // behind the longest bar stand its milliseconds
  plot.step_ms = tick_step(plot.longest_ms, 4);
  return plot;
}

constexpr double kAxisHeight = 24;

std::string bar_grid(const BarPlot& plot, double bottom) {
  std::string body;
  for (int i = 0; i * plot.step_ms <= plot.longest_ms; ++i) {
    const double ms = i * plot.step_ms, x = plot.left + plot.length(ms);
    body += svg_line("grid", x, kAxisHeight - 6, x, bottom);
    body += svg_text(x, kAxisHeight - 11, "quiet", "middle", fmt::format("{:g} ms", ms));
  }
  return body;
}

std::string bar_chart(const BenchReport& report) {
  constexpr double kBar = 13, kGap = 10;
  const BarPlot plot = plot_of(report);
  std::string body;
  double y = kAxisHeight;
  for (const Measurement& result : report.results) {
    body += svg_text(plot.left - 10, y + kBar - 2, "", "end", label_of(result));
    if (result.against) {
      body += svg_text(kWidth, y + kBar - 2, "", "end", "ratio " + three_digits(result.ratio()));
    }
    for (const Bar& bar : bars_of(report, result)) {
      const double length = plot.length(bar.ms);
      body += fmt::format(
          "<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.3f}\" height=\"{}\"/>\n",
          bar.style, plot.left, y, length, kBar - 2);
      body += svg_text(plot.left + length + 6, y + kBar - 2, "quiet", "start",
                       three_digits(bar.ms) + " ms");
      y += kBar;
    }
    y += kGap;
  }
  return svg(y, "Milliseconds for each frame; the numbers below are the same",
             bar_grid(plot, y - kGap / 2) + body);
}

// ---- curves ----

// Both axes logarithmic, around the points.
struct Axis {
  double low = 0, high = 0;  // powers of ten

  template <class ValueOf>
  static Axis around(const std::vector<ScalingPoint>& points, const ValueOf& value_of) {
    Axis axis{1e9, -1e9};
    for (const ScalingPoint& point : points) {
      axis.low = std::min(axis.low, std::floor(std::log10(value_of(point))));
      axis.high = std::max(axis.high, std::ceil(std::log10(value_of(point))));
    }
    axis.high = std::max(axis.high, axis.low + 1);
    return axis;
  }
  double at(double value) const { return (std::log10(value) - low) / (high - low); }
};

std::string curve_chart(const Scaling& scaling) {
  constexpr double kTop = 12, kHeight = 300;
  const auto ms_of = [](const ScalingPoint& point) { return point.ms.median; };
  const Axis x_axis = Axis::around(scaling.points, [](const ScalingPoint& p) { return p.x; });
  const Axis y_axis = Axis::around(scaling.points, ms_of);
  const auto x_at = [&](double x) { return kLeft + kPlotWidth * x_axis.at(x); };
  const auto y_at = [&](double ms) { return kTop + kHeight * (1 - y_axis.at(ms)); };
  std::string body;
  for (double power = x_axis.low; power <= x_axis.high; ++power) {
    const double x = x_at(std::pow(10, power));
    body += svg_line("grid", x, kTop, x, kTop + kHeight);
    body += svg_text(x, kTop + kHeight + 18, "quiet", "middle",
                     fmt::format("{:g}", std::pow(10, power)));
  }
  for (double power = y_axis.low; power <= y_axis.high; ++power) {
    const double y = y_at(std::pow(10, power));
    body += svg_line("grid", kLeft, y, kLeft + kPlotWidth, y);
    body += svg_text(kLeft - 8, y + 4, "quiet", "end", fmt::format("{:g} ms", std::pow(10, power)));
  }
  std::string points;
  for (const ScalingPoint& point : scaling.points) {
    points += fmt::format("{:.1f},{:.1f} ", x_at(point.x), y_at(ms_of(point)));
    body += fmt::format("<circle class=\"ours\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4\"/>\n",
                        x_at(point.x), y_at(ms_of(point)));
  }
  body += fmt::format("<polyline class=\"curve\" points=\"{}\"/>\n", points);
  if (scaling.bend) {
    const double x = x_at(scaling.bend->at);
    body += svg_line("law", x, kTop, x, kTop + kHeight);
  }
  body += svg_text(kLeft + kPlotWidth / 2, kTop + kHeight + 38, "quiet", "middle",
                   std::string(name_of(scaling.by)));
  return svg(kTop + kHeight + 48, "Time against " + std::string(name_of(scaling.by)), body);
}

// What the bars are; which colour is whose, where there is more than one.
std::string heading(const BenchReport& report) {
  std::vector<std::pair<const char*, std::string>> series{{"ours", "Glassbox"}};
  const auto peer = std::ranges::find_if(
      report.results, [](const Measurement& result) { return result.against.has_value(); });
  if (peer != report.results.end()) series.emplace_back("peer", peer->against->peer);
  if (!report.floors.empty()) {
    series.emplace_back("floor", "the bytes that must move, at the memory's bandwidth");
  }
  std::string text = "<h2>Time of a frame</h2>\n";
  if (series.size() == 1) return text;
  text += "<p class=\"legend\">";
  for (const auto& [style, name] : series) {
    text += fmt::format(
        "<svg viewBox=\"0 0 1 1\" aria-hidden=\"true\"><rect class=\"{}\" width=\"1\" "
        "height=\"1\"/></svg>{}\n",
        style, escaped(name));
  }
  text += "</p>\n";
  if (peer != report.results.end()) {
    text += "<p>The ratio is the other's time over that of Glassbox.</p>\n";
  }
  return text;
}

}  // namespace

std::string bench_page(const BenchReport& report) {
  std::string content = "<header><h1>glassbox bench</h1></header>\n<main>\n";
  if (!report.results.empty()) {
    content += "<section>\n" + heading(report) + bar_chart(report) + "</section>\n";
  }
  for (const Scaling& scaling : report.scalings) {
    content += fmt::format("<section>\n<h2>Time against {}</h2>\n<p>{}</p>\n", name_of(scaling.by),
                           escaped(scaling_text(scaling)));
    if (!scaling.points.empty()) content += curve_chart(scaling);
    content += "</section>\n";
  }
  content += fmt::format("<section>\n<h2>Numbers</h2>\n<pre>{}</pre>\n</section>\n</main>\n",
                         escaped(bench_text(report)));
  return assemble_page(kBenchPage, "glassbox bench", content);
}

}  // namespace glassbox::app
