#include "labs/commands/grade_files.h"

#include <cstdlib>
#include <optional>

#include <nlohmann/json.hpp>

#include "cli/report/output.h"
#include "labs/framework/strip_solution.h"
#include "labs/grading/reports.h"
#include "labs/grading/results.h"
#include "labs/grading/submission.h"

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Whether the JSON has all fields that the overview of a class reads.
bool has_shape(const Json& json) {
  try {
    labs::grading::total_of(json);
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

// The contents of a results.json; none if the file has no valid result.
std::optional<Json> read_result(const fs::path& file) {
  const auto text = labs::read_text_file(file);
  if (!text) return std::nullopt;
  Json json = Json::parse(*text, nullptr, false);
  if (!has_shape(json)) return std::nullopt;
  return json;
}

bool is_finished(const Json& json) {
  return json.at("extra_data").at("outcome") != labs::grading::kUnfinished;
}

// The file that exists while a submission is being graded, and stays if the grading was killed.
fs::path mark_of(const fs::path& output) {
  return output.string() + ".unfinished";
}

// The best possible grade: the number that Moodle gives in VPL_GRADEMAX, or else 100.
double max_moodle_grade() {
  const char* most = std::getenv("VPL_GRADEMAX");
  const double number = most != nullptr ? std::atof(most) : 0;
  return number > 0 ? number : 100;
}

Result<void> write_all(const ResultFiles& files, const Json& results) {
  using namespace labs::grading;
  if (const auto written = write_text(files.output, text_of(results)); !written) return written;
  if (!files.classroom.empty()) {
    if (const auto written = write_text(files.classroom, text_of(classroom_json(results)));
        !written)
      return written;
  }
  if (!files.junit.empty()) {
    if (const auto written = write_text(files.junit, junit_xml(results)); !written) return written;
  }
  if (files.vpl.empty()) return {};
  return write_text(files.vpl, vpl_text(results, max_moodle_grade()));
}

}  // namespace

Result<void> check_result_files(const ResultFiles& files) {
  std::vector<std::string> paths{files.output, mark_of(files.output).string()};
  for (const std::string* more : {&files.classroom, &files.junit, &files.vpl}) {
    if (!more->empty()) paths.push_back(*more);
  }
  return check_outputs(paths);
}

Result<void> begin_results(const ResultFiles& files, const Json& unfinished) {
  if (const auto marked = write_text(mark_of(files.output).string(), ""); !marked) return marked;
  if (const auto before = read_result(files.output); before && is_finished(*before)) return {};
  return write_all(files, unfinished);
}

Result<void> write_results(const ResultFiles& files, const Json& results) {
  const auto written = write_all(files, results);
  std::error_code error;
  if (written && is_finished(results)) fs::remove(mark_of(files.output), error);
  return written;
}

bool is_up_to_date(const std::string& output, const std::string& digest) {
  const auto result = read_result(output);
  if (!result || !is_finished(*result) || result->at("extra_data").value("digest", "") != digest)
    return false;
  std::error_code error;
  fs::remove(mark_of(output), error);
  return true;
}

Result<std::vector<labs::grading::ClassRow>> read_results(const fs::path& results) {
  const auto names = labs::grading::list_folders(results);
  if (!names) return tl::unexpected(names.error());
  std::vector<labs::grading::ClassRow> rows;
  for (const std::string& name : *names) {
    labs::grading::ClassRow row{name, labs::grading::unfinished_json()};
    const fs::path file = results / name / "results.json";
    if (const auto result = read_result(file)) row.results = *result;
    std::error_code error;
    row.finished = is_finished(row.results) && !fs::exists(mark_of(file), error);
    rows.push_back(std::move(row));
  }
  return rows;
}

const labs::Lab* lab_of_folder(const std::vector<labs::Lab>& labs, const labs::Sources& sources,
                               const fs::path& folder) {
  const auto given = labs::grading::read_submitted_file(folder, "student.h");
  if (!given) return nullptr;
  for (const labs::Lab& lab : labs) {
    auto own = labs::read_text_file(sources.folder_of(lab.folder) / "student.h");
    if (own) own = labs::strip_solution(*own, "student.h");
    if (own && *own == given->text) return &lab;
  }
  return nullptr;
}

}  // namespace glassbox::labs
