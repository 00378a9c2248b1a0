#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "cli/process/process.h"
#include "cli/report/output.h"
#include "cli/report/scratch_directory.h"
#include "study/commands/report.h"
#include "study/experiment/measures.h"
#include "study/experiment/pareto.h"

namespace glassbox::study {

namespace {

struct XY {
  double x, y;
};
constexpr XY kGap{NAN, NAN};  // a point that separates two lines of one plot

// A curve or a set of points: its data, and its style in gnuplot's words.
struct Plot {
  std::string title;  // empty: not in the legend
  std::string style;
  std::vector<XY> points;
};

// The colours of Okabe and Ito's palette, and a shape for each series, the same as in the HTML
// page.
constexpr const char* kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                    "#e69f00", "#56b4e9", "#000000"};
constexpr int kShapes[] = {7, 5, 9, 13, 3, 2, 15, 1};

std::string colour_of(std::size_t series) {
  return fmt::format("lc rgb '{}'", kColours[series % std::size(kColours)]);
}
int shape_of(std::size_t series) {
  return kShapes[series % std::size(kShapes)];
}

// Puts the text in single quotes. Within them gnuplot interprets only the quote itself.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    out += c == '\'' ? std::string("''") : std::string(1, c == '\n' ? ' ' : c);
  return out + "'";
}

// ---- axes ----

// A logarithmic axis with powers of ten. 0 is placed one decade below the least value, and infinite
// values or NaN one decade above the greatest.
class LogarithmicAxis {
public:
  explicit LogarithmicAxis(const std::vector<double>& values) {
    double least = INFINITY, greatest = -INFINITY;
    for (const double value : values) {
      zero_ = zero_ || value == 0;
      absent_ = absent_ || !std::isfinite(value);
      if (!(value > 0 && std::isfinite(value))) continue;
      least = std::min(least, std::floor(std::log10(value)));
      greatest = std::max(greatest, std::ceil(std::log10(value)));
    }
    low_ = std::isfinite(least) ? int(least) : -1;
    high_ = std::isfinite(greatest) ? std::max(int(greatest), low_ + 1) : 0;
  }
  double position(double value) const {
    if (value == 0) return std::pow(10, low_ - 1);
    return std::isfinite(value) ? value : std::pow(10, high_ + 1);
  }
  std::string commands(char axis) const {
    const int step = (high_ - low_) / 8 + 1;
    std::string ticks;
    if (zero_) ticks += fmt::format("'0' 1e{}, ", low_ - 1);
    for (int power = low_; power <= high_; power += step)
      ticks += fmt::format("'10^{{{}}}' 1e{}, ", power, power);
    if (absent_) ticks += fmt::format("'inf' 1e{}, ", high_ + 1);
    ticks.resize(ticks.size() - 2);
    return fmt::format("set logscale {0}\nset {0}range [{1}:{2}]\nset {0}tics ({3})\n", axis,
                       std::pow(10, low_ - (zero_ ? 1 : 0) - 0.1),
                       std::pow(10, high_ + (absent_ ? 1 : 0) + 0.1), ticks);
  }

private:
  int low_ = 0, high_ = 1;
  bool zero_ = false, absent_ = false;
};

// ---- curves ----

struct Series {
  std::string name, scene;
  std::size_t number = 0;  // index of the series' name among all names
  bool first = true;       // the first series of its name, which has the legend's entry
  std::vector<std::size_t> members;

  std::string title() const { return first ? name : std::string(); }
};

std::vector<Series> series_of(const ExperimentResult& result) {
  std::vector<std::string> names;
  std::vector<Series> all;
  for (std::size_t i = 0; i < result.configurations.size(); ++i) {
    const ConfigurationResult& each = result.configurations[i];
    const bool first = std::ranges::count(names, each.series) == 0;
    if (first) names.push_back(each.series);
    const auto number = std::size_t(std::ranges::find(names, each.series) - names.begin());
    auto known = std::ranges::find_if(
        all, [&](const Series& s) { return s.name == each.series && s.scene == each.scene; });
    if (known == all.end())
      known = all.insert(all.end(), {each.series, each.scene, number, first, {}});
    known->members.push_back(i);
  }
  return all;
}

