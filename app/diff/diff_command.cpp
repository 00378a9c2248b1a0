// glassbox diff REFERENCE TEST: checks whether two pictures, or the pictures in two directories,
// are the same.
#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/pixel/pixel_command.h"
#include "cli/options/add_command.h"
#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"

#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>
#include <glassbox/compare/pictures/approve.h>
#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pictures/pairing.h>
#include <glassbox/compare/report/heat_map_file.h>
#include <glassbox/compare/report/json.h>
#include <glassbox/compare/report/junit.h>
#include <glassbox/compare/report/page.h>
#include <glassbox/compare/report/page_folder.h>
#include <glassbox/compare/report/text.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>

namespace glassbox::app {

class DiffCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  Result<Pairing> pair_up() const;
  Result<void> check_output_paths(const Pairing& pairing) const;
  std::vector<Comparison> compare(const Pairing& pairing) const;
  Result<void> write_reports(const std::vector<Comparison>& comparisons) const;
  Result<void> write_heat_maps(const std::vector<Comparison>& comparisons) const;
  void print(const std::vector<Comparison>& comparisons, const Pairing& pairing) const;
  int approve_all(const std::vector<Comparison>& comparisons) const;
  std::string command_line() const;
  bool silent() const;  // whether nothing is printed, because a report goes to standard output

  std::string reference_, test_;
  bool directories_ = false;
  CompareOptions options_;
  std::optional<std::string> heat_, page_, json_, junit_;
  HeatMapKind heat_of_ = HeatMapKind::kSteps;
  bool page_files_ = false;
  bool approve_ = false;
  std::vector<const CLI::Option*> comparing_;  // the options that can change the verdict
};

namespace {

namespace fs = std::filesystem;

// Returns the value; if there is an error instead, throws CLI11's exception for an invalid option.
template <class T>
T value_or_refuse(const std::string& option, const Result<T>& value) {
  if (value) return *value;
  throw CLI::ValidationError(option, value.error().cause + "; " + value.error().remedy);
}

bool is_directory(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool exists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

int exit_code_of(Verdict verdict) {
  if (passes(verdict)) return kSuccess;
  return verdict == Verdict::kDifferent ? kFailure : kBadInput;
}

int exit_code_of(const std::vector<Comparison>& comparisons) {
  int worst = kSuccess;
  for (const Comparison& one : comparisons) worst = std::max(worst, exit_code_of(one.verdict));
  return worst;
}

// The path of the heat map of one picture where two directories are compared:
// "out/teapot.png.heat.png" for "teapot.png". The extension is kept because there may be a
// teapot.pfm as well.
std::string heat_path(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / (name + ".heat.png")).string();
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored);
}

// Whether writing to `path` would overwrite one of the two compared pictures or the reference's
// sidecar file (.fuzzy).
bool is_input(const std::string& path, const PicturePaths& pair) {
  const std::string stem = fs::path(pair.reference).replace_extension(".fuzzy").string();
  return is_same_file(path, pair.reference) || is_same_file(path, pair.test) ||
         is_same_file(path, pair.reference + ".fuzzy") || is_same_file(path, stem);
}

}  // namespace

void DiffCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("diff", "compare pictures, exactly or with a tolerance");
  command.footer(
      "Exit: 0 the same (or within the tolerance asked for), 1 different, 2 bad usage, or a "
      "picture that\n"
      "is missing or cannot be read.\n\n"
      "Examples:\n"
      "  glassbox diff golden/teapot.png teapot.png\n"
      "  glassbox diff golden/teapot.png teapot.png --html page.html -o heat.png\n"
      "  glassbox diff golden/ out/ --junit report.xml --html report.html\n"
      "  glassbox diff a.png b.png --fuzzy 'maxDifference=0-1;totalPixels=0-4'\n"
      "  glassbox diff a.png b.png --ignore-antialiasing --threshold 0.1 --max-differing 0.01%\n"
      "  glassbox diff a.png b.png --metric 'rmse,psnr>40,flip.mean<0.05'\n"
      "  glassbox diff golden/teapot.png teapot.png --approve\n\n"
      "A file NAME.fuzzy beside the reference NAME holds its tolerance and the reason for it:\n"
      "  fuzzy: maxDifference=0-1;totalPixels=0-4\n"
      "  reason: four pixels of the rim are ties that the hardware breaks the other way");
  command
      .add_option("REFERENCE", reference_,
                  "the reference picture, or a directory of reference pictures")
      ->required();
  command
      .add_option("TEST", test_,
                  "the picture to compare with it, or a directory with pictures of the same names")
      ->required();

  const std::size_t before = command.get_options().size();
  const std::string tolerance = "Tolerance (without one, every sample has to be the same)";
  command
      .add_option_function<std::string>(
          "--fuzzy",
          [this](const std::string& text) {
            options_.tolerance.fuzzy = value_or_refuse("--fuzzy", parse_fuzzy(text));
          },
          "the ranges that pass: of the largest difference in steps (1/255, 1/65535 or ulps), and "
          "of the number of pixels that differ")
      ->type_name("'maxDifference=A-B;totalPixels=C-D'")
      ->group(tolerance);
  command
      .add_option_function<std::string>(
          "--max-ulp",
          [this](const std::string& text) {
            options_.tolerance.max_ulp = value_or_refuse("--max-ulp", parse_max_ulp(text));
          },
          "for pictures of floats: the largest difference of two samples that passes, in ulps "
          "(steps from a float to the next)")
      ->type_name("N")
      ->group(tolerance);
  command
      .add_option_function<std::string>(
          "--threshold",
          [this](const std::string& text) {
            options_.tolerance.set_aside.threshold =
                value_or_refuse("--threshold", parse_threshold(text));
          },
          "colours that are at most this far apart, from 0 to 1, do not count as different: the "
          "distance of odiff, reg-cli and Playwright; 0.1 is 26 steps of grey")
      ->type_name("T")
      ->group(tolerance);
  command
      .add_option_function<std::string>(
          "--max-differing",
          [this](const std::string& text) {
            options_.tolerance.max_differing =
                value_or_refuse("--max-differing", parse_max_differing(text));
          },
          "how many pixels may differ by any amount: a number, or a share of those compared")
      ->type_name("N|P%")
      ->group(tolerance);
  command
      .add_flag("--ignore-antialiasing", options_.tolerance.set_aside.moved_edges,
                "pixels do not count as different where an edge moved by less than a pixel; they "
                "are counted apart")
      ->group(tolerance);
  command
      .add_option_function<std::vector<std::string>>(
          "--metric",
          [this](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              const auto more = value_or_refuse("--metric", parse_metrics(text));
              options_.metrics.insert(options_.metrics.end(), more.begin(), more.end());
            }
          },
          "report absmax, rmse, psnr, ssim, flip; a metric with a limit (flip.mean<0.05) is also a "
          "tolerance")
      ->allow_extra_args(false)
      ->type_name("LIST")
      ->group(tolerance);
  command.add_flag("--nan-equal", options_.nan_equals_nan, "NaN counts as equal to NaN")
      ->group(tolerance);

  const std::string selection = "What is compared";
  command
      .add_option_function<std::vector<std::string>>(
          "--ignore",
          [this](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              options_.ignore.push_back(value_or_refuse("--ignore", parse_pixel_box(text)));
            }
          },
          "a rectangle of pixels to leave out of the comparison; may be given several times")
      ->allow_extra_args(false)
      ->type_name("X,Y,WxH")
      ->group(selection);
  command
      .add_option("--mask", options_.mask,
                  "a picture of the same size; where it is black, pixels are not compared")
      ->type_name("FILE")
      ->group(selection);
  add_choice(command, "--alpha", options_.alpha,
             {{"lenient", AlphaRule::kLenient}, {"strict", AlphaRule::kStrict}},
             "an alpha channel that is opaque everywhere: is the same as none, or is a difference "
             "[lenient]")
      ->group(selection);
  add_choice(command, "--align", options_.alignment,
             {{"top-left", Alignment::kTopLeft},
              {"centre", Alignment::kCentre},
              {"best", Alignment::kBest}},
             "where pictures of different sizes lie on each other: at a corner, at their centres, "
             "or where they differ least [top-left]")
      ->group(selection);
  command
      .add_flag("--ignore-size", options_.ignore_size,
                "pictures of different sizes pass if what both have passes")
      ->group(selection);

  const auto all = command.get_options();
  comparing_.assign(all.begin() + std::ptrdiff_t(before), all.end());

  const std::string reports = "Reports";
  command
      .add_option("-o,--output", heat_,
                  "heat map, .png or .ppm; for directories, a folder of heat maps")
      ->type_name("FILE")
      ->group(reports);
  add_choice(command, "--heat", heat_of_,
             {{"steps", HeatMapKind::kSteps}, {"flip", HeatMapKind::kFlip}},
             "what the heat map shows: steps of difference, or the visible error by FLIP [steps]")
      ->group(reports);
  CLI::Option* html =
      add_html_output(command, page_, "one page with everything, to open in a browser");
  html->group(reports);
  command
      .add_flag(
          "--html-files", page_files_,
          "with --html page.html: the whole pictures go into the folder page-files beside the "
          "page, which loads those that are looked at; for many pictures")
      ->needs(html)
      ->group(reports);
  add_json_output(command, json_, "everything")->group(reports);
  command.add_option("--junit", junit_, "JUnit's XML for servers; - is standard output")
      ->type_name("FILE|-")
      ->group(reports);
  command
      .add_flag("--suggest-fuzzy", options_.suggest_tolerance,
                "print the tightest --fuzzy that would pass, and that still does when a picture "
                "comes nearer to its reference; and the short options")
      ->group(reports);
  command
      .add_flag("--approve", approve_,
                "copy TEST over REFERENCE where they differ or REFERENCE is missing")
      ->group("Approval (refused if the environment variable CI is set)");
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<Pairing> DiffCommand::pair_up() const {
  if (directories_) return pair_directories(reference_, test_);
  return Pairing{{{test_, reference_, test_, exists(reference_), exists(test_)}}, {}};
}

