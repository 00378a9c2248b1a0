#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "app/lab/pictures.h"
#include "app/lab/report.h"
#include "lab_page.h"  // made by html/embed.cmake
#include "labs/framework/compare.h"
#include "labs/framework/divergence_text.h"
#include "labs/framework/slips.h"

#include <glassbox/html/blob.h>
#include <glassbox/html/escaped.h>
#include <glassbox/images/write.h>

namespace glassbox::app {

namespace {

using labs::CheckResult;
using labs::Divergence;
using labs::FirstFailure;

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
      row("failure", labs::kind_name(found.kind)) + row("expected", labs::expected_text(found)) +
      row("actual", labs::actual_text(found)) + row("distance", labs::distance_text(found));
  if (!found.explanation.empty()) rows += row("that is", found.explanation);
  return rows;
}

Result<std::string> failure_html(const LabReport& report, const CheckResult& check) {
  const FirstFailure& first = *check.first;
  std::string html = "<table>\n" + row("case", fmt::format("{} {}", first.index, first.where)) +
                     row("verdict", outcome_text(report, check));
  if (first.verdict == labs::Verdict::kUntouched) return html + "</table>\n";
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
  return html;
}

std::string printed_html(const CheckResult& check) {
  if (check.said.empty()) return {};
  return "<p class=quiet>Your code printed:</p>\n<pre>" + escaped(check.said.substr(0, 4000)) +
         "</pre>\n";
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
  const std::string title = fmt::format("Lab {}: {}", result.number, result.title);
  std::string html = "<header><h1>" + escaped(title) + "</h1></header>\n<main>\n<section>\n" +
                     table_of_tasks(result) + "</section>\n";
  if (!result.not_built.empty())
    html += "<section class=wrong><h2>It does not compile</h2>\n<pre>" + escaped(result.not_built) +
            "</pre></section>\n";
  for (const CheckResult& check : result.checks) {
    html += fmt::format(
        "<section class={}>\n<h2>{}</h2>\n<p class=quiet>task {}, stage {}{}: {} of {} cases "
        "right{}, {} points</p>\n",
        check.right == check.cases.size() ? "right" : "wrong", escaped(check.name),
        escaped(check.task), escaped(check.stage), check.hidden ? ", hidden" : "", check.right,
        check.cases.size(), note_of_whole(check), points_text(check.score, check.max_score));
    if (check.first) {
      const auto failure = failure_html(report, check);
      if (!failure) return failure;
      html += *failure;
    }
    html += printed_html(check) + "</section>\n";
  }
  return assemble_page(kLabPage, title, html + "</main>\n");
}

}  // namespace glassbox::app