std::string commands_of(const std::string& svg, const std::string& title, const std::string& x,
                        const std::string& y, const std::string& axes,
                        const std::vector<Plot>& plots) {
  std::string text = fmt::format(
      "set terminal svg size 900,520 enhanced font 'sans-serif,14' background rgb 'white'\n"
      "set output {}\nset title {} noenhanced\nset xlabel {} noenhanced\nset ylabel {} noenhanced\n"
      "set key outside right top vertical maxcols 1 Left reverse samplen 1 font ',12' "
      "noenhanced\nset grid lc rgb '#d9d9d9'\n{}",
      quoted(svg), quoted(title), quoted(x), quoted(y), axes);
  std::string plot = "plot ";
  for (std::size_t i = 0; i < plots.size(); ++i) {
    text += fmt::format("$data{} << end\n", i);
    for (const XY& point : plots[i].points) {
      text += std::isnan(point.x) ? "\n" : fmt::format("{} {}\n", point.x, point.y);
    }
    text += "end\n";
    const std::string key = plots[i].title.empty() ? "notitle" : "title " + quoted(plots[i].title);
    plot += fmt::format("{}$data{} {} {}", i == 0 ? "" : ", ", i, plots[i].style, key);
  }
  return text + plot + "\nset output\n";
}

// The label of the axis of errors: the measure's name with its unit.
std::string error_label(const ExperimentResult& result) {
  const std::string& measure = result.configurations.front().measure;
  return with_unit(measure.empty() ? "error" : measure, result.error_unit);
}

std::vector<double> errors_of(const ExperimentResult& result, bool predicted) {
  std::vector<double> errors;
  for (const ConfigurationResult& each : result.configurations) {
    errors.push_back(each.error);
    if (predicted && each.predicted_error) errors.push_back(*each.predicted_error);
  }
  return errors;
}

// The Pareto fronts, one for each group of configurations that are compared with each other, as
// lists of points.
std::vector<std::vector<XY>> fronts_of(const ExperimentResult& result,
                                       const std::vector<Standing>& standing,
                                       const auto& place_of) {
  std::map<std::tuple<std::string, double>, std::vector<XY>> fronts;
  for (std::size_t i = 0; i < standing.size(); ++i) {
    if (standing[i] != Standing::kFront) continue;
    const ConfigurationResult& each = result.configurations[i];
    fronts[{each.scene, result.axis_is_chosen ? 0 : each.parameter}].push_back(place_of(each));
  }
  std::vector<std::vector<XY>> all;
  for (auto& [competitors, points] : fronts) {
    std::ranges::sort(points, {}, &XY::x);
    all.push_back(points);
  }
  return all;
}

}  // namespace

std::string time_chart_commands(const ExperimentResult& result, const std::string& svg) {
  const TimeUnit unit = time_unit(result);
  const LogarithmicAxis y(errors_of(result, false));
  std::vector<double> times;
  for (const ConfigurationResult& each : result.configurations) {
    const study::Timing* timing = timing_of(each, 1);
    if (timing == nullptr) continue;
    for (const double ns : {timing->ns.lower, timing->ns.median, timing->ns.upper}) {
      times.push_back(ns / unit.ns);
    }
  }
  const LogarithmicAxis x(times);
  const auto place_of = [&](const ConfigurationResult& each) {
    return XY{timing_of(each, 1)->ns.median / unit.ns, y.position(each.error)};
  };
  const std::vector<Standing> standing = study::standings(result);
  std::vector<Plot> plots;
  for (std::vector<XY>& front : fronts_of(result, standing, place_of))
    plots.push_back({"", "with steps lc rgb '#888888' lw 1", std::move(front)});
  for (const Series& series : series_of(result)) {
    Plot front{series.title(), {}, {}}, dominated{"", {}, {}};
    front.style = fmt::format("with points pt {} ps 1.1 {}", shape_of(series.number),
                              colour_of(series.number));
    dominated.style =
        fmt::format("with points pt {} ps 0.9 lc rgb '#b0b0b0'", shape_of(series.number));
    for (const std::size_t i : series.members) {
      if (standing[i] == Standing::kUntimed) continue;
      (standing[i] == Standing::kFront ? front : dominated)
          .points.push_back(place_of(result.configurations[i]));
    }
    // The error bars run from the lower to the upper quartile.
    Plot bars{"", fmt::format("with lines {} lw 1.5", colour_of(series.number)), {}};
    for (const std::size_t i : series.members) {
      const study::Timing* timing = timing_of(result.configurations[i], 1);
      if (timing == nullptr) continue;
      const double error = y.position(result.configurations[i].error);
      bars.points.push_back({timing->ns.lower / unit.ns, error});
      bars.points.push_back({timing->ns.upper / unit.ns, error});
      bars.points.push_back(kGap);
    }
    if (!bars.points.empty()) plots.push_back(std::move(bars));
    if (front.points.empty()) std::swap(front.title, dominated.title);
    for (Plot& plot : {std::ref(dominated), std::ref(front)}) {
      if (!plot.points.empty()) plots.push_back(std::move(plot));
    }
  }
  return commands_of(svg, result.id + " " + result.name,
                     fmt::format("{} per {}, one thread", unit.name, result.item),
                     error_label(result), x.commands('x') + y.commands('y'), plots);
}