Result<void> DiffCommand::check_output_paths(const Pairing& pairing) const {
  std::vector<std::string> files;
  if (page_) files.push_back(*page_);
  for (const auto& path : {json_, junit_}) {
    if (path && *path != "-") files.push_back(*path);
  }
  if (heat_ && !directories_) {
    if (const auto legal = check_image_path(*heat_); !legal) return legal;
    files.push_back(*heat_);
  }
  if (heat_ && directories_ && exists(*heat_) && !is_directory(*heat_)) {
    return tl::unexpected(Error{
        *heat_, "-o", "is a file, but two directories give several heat maps", "name a folder"});
  }
  if (heat_ && directories_ && (is_same_file(*heat_, reference_) || is_same_file(*heat_, test_))) {
    return tl::unexpected(Error{*heat_, "-o", "this is one of the directories to compare",
                                "name another folder for the heat maps"});
  }
  if (page_ && page_files_) {
    const std::string folder = page_folder(*page_);
    if (exists(folder) && !is_directory(folder)) {
      return tl::unexpected(Error{folder, "--html-files",
                                  "is a file, but the page's pictures need a folder of this name",
                                  "give the page another name"});
    }
    if (directories_ && (is_same_file(folder, reference_) || is_same_file(folder, test_))) {
      return tl::unexpected(Error{folder, "--html-files",
                                  "this is one of the directories to compare",
                                  "give the page another name"});
    }
  }
  if (page_ == "-") {
    return fail("--html", "the page cannot go to standard output", "name a file");
  }
  if (json_ == "-" && junit_ == "-") {
    return fail("--json, --junit", "both would go to standard output",
                "name a file for one of them");
  }
  for (const std::string& path : files) {
    const bool input = is_same_file(path, options_.mask) ||
                       std::any_of(pairing.pictures.begin(), pairing.pictures.end(),
                                   [&](const PicturePaths& pair) { return is_input(path, pair); });
    if (input) {
      return tl::unexpected(Error{path, "",
                                  "this is one of the files to compare, which would be overwritten",
                                  "give the report its own name"});
    }
  }
  return check_outputs(files);
}

std::vector<Comparison> DiffCommand::compare(const Pairing& pairing) const {
  Progress progress;
  std::vector<Comparison> comparisons;
  for (const PicturePaths& paths : pairing.pictures) {
    progress.phase(fmt::format("comparing {} ({} of {})", printable(paths.name),
                               comparisons.size() + 1, pairing.pictures.size()));
    comparisons.push_back(compare_pair(paths, options_));
  }
  progress.done();
  return comparisons;
}

Result<void> DiffCommand::write_heat_maps(const std::vector<Comparison>& comparisons) const {
  for (const Comparison& one : comparisons) {
    if (directories_ && (passes(one.verdict) || one.error)) continue;
    if (directories_ && heat_of_ == HeatMapKind::kFlip && one.reference.format == "32-bit floats") {
      fmt::print(stderr,
                 "glassbox: note: no heat map of {}: FLIP is not defined for pictures of floats; "
                 "use --heat steps\n",
                 printable(one.name));
      continue;
    }
    if (!one.differences) {
      fmt::print(
          stderr,
          "glassbox: note: no heat map of {}: its two pictures cannot be compared pixel by pixel\n",
          printable(one.name));
      continue;
    }
    const std::string path = directories_ ? heat_path(*heat_, one.name) : *heat_;
    if (directories_) {
      std::error_code error;
      fs::create_directories(fs::path(path).parent_path(), error);
    }
    if (const auto written = write_heat_map(path, one, heat_of_); !written) return written;
  }
  return {};
}

