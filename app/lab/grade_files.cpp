#include "app/lab/grade_files.h"

#include <nlohmann/json.hpp>

#include "app/report/output.h"
#include "labs/framework/strip.h"
#include "labs/grading/results.h"
#include "labs/grading/submission.h"

namespace glassbox::app {

namespace {

namespace fs = std::filesystem;
using labs::grading::Row;
using Json = nlohmann::ordered_json;

// As far as the overview reads it.
bool has_shape(const Json& json) {
  try {
    json.at("score").get<double>();
    json.at("output").get<std::string>();
    json.at("extra_data").at("outcome").get<std::string>();
    for (const Json& test : json.at("tests")) {
      test.at("score").get<double>();
      test.at("max_score").get<double>();
      for (const char* name : {"number", "name", "output", "status"})
        test.at(name).get<std::string>();
      test.at("extra_data").at("outcome").get<std::string>();
    }
    return true;
  } catch (const Json::exception&) {
    return false;
  }
}

}  // namespace

Result<void> write_results(const std::string& output, const std::string& classroom,
                           const Json& results) {
  if (const auto written = write_text(output, labs::grading::text_of(results)); !written)
    return written;
  if (classroom.empty()) return {};
  return write_text(classroom, labs::grading::text_of(labs::grading::classroom_json(results)));
}

Result<std::vector<Row>> read_results(const fs::path& results) {
  const auto names = labs::grading::list_submissions(results);
  if (!names) return tl::unexpected(names.error());
  std::vector<Row> rows;
  for (const std::string& name : *names) {
    Row row{name, labs::grading::unfinished_json()};
    if (const auto text = labs::read_text_file(results / name / "results.json")) {
      const Json json = Json::parse(*text, nullptr, false);
      if (has_shape(json)) row.results = json;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

const labs::Lab* lab_of_folder(const std::vector<labs::Lab>& labs, const labs::Sources& sources,
                               const fs::path& folder) {
  const auto given = labs::grading::read_submitted(folder, "student.h");
  if (!given) return nullptr;
  for (const labs::Lab& lab : labs) {
    auto own = labs::read_text_file(sources.labs / lab.folder / "student.h");
    if (own) own = labs::strip_solution(*own, "student.h");
    if (own && *own == *given) return &lab;
  }
  return nullptr;
}

}  // namespace glassbox::app