std::string axis_chart_commands(const ExperimentResult& result, const std::string& svg) {
  const LogarithmicAxis y(errors_of(result, true));
  std::vector<double> parameters;
  for (const ConfigurationResult& each : result.configurations)
    parameters.push_back(each.parameter);
  const bool logarithmic =
      result.logarithmic_axis && std::ranges::all_of(parameters, [](double p) { return p >= 0; });
  const LogarithmicAxis x(parameters);
  const auto x_of = [&](const ConfigurationResult& each) {
    return logarithmic ? x.position(each.parameter) : each.parameter;
  };
  std::vector<Plot> plots;
  for (const Series& series : series_of(result)) {
    Plot measured{series.title(), {}, {}}, theory{"", {}, {}};
    measured.style = fmt::format("with linespoints pt {} ps 0.9 lw 1.5 {}", shape_of(series.number),
                                 colour_of(series.number));
    theory.style = fmt::format("with lines dt 2 lw 1.5 {}", colour_of(series.number));
    std::vector<std::size_t> sorted = series.members;
    std::ranges::sort(sorted, {}, [&](std::size_t i) { return parameters[i]; });
    for (const std::size_t i : sorted) {
      const ConfigurationResult& each = result.configurations[i];
      measured.points.push_back({x_of(each), y.position(each.error)});
      if (each.predicted_error)
        theory.points.push_back({x_of(each), y.position(*each.predicted_error)});
    }
    if (theory.points.size() == 1)
      theory.style = fmt::format("with points pt 6 ps 1.6 {}", colour_of(series.number));
    plots.push_back(std::move(measured));
    if (!theory.points.empty()) plots.push_back(std::move(theory));
  }
  return commands_of(svg, result.id + " " + result.name + " (dashed: theory)",
                     with_unit(result.axis, result.axis_unit), error_label(result),
                     (logarithmic ? x.commands('x') : "set xtics autofreq\n") + y.commands('y'),
                     plots);
}

namespace {

namespace fs = std::filesystem;

constexpr const char* kRemedy = "install it (apt install gnuplot-nox), or leave --svg out";

constexpr ProcessLimits kChartLimits{.seconds = 300};  // a chart takes a second

// Runs gnuplot and prints gnuplot's messages on standard error, like this program's own.
ProcessOutcome run_gnuplot(const std::string& script) {
  ProcessOutcome outcome = run_process({"gnuplot", script}, kChartLimits);
  fmt::print(stderr, "{}", outcome.printed);
  return outcome;
}

std::string text_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The path of a chart without the ending: "D-2"; for the second and third measure of an experiment
// "D-2-2" and "D-2-3".
std::string stem_of(const std::string& directory, const std::string& id, std::size_t measure) {
  return directory + "/" + id + (measure == 0 ? "" : fmt::format("-{}", measure + 1));
}

// Draws into a temporary file first, so that the directory gets a complete chart or none.
Result<void> draw(const fs::path& scratch,
                  std::string (*commands)(const study::ExperimentResult&, const std::string&),
                  const study::ExperimentResult& result, const std::string& target) {
  const fs::path script = scratch / "commands", drawn = scratch / "chart.svg";
  std::ofstream(script, std::ios::binary) << commands(result, drawn.string());
  const ProcessOutcome outcome = run_gnuplot(script.string());
  if (outcome.timed_out) {
    return tl::unexpected(Error{
        target, "", fmt::format("gnuplot was not finished after {:g} s", kChartLimits.seconds),
        "try again when the machine is less busy, or leave --svg out"});
  }
  const std::string svg = text_of(drawn);
  if (!outcome.started || outcome.status != 0 || svg.empty()) {
    return tl::unexpected(
        Error{target, "", "gnuplot could not draw this chart (its message is above)", kRemedy});
  }
  return write_text(target, svg);
}

}  // namespace

Result<void> check_gnuplot() {
  if (run_gnuplot("/dev/null").started) return {};
  return fail("--svg", "gnuplot draws these charts, and it is not installed", kRemedy);
}

Result<int> write_svg_charts(const study::StudyResults& results, const std::string& directory) {
  const ScratchDirectory scratch;
  const auto place = scratch.path();
  if (!place) return tl::unexpected(place.error());
  int written = 0;
  for (const study::ExperimentResult& experiment : results.experiments) {
    const std::vector<study::ExperimentResult> measures = study::by_measure(experiment);
    for (std::size_t i = 0; i < measures.size(); ++i) {
      const std::string stem = stem_of(directory, experiment.id, i);
      if (!study::thread_counts(measures[i]).empty()) {
        const auto done = draw(*place, time_chart_commands, measures[i], stem + "-time.svg");
        if (!done) return tl::unexpected(done.error());
        ++written;
      }
      const auto done = draw(*place, axis_chart_commands, measures[i], stem + "-axis.svg");
      if (!done) return tl::unexpected(done.error());
      ++written;
    }
  }
  return written;
}

}  // namespace glassbox::study
