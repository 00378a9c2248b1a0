#include "app/diff/diff_request.h"

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/options/choices.h"
#include "cli/options/output_options.h"
#include "cli/report/shell_line.h"

#include <glassbox/base/error.h>
#include <glassbox/compare/pixels/selection.h>
#include <glassbox/compare/pixels/tolerance.h>

namespace glassbox::app {
namespace {

constexpr const char* kTolerance = "Tolerance (without one, every sample has to be the same)";
constexpr const char* kSelection = "What is compared";
constexpr const char* kReports = "Reports";
constexpr const char* kApproval = "Approval (refused if the environment variable CI is set)";

// Returns the value; if there is an error instead, throws CLI11's exception for an invalid option.
template <class T>
T value_or_refuse(const std::string& option, const Result<T>& value) {
  if (value) return *value;
  throw CLI::ValidationError(option, value.error().cause + "; " + value.error().remedy);
}

// Adds an option whose text `parse` turns into the value of `target`, or refuses.
template <class Target, class Parse>
CLI::Option* add_parsed(CLI::App& command, const std::string& name, Target& target, Parse parse,
                        const std::string& type, const std::string& help) {
  return command
      .add_option_function<std::string>(
          name,
          [name, &target, parse](const std::string& text) {
            target = value_or_refuse(name, parse(text));
          },
          help)
      ->type_name(type);
}

// The same for an option that may be given several times: `add` takes what each text means.
template <class Add, class Parse>
CLI::Option* add_parsed_list(CLI::App& command, const std::string& name, Add add, Parse parse,
                             const std::string& type, const std::string& help) {
  return command
      .add_option_function<std::vector<std::string>>(
          name,
          [name, add, parse](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) add(value_or_refuse(name, parse(text)));
          },
          help)
      ->allow_extra_args(false)
      ->type_name(type);
}

void add_pictures(CLI::App& command, DiffRequest& request) {
  command
      .add_option("REFERENCE", request.reference,
                  "the reference picture, or a directory of reference pictures")
      ->required();
  command
      .add_option("TEST", request.test,
                  "the picture to compare with it, or a directory with pictures of the same names")
      ->required();
}

void add_tolerance_options(CLI::App& command, CompareOptions& options) {
  Tolerance& tolerance = options.tolerance;
  add_parsed(command, "--fuzzy", tolerance.fuzzy, parse_fuzzy,
             "'maxDifference=A-B;totalPixels=C-D'",
             "the ranges that pass: of the largest difference in steps (1/255, 1/65535 or ulps), "
             "and of the number of pixels that differ")
      ->group(kTolerance);
  add_parsed(command, "--max-ulp", tolerance.max_ulp, parse_max_ulp, "N",
             "for pictures of floats: the largest difference of two samples that passes, in ulps "
             "(steps from a float to the next)")
      ->group(kTolerance);
  add_parsed(command, "--threshold", tolerance.set_aside.threshold, parse_threshold, "T",
             "colours that are at most this far apart, from 0 to 1, do not count as different: the "
             "distance of odiff, reg-cli and Playwright; 0.1 is 26 steps of grey")
      ->group(kTolerance);
  add_parsed(command, "--max-differing", tolerance.max_differing, parse_max_differing, "N|P%",
             "how many pixels may differ by any amount: a number, or a share of those compared")
      ->group(kTolerance);
  command
      .add_flag("--ignore-antialiasing", tolerance.set_aside.moved_edges,
                "pixels do not count as different where an edge moved by less than a pixel; they "
                "are counted apart")
      ->group(kTolerance);
  const auto add_metrics = [&options](const std::vector<MetricRequest>& more) {
    options.metrics.insert(options.metrics.end(), more.begin(), more.end());
  };
  add_parsed_list(command, "--metric", add_metrics, parse_metrics, "LIST",
                  "report absmax, rmse, psnr, ssim, flip; a metric with a limit (flip.mean<0.05) "
                  "is also a tolerance")
      ->group(kTolerance);
  command.add_flag("--nan-equal", options.nan_equals_nan, "NaN counts as equal to NaN")
      ->group(kTolerance);
}

void add_selection_options(CLI::App& command, CompareOptions& options) {
  const auto ignore = [&options](const PixelBox& box) { options.ignore.push_back(box); };
  add_parsed_list(
      command, "--ignore", ignore, parse_pixel_box, "X,Y,WxH",
      "a rectangle of pixels to leave out of the comparison; may be given several times")
      ->group(kSelection);
  command
      .add_option("--mask", options.mask,
                  "a picture of the same size; where it is black, pixels are not compared")
      ->type_name("FILE")
      ->group(kSelection);
  add_choice(command, "--alpha", options.alpha,
             {{"lenient", AlphaRule::kLenient}, {"strict", AlphaRule::kStrict}},
             "an alpha channel that is opaque everywhere: is the same as none, or is a difference "
             "[lenient]")
      ->group(kSelection);
  add_choice(command, "--align", options.alignment,
             {{"top-left", Alignment::kTopLeft},
              {"centre", Alignment::kCentre},
              {"best", Alignment::kBest}},
             "where pictures of different sizes lie on each other: at a corner, at their centres, "
             "or where they differ least [top-left]")
      ->group(kSelection);
  command
      .add_flag("--ignore-size", options.ignore_size,
                "pictures of different sizes pass if what both have passes")
      ->group(kSelection);
}

void add_report_options(CLI::App& command, DiffRequest& request) {
  command
      .add_option("-o,--output", request.heat,
                  "heat map, .png or .ppm; for directories, a folder of heat maps")
      ->type_name("FILE")
      ->group(kReports);
  add_choice(command, "--heat", request.heat_of,
             {{"steps", HeatMapKind::kSteps}, {"flip", HeatMapKind::kFlip}},
             "what the heat map shows: steps of difference, or the visible error by FLIP [steps]")
      ->group(kReports);
  CLI::Option* html =
      add_html_output(command, request.page, "one page with everything, to open in a browser");
  html->group(kReports);
  command
      .add_flag(
          "--html-files", request.page_files,
          "with --html page.html: the whole pictures go into the folder page-files beside the "
          "page, which loads those that are looked at; for many pictures")
      ->needs(html)
      ->group(kReports);
  add_json_output(command, request.json, "everything")->group(kReports);
  command.add_option("--junit", request.junit, "JUnit's XML for servers; - is standard output")
      ->type_name("FILE|-")
      ->group(kReports);
  command
      .add_option("--markdown", request.markdown,
                  "a summary in Markdown, for a comment or the page of a job; - is standard output")
      ->type_name("FILE|-")
      ->group(kReports);
  command
      .add_flag("--github", request.github,
                "print what does not pass as annotations, too, which GitHub Actions shows beside "
                "the files")
      ->group(kReports);
  command
      .add_flag("--suggest-fuzzy", request.options.suggest_tolerance,
                "print the tightest --fuzzy that would pass, and that still does when a picture "
                "comes nearer to its reference; and the short options")
      ->group(kReports);
}

void add_approval_options(CLI::App& command, DiffRequest& request) {
  command
      .add_flag("--approve", request.approve_all,
                "copy TEST over REFERENCE where they differ or REFERENCE is missing")
      ->group(kApproval);
  command
      .add_option(
          "--approve-matching", request.approve_patterns,
          "the same for pictures whose names match, such as 'menu/*' or 'button-?.png'; may "
          "be given several times")
      ->allow_extra_args(false)
      ->type_name("PATTERN")
      ->group(kApproval);
  command
      .add_option("--approve-list", request.approve_list,
                  "the same for the pictures in this file, one name a line; - is standard input")
      ->type_name("FILE|-")
      ->group(kApproval);
}

}  // namespace

