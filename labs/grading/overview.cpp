#include "labs/grading/overview.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/grading/results.h"

#include <glassbox/base/counted.h>
#include <glassbox/html/escaped.h>

#include "class_page.h"  // made by html/embed.cmake

namespace glassbox::labs::grading {

namespace {

using Json = nlohmann::ordered_json;

double max_score(const Row& row) {
  return row.results.at("extra_data").value("max_score", 0.0);
}

const Json& tasks(const Row& row) {
  static const Json none = Json::array();
  const Json& extra = row.results.at("extra_data");
  return extra.contains("tasks") ? extra["tasks"] : none;
}

// The tasks of all rows, in the order in which they first occur.
std::vector<std::string> task_ids(const std::vector<Row>& rows) {
  std::vector<std::string> ids;
  for (const Row& row : rows) {
    for (const Json& task : tasks(row)) {
      const std::string id = task.at("id");
      if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
    }
  }
  return ids;
}

std::string task_score(const Row& row, const std::string& id) {
  for (const Json& task : tasks(row)) {
    if (task.at("id") == id) return fmt::format("{:.6g}", task.at("score").get<double>());
  }
  return "";
}

std::string csv_text(const std::string& text) {
  std::string cell = text;
  if (!cell.empty() && std::string("=+-@\t\r").find(cell[0]) != std::string::npos)
    cell = "'" + cell;
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string check_row(const Json& test) {
  const std::string status = test.at("status");
  return fmt::format(
      "<tr><td>{}</td><td>{}<pre>{}</pre></td><td class=\"{}\">{}</td><td>{:.6g} / "
      "{:.6g}</td></tr>\n",
      escaped(test.at("number")), escaped(test.at("name")), escaped(test.at("output")),
      escaped(status), escaped(test.at("extra_data").at("outcome")), test.at("score").get<double>(),
      test.at("max_score").get<double>());
}

std::string submission_html(const Row& row) {
  const double score = total_of(row.results), most = max_score(row);
  std::string html = fmt::format(
      "<details><summary><b>{}</b><span>{}</span><meter max=\"{:.6g}\" "
      "value=\"{:.6g}\"></meter><span class=\"score\">{:.6g} / {:.6g}</span></summary>\n",
      escaped(row.name), escaped(outcome_of(row)), most > 0 ? most : 1, score, score, most);
  html += "<pre>" + escaped(row.results.at("output")) + "</pre>\n";
  html += "<table><tr><th>No.</th><th>Check</th><th>Outcome</th><th>Points</th></tr>\n";
  for (const Json& test : row.results.at("tests")) html += check_row(test);
  return html + "</table></details>\n";
}

}  // namespace

std::string outcome_of(const Row& row) {
  const std::string outcome = row.results.at("extra_data").at("outcome");
  if (row.finished || outcome == kUnfinished) return outcome;
  return fmt::format("{}; this is an earlier result: {}", kUnfinished, outcome);
}

std::string class_csv(const std::vector<Row>& rows) {
  const std::vector<std::string> ids = task_ids(rows);
  std::string csv = "submission,score,max_score,outcome";
  for (const std::string& id : ids) csv += "," + csv_text("task " + id);
  csv += "\r\n";
  for (const Row& row : rows) {
    csv += fmt::format("{},{:.6g},{:.6g},{}", csv_text(row.name), total_of(row.results),
                       max_score(row), csv_text(outcome_of(row)));
    for (const std::string& id : ids) csv += "," + task_score(row, id);
    csv += "\r\n";
  }
  return csv;
}

std::string class_html(const std::vector<Row>& rows) {
  std::string title = "Results";
  std::string sandbox;
  double sum = 0, most = 0;
  for (const Row& row : rows) {
    const Json& extra = row.results.at("extra_data");
    if (extra.contains("folder")) title = "Lab " + extra["folder"].get<std::string>();
    if (extra.contains("sandbox")) sandbox = extra["sandbox"];
    sum += total_of(row.results);
    most = std::max(most, max_score(row));
  }
  std::string html =
      fmt::format("<header><h1>{}</h1></header>\n<main>\n<section>\n", escaped(title));
  html += fmt::format("<p>{}; on average {:.3g} of {:.6g} points.</p>\n",
                      counted(rows.size(), "submission"),
                      rows.empty() ? 0 : sum / static_cast<double>(rows.size()), most);
  if (!sandbox.empty()) html += fmt::format("<p>Sandbox: {}.</p>\n", escaped(sandbox));
  html += "</section>\n<section>\n";
  for (const Row& row : rows) html += submission_html(row);
  return assemble_page(kClassPage, title, html + "</section>\n</main>\n");
}

}  // namespace glassbox::labs::grading