Result<void> DiffCommand::write_reports(const std::vector<Comparison>& comparisons) const {
  if (heat_) {
    if (const auto written = write_heat_maps(comparisons); !written) return written;
  }
  if (page_) {
    PageOptions options;
    options.title = directories_ ? reference_ + " and " + test_ : "glassbox diff";
    options.program = std::string("glassbox ") + GLASSBOX_VERSION;
    options.command = command_line();
    options.files_beside = page_files_;
    if (const auto written = write_page(*page_, comparisons, options); !written) return written;
  }
  if (json_) {
    if (const auto written = write_json(*json_, json_report(comparisons)); !written) return written;
  }
  if (junit_) return write_text(*junit_, junit_report("glassbox diff", comparisons));
  return {};
}

// The command line that makes the same comparison again.
std::string DiffCommand::command_line() const {
  std::vector<std::string> words{"diff", shell_quoted(reference_) ? reference_ : "REFERENCE",
                                 shell_quoted(test_) ? test_ : "TEST"};
  for (const CLI::Option* option : comparing_) {
    const bool flag = option->get_expected_max() == 0;
    if (flag && option->count() > 0) words.push_back(option->get_name());
    for (std::size_t i = 0; !flag && i < option->count(); ++i) {
      words.insert(words.end(), {option->get_name(), option->results()[i]});
    }
  }
  return shell_line({words});
}

bool DiffCommand::silent() const {
  return json_ == "-" || junit_ == "-";
}

void DiffCommand::print(const std::vector<Comparison>& comparisons, const Pairing& pairing) const {
  const bool is_approved = approve_ && comparisons.front().verdict == Verdict::kNew;
  if (!directories_ && comparisons.front().error && !is_approved) {
    refuse(*comparisons.front().error);
    return;
  }
  if (silent()) return;
  for (const Comparison& one : comparisons) {
    const std::string more = comparison_details(one);
    if (directories_ && one.verdict == Verdict::kSame && more.empty()) continue;
    fmt::print("{}\n{}", comparison_line(one), more);
  }
  const std::string alpha = opaque_alpha_text(comparisons);
  if (!alpha.empty()) fmt::print("note: {}\n", alpha);
  for (const std::string& orphan : pairing.orphans) {
    fmt::print("note: {} belongs to no picture\n", printable(orphan, 400));
  }
  if (directories_) fmt::print("{}\n", summary_line(comparisons));
}

int DiffCommand::approve_all(const std::vector<Comparison>& comparisons) const {
  int exit_code = kSuccess;
  for (const Comparison& one : comparisons) {
    if (one.verdict == Verdict::kSame) continue;
    if (one.verdict == Verdict::kMissing || one.verdict == Verdict::kUncompared) {
      exit_code = kBadInput;
      continue;
    }
    if (const auto done = approve_picture(one.reference.path, one.test.path); !done) {
      return refuse(done.error());
    }
    if (!silent()) fmt::print("approved: {}\n", printable(one.reference.path, 400));
  }
  return exit_code;
}

int DiffCommand::run() {
  if (approve_ && on_ci_server()) {
    return refuse({"", "--approve",
                   "the environment variable CI is set, so nobody looks at the pictures",
                   "approve the pictures on your own machine"});
  }
  directories_ = is_directory(reference_) || is_directory(test_);
  if (directories_ && !(is_directory(reference_) && is_directory(test_))) {
    return refuse({is_directory(reference_) ? test_ : reference_, "",
                   "is not a directory, but the other one is",
                   "name two pictures or two directories"});
  }
  const auto pairing = pair_up();
  if (!pairing) return refuse(pairing.error());
  if (const auto legal = check_output_paths(*pairing); !legal) return refuse(legal.error());
  options_.inspect_command = pixel_command_line;
  const std::vector<Comparison> comparisons = compare(*pairing);
  if (const auto written = write_reports(comparisons); !written) return refuse(written.error());
  print(comparisons, *pairing);
  return approve_ ? approve_all(comparisons) : exit_code_of(comparisons);
}

void add_diff_command(CLI::App& app, int& exit_code) {
  add_command<DiffCommand>(app, exit_code);
}

}  // namespace glassbox::app
