#include "app/diff/diff_reports.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/output.h"

#include <glassbox/base/printable.h>
#include <glassbox/compare/report/heat_map_file.h>
#include <glassbox/compare/report/json.h>
#include <glassbox/compare/report/junit.h>
#include <glassbox/compare/report/markdown.h>
#include <glassbox/compare/report/page.h>
#include <glassbox/compare/report/page_folder.h>

namespace glassbox::app {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

// Whether writing to `path` would overwrite one of the two compared pictures or the reference's
// sidecar file (.fuzzy).
bool is_of_pair(const std::string& path, const PicturePaths& pair) {
  const std::string stem = fs::path(pair.reference).replace_extension(".fuzzy").string();
  return is_same_file(path, pair.reference) || is_same_file(path, pair.test) ||
         is_same_file(path, pair.reference + ".fuzzy") || is_same_file(path, stem);
}

bool is_file(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

// Whether writing to `path` would overwrite a file that the command reads.
bool is_input(const std::string& path, const DiffRequest& request, const Pairing& pairing) {
  if (is_same_file(path, request.options.mask)) return true;
  if (request.approve_list && is_same_file(path, *request.approve_list)) return true;
  return std::any_of(pairing.pictures.begin(), pairing.pictures.end(),
                     [&](const PicturePaths& pair) { return is_of_pair(path, pair); });
}

bool is_compared(const std::string& folder, const DiffRequest& request) {
  return is_same_file(folder, request.reference) || is_same_file(folder, request.test);
}

// A folder that the command writes to.
struct OutputFolder {
  std::string path, option;
  std::string why;     // there has to be a folder
  std::string remedy;  // gives it another name
};

Result<void> check_folder(const OutputFolder& folder, const DiffRequest& request) {
  const auto& [path, option, why, remedy] = folder;
  if (is_file(path)) {
    return tl::unexpected(Error{path, option, "is a file, but " + why, remedy});
  }
  if (is_compared(path, request)) {
    return tl::unexpected(Error{path, option, "this is one of the directories to compare", remedy});
  }
  return {};
}

Result<void> check_heat_folder(const DiffRequest& request) {
  return check_folder({*request.heat, "-o", "two directories give several heat maps",
                       "name another folder for the heat maps"},
                      request);
}

// Checks the folder beside the page, where other reports would be in the way of its files.
Result<void> check_page_folder(const DiffRequest& request, const Pairing& pairing,
                               std::vector<std::string> reports) {
  const std::string folder = page_folder(*request.page);
  const auto legal =
      check_folder({folder, "--html-files", "the page's pictures need a folder of this name",
                    "give the page another name"},
                   request);
  if (!legal) return legal;
  for (const std::string& path : reports) {
    if (whole_path(path).parent_path() != whole_path(folder)) continue;
    return tl::unexpected(Error{path, "", "lies in the folder of the page's pictures",
                                "write this report to another folder"});
  }
  reports.push_back(folder);
  if (auto distinct = check_distinct(reports); !distinct) return distinct;
  return check_page_files(*request.page, pairing.pictures.size());
}

Result<void> check_standard_output(const DiffRequest& request) {
  if (request.page == "-") {
    return fail("--html", "the page cannot go to standard output", "name a file");
  }
  std::string options;
  int count = 0;
  for (const auto& [option, target] :
       {std::pair("--json", &request.json), std::pair("--junit", &request.junit),
        std::pair("--markdown", &request.markdown)}) {
    if (*target != "-") continue;
    options += (count++ == 0 ? "" : ", ") + std::string(option);
  }
  if (count < 2) return {};
  return fail(
      options,
      count == 2 ? "both would go to standard output" : "all three would go to standard output",
      count == 2 ? "name a file for one of them" : "name a file for two of them");
}

// The path of the heat map of one picture where two directories are compared:
// "out/teapot.png.heat.png" for "teapot.png". The extension is kept because there may be a
// teapot.pfm as well.
std::string heat_path(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / (name + ".heat.png")).string();
}

// Why there cannot be a heat map of the pictures; empty if there can.
std::string why_no_heat_map(const Comparison& comparison, HeatMapKind of) {
  if (!comparison.differences) return "its two pictures cannot be compared pixel by pixel";
  if (of == HeatMapKind::kFlip && comparison.reference.format == "32-bit floats") {
    return "FLIP is not defined for pictures of floats; use --heat steps";
  }
  return {};
}

Result<void> write_heat_maps(const DiffRequest& request, std::span<const Comparison> comparisons,
                             bool directories) {
  for (const Comparison& one : comparisons) {
    if (directories && (passes(one.verdict) || one.error)) continue;
    const std::string why_not = why_no_heat_map(one, request.heat_of);
    if (!why_not.empty() && (directories || !one.differences)) {
      fmt::print(stderr, "glassbox: note: no heat map of {}: {}\n", printable(one.name), why_not);
      continue;
    }
    const std::string path = directories ? heat_path(*request.heat, one.name) : *request.heat;
    if (directories) {
      std::error_code error;
      fs::create_directories(fs::path(path).parent_path(), error);
    }
    if (const auto written = write_heat_map(path, one, request.heat_of); !written) return written;
  }
  return {};
}

std::string title_of(const DiffRequest& request, bool directories) {
  return directories ? request.reference + " and " + request.test : "glassbox diff";
}

Result<void> write_diff_page(const DiffRequest& request, std::span<const Comparison> comparisons,
                             bool directories) {
  PageOptions options;
  options.title = title_of(request, directories);
  options.program = std::string("glassbox ") + GLASSBOX_VERSION;
  options.command = diff_command_line(request);
  options.files_beside = request.page_files;
  return write_page(*request.page, comparisons, options);
}

}  // namespace

Result<void> check_diff_reports(const DiffRequest& request, const Pairing& pairing,
                                bool directories) {
  if (const auto legal = check_standard_output(request); !legal) return legal;
  Outputs outputs;
  outputs.file(request.page).data(request.json).data(request.junit).data(request.markdown);
  if (!directories) outputs.picture(request.heat);
  if (directories && request.heat) {
    if (const auto legal = check_heat_folder(request); !legal) return legal;
  }
  if (request.page && request.page_files) {
    const auto legal = check_page_folder(request, pairing, outputs.paths());
    if (!legal) return legal;
  }
  for (const std::string& path : outputs.paths()) {
    if (is_input(path, request, pairing)) {
      return tl::unexpected(Error{path, "",
                                  "this is one of the files to read, which would be overwritten",
                                  "give the report its own name"});
    }
  }
  return outputs.check();
}

Result<void> write_diff_reports(const DiffRequest& request, std::span<const Comparison> comparisons,
                                bool directories) {
  if (request.heat) {
    const auto written = write_heat_maps(request, comparisons, directories);
    if (!written) return written;
  }
  if (request.page) {
    const auto written = write_diff_page(request, comparisons, directories);
    if (!written) return written;
  }
  if (request.json) {
    const auto written = write_json(*request.json, json_report(comparisons));
    if (!written) return written;
  }
  if (request.junit) {
    const auto written = write_text(*request.junit, junit_report("glassbox diff", comparisons));
    if (!written) return written;
  }
  if (request.markdown) {
    return write_text(*request.markdown,
                      markdown_report(title_of(request, directories), comparisons));
  }
  return {};
}

}  // namespace glassbox::app
