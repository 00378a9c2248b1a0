#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "app/lab/pictures.h"
#include "app/lab/report.h"
#include "labs/framework/compare.h"
#include "labs/framework/slips.h"

#include <glassbox/html/blob.h>
#include <glassbox/images/write.h>

namespace glassbox::app {

namespace {

using labs::CheckResult;
using labs::Divergence;
using labs::FirstFailure;

constexpr const char* kHead = R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src 'unsafe-inline'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<style>
body { max-width: 62rem; margin: 1.5rem auto; padding: 0 1rem; font: 16px/1.45 system-ui, sans-serif; }
h1 { font-size: 1.4rem; } h2 { margin: 0; font-size: 1.05rem; }
section { margin: 1rem 0; padding: .8rem 1rem; border: 1px solid #8886; border-left: .35rem solid #1b6e3a; border-radius: 6px; }
section.wrong { border-left-color: #b3261e; }
table { border-collapse: collapse; } th, td { padding: .15rem .9rem .15rem 0; text-align: left; vertical-align: top; }
td { font-variant-numeric: tabular-nums; } pre, code { font-family: ui-monospace, Menlo, Consolas, monospace; font-size: .88rem; }
pre { overflow-x: auto; margin: .4rem 0; padding: .5rem; background: #8881; border-radius: 4px; }
.slip { font-weight: 600; } .quiet { opacity: .75; }
figure { display: inline-block; margin: .4rem 1rem .4rem 0; } figcaption { font-size: .88rem; }
img { image-rendering: pixelated; border: 1px solid #8886; } svg { border: 1px solid #8886; background: #8881; }
</style>
)";

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else if ((byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7f) {
      out += '?';
    } else {
      out += c;
    }
  }
  return out;
}

std::string row(const char* name, const std::string& value) {
  return fmt::format("<tr><th scope=row>{}</th><td>{}</td></tr>\n", name, escaped(value));
}

Result<std::string> figure(const Image<Rgba8>& image, const char* caption) {
  const auto png = encode_png(image);
  if (!png) return tl::unexpected(png.error());
  const auto* first = reinterpret_cast<const std::uint8_t*>(png->data());
  // Small pictures are shown with pixels that can be counted.
  const int zoom = std::clamp(280 / std::max(1, image.width), 1, 16);
  return fmt::format(
      "<figure><img alt=\"{0}\" width={1} height={2} "
      "src=\"data:image/png;base64,{3}\"><figcaption>{0}</figcaption></figure>\n",
      caption, image.width * zoom, image.height * zoom, base64(std::span(first, png->size())));
}

Result<std::string> pictures(const FirstFailure& first) {
  if (!first.expected) return std::string();
  if (first.expected->shape == labs::Shape::kPolygon)
    return polygon_drawing(*first.expected, first.actual);
  if (first.expected->shape != labs::Shape::kCoverage) return std::string();
  const CoveragePictures made = coverage_pictures(*first.expected, first.actual);
  std::string html;
  const std::pair<const Image<Rgba8>*, const char*> all[] = {
      {&made.expected, "expected"},
      {&made.actual, "yours"},
      {&made.difference, "difference: red missing, orange too often, blue too much"}};
  for (const auto& [image, caption] : all) {
    const auto shown = figure(*image, caption);
    if (!shown) return shown;
    html += *shown;
  }
  return html;
}

std::string divergence_rows(const Divergence& found) {
  std::string rows =
      row("field", found.element.empty() ? found.field : found.field + ", " + found.element) +
      row("failure", labs::kind_name(found.kind)) +
      row("expected", number_text(found.expected, found.actual)) +
      row("actual", number_text(found.actual, found.expected)) +
      row("distance", distance_text(found));
  if (!found.explanation.empty()) rows += row("that is", found.explanation);
  return rows;
}

Result<std::string> failure_html(const LabReport& report, const CheckResult& check) {
  const FirstFailure& first = *check.first;
  std::string html = "<table>\n" + row("case", fmt::format("{} {}", first.index, first.where)) +
                     row("verdict", labs::verdict_name(first.verdict));
  if (!first.text.empty()) html += row("that is", first.text);
  if (first.divergence) html += divergence_rows(*first.divergence);
  html += "</table>\n";
  for (const std::string& slip : check.slips)
    html += fmt::format("<p class=slip>Likely slip: {}.</p>\n", escaped(labs::slip_text(slip)));
  const auto shown = pictures(first);
  if (!shown) return shown;
  html += *shown;
  const Restated restated = restated_lines(first.restated);
  if (!restated.facts.empty()) {
    html += "<p class=quiet>The case:</p>\n<pre>";
    for (const std::string& fact : restated.facts) html += escaped(fact) + "\n";
    html += "</pre>\n";
  }
  const std::string debugger = debugger_command(report, check);
  if (!restated.commands.empty() || !debugger.empty()) {
    html += "<p class=quiet>Look at it:</p>\n<pre>";
    for (const std::string& command : restated.commands) html += escaped(command) + "\n";
    if (!debugger.empty()) html += escaped(debugger) + "\n";
    html += "</pre>\n";
  }
  if (!check.said.empty())
    html += "<p class=quiet>Your code printed:</p>\n<pre>" + escaped(check.said.substr(0, 4000)) +
            "</pre>\n";
  return html;
}

std::string table_of_tasks(const labs::LabResult& result) {
  std::string html = "<table>\n";
  for (const labs::TaskResult& task : result.tasks) {
    if (task.max_score == 0) continue;
    html += fmt::format("<tr><th scope=row>{}</th><td>{}</td><td>{}</td></tr>\n", escaped(task.id),
                        escaped(task.title), points_text(task.score, task.max_score));
  }
  return html + fmt::format("<tr><th scope=row></th><td>total</td><td>{}</td></tr>\n</table>\n",
                            points_text(result.score, result.max_score));
}

}  // namespace

Result<std::string> lab_report_page(const LabReport& report) {
  const labs::LabResult& result = report.result;
  const std::string title = fmt::format("Lab {}: {}", result.number, escaped(result.title));
  std::string html = std::string(kHead) + "<title>" + title + "</title>\n</head>\n<body>\n<h1>" +
                     title + "</h1>\n" + table_of_tasks(result);
  if (!result.not_built.empty())
    html += "<section class=wrong><h2>It does not compile</h2>\n<pre>" + escaped(result.not_built) +
            "</pre></section>\n";
  for (const CheckResult& check : result.checks) {
    html += fmt::format(
        "<section{}>\n<h2>{}</h2>\n<p class=quiet>task {}, stage {}{}: {} of {} cases right, {} "
        "points</p>\n",
        check.right == check.cases.size() ? "" : " class=wrong", escaped(check.name),
        escaped(check.task), escaped(check.stage), check.hidden ? ", hidden" : "", check.right,
        check.cases.size(), points_text(check.score, check.max_score));
    if (check.first) {
      const auto failure = failure_html(report, check);
      if (!failure) return failure;
      html += *failure;
    }
    html += "</section>\n";
  }
  return html + "</body>\n</html>\n";
}

}  // namespace glassbox::app