void add_diff_options(CLI::App& command, DiffRequest& request) {
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
      "  glassbox diff golden/teapot.png teapot.png --approve\n"
      "  glassbox diff golden/ out/ --approve-matching 'menu/*'\n\n"
      "A file NAME.fuzzy beside the reference NAME holds its tolerance and the reason for it:\n"
      "  fuzzy: maxDifference=0-1;totalPixels=0-4\n"
      "  reason: four pixels of the rim are ties that the hardware breaks the other way");
  add_pictures(command, request);
  const auto before = std::ptrdiff_t(command.get_options().size());
  add_tolerance_options(command, request.options);
  add_selection_options(command, request.options);
  const auto all = command.get_options();
  request.comparing.assign(all.begin() + before, all.end());
  add_report_options(command, request);
  add_approval_options(command, request);
}

std::string diff_command_line(const DiffRequest& request) {
  std::vector<std::string> words{"diff",
                                 shell_quoted(request.reference) ? request.reference : "REFERENCE",
                                 shell_quoted(request.test) ? request.test : "TEST"};
  for (const CLI::Option* option : request.comparing) {
    const bool flag = option->get_expected_max() == 0;
    if (flag && option->count() > 0) words.push_back(option->get_name());
    for (std::size_t i = 0; !flag && i < option->count(); ++i) {
      words.insert(words.end(), {option->get_name(), option->results()[i]});
    }
  }
  return shell_line({words});
}

}  // namespace glassbox::app
