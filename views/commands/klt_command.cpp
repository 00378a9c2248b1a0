// glassbox views klt: finds the directions in which the bands of pictures vary.
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "cli/options/add_command.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "cli/report/shell_line.h"
#include "views/commands/commands.h"
#include "views/commands/klt_report.h"
#include "views/klt/band_files.h"
#include "views/klt/clouds.h"
#include "views/klt/globe.h"

#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/images/write.h>
#include <glassbox/mesh/gltf/write.h>

namespace glassbox::views {

class ViewsKltCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  int run();
  Result<void> check_outputs() const;
  // Checks the files in the output folder too: none may be an input or occur twice.
  Result<void> check_files(int kept) const;
  // Reads the sizes of the bands into files_.
  Result<void> open();
  Result<void> check_memory(int kept) const;
  Result<KltInput> read() const;
  Result<void> write_outputs(const KltInput& input, const KltReport& report) const;
  Result<void> write_folder(const KltInput& input, const KltReport& report) const;

  std::uint64_t most_bytes() const { return std::uint64_t(max_megabytes_) << 20; }

  std::vector<std::string> bands_;
  views::BandFiles files_;  // set for the generated planet too, which has no files
  bool is_planet_ = false;
  std::optional<int> kept_;
  std::uint32_t max_megabytes_ = 2048;
  std::optional<std::string> output_, globe_, json_output_, page_;
  std::vector<const CLI::Option*> options_;
};

namespace {

// The width of the generated planet for "clouds" or "clouds:1024"; 0 for any other word.
Result<int> cloud_width(const std::string& word) {
  if (word == "clouds") return views::kCloudWidth;
  if (!word.starts_with("clouds:")) return 0;
  int width = 0;
  const char *first = word.data() + 7, *last = word.data() + word.size();
  const auto [end, error] = std::from_chars(first, last, width);
  if (error != std::errc() || end != last || width < 16 || width > views::kMaxCloudWidth ||
      width % 2 != 0) {
    return fail(
        printable(word),
        fmt::format("the width must be an even number from 16 to {}", views::kMaxCloudWidth),
        "write for example 'clouds:1024'");
  }
  return width;
}

// Component k as a grey picture, whose range is three standard deviations on either side of the
// mean.
Image<Rgba8> picture_of(const views::Bands& components, const views::Klt& klt, int k) {
  const double reach = 3 * std::sqrt(klt.eigenvalues[k]);
  return views::grey_of(components, k, -reach, reach);
}

}  // namespace

void ViewsKltCommand::add_to(CLI::App& views, int& exit_code) {
  CLI::App& command = *views.add_subcommand("klt",
                                            "compute the principal components of pictures: the "
                                            "directions in which their bands vary most");
  command.footer(
      "Examples:\n"
      "  glassbox views klt clouds\n"
      "  glassbox views klt clouds --components 2 -o klt --globe globe.glb --html klt.html\n"
      "  glassbox views klt red.pgm green.pgm infrared.png\n"
      "  glassbox views klt cube.hdr --components 3 -o klt --json -\n\n"
      "clouds (or clouds:1024, its width) is a generated planet at five wavelengths. -o writes\n"
      "component1.png ... (grey is 0, black and white are three standard deviations), all numbers "
      "of\n"
      "the components and of the reconstructed bands as raw cubes (components.hdr, again.hdr), and "
      "the\n"
      "bands of the generated planet. docs/klt.md has more.");
  command
      .add_option("BANDS", bands_,
                  "pictures of one size (one band from a grey picture, three from a colour "
                  "picture), headers X.hdr of raw files of bands (ENVI), or the word clouds")
      ->required();
  const std::size_t before = command.get_options().size();
  command
      .add_option("--components", kept_,
                  "number of components that are kept [2, or 1 if there is one band]")
      ->type_name("K");
  const auto all = command.get_options();
  options_.assign(all.begin() + std::ptrdiff_t(before), all.end());
  command
      .add_option("-o,--output", output_, "a folder for the components and the reconstructed bands")
      ->type_name("DIR");
  command
      .add_option("--globe", globe_, "a planet with component 1 as its clouds: a scene for render")
      ->type_name("FILE.glb");
  add_html_output(command, page_,
                  "a page with the bands reconstructed from any number of components");
  add_json_output(command, json_output_);
  command
      .add_option("--max-mb", max_megabytes_,
                  "most memory, in megabytes, for the bands and their components; larger input is "
                  "refused [" +
                      std::to_string(max_megabytes_) + "]")
      ->type_name("N")
      ->group("Limits");
  command.callback([this, &exit_code] { exit_code = run(); });
}

Result<void> ViewsKltCommand::check_outputs() const {
  std::error_code ignored;
  if (output_ && std::filesystem::exists(*output_, ignored) &&
      !std::filesystem::is_directory(*output_, ignored))
    return tl::unexpected(Error{*output_, "", "is not a folder", "name another folder"});
  return Outputs().file(globe_, ".glb").file(page_, ".html").data(json_output_).check();
}

Result<void> ViewsKltCommand::check_files(int kept) const {
  std::vector<std::string> inputs, outputs;
  for (const views::BandFiles::File& file : files_.files) {
    inputs.push_back(file.path);
    if (file.cube) inputs.push_back(file.numbers);
  }
  for (const auto& file : {globe_, page_, json_output_}) {
    if (file && *file != "-") outputs.push_back(*file);
  }
  if (output_) {
    for (const char* name : {"components.hdr", "components.img", "again.hdr", "again.img"})
      outputs.push_back(*output_ + "/" + name);
    for (int k = 1; k <= kept; ++k)
      outputs.push_back(fmt::format("{}/component{}.png", *output_, k));
    for (int b = 1; is_planet_ && b <= files_.count; ++b)
      outputs.push_back(fmt::format("{}/band{}.png", *output_, b));
  }
  return check_distinct(outputs, inputs);
}

Result<void> ViewsKltCommand::open() {
  const auto width = cloud_width(bands_.front());
  if (!width) return tl::unexpected(width.error());
  if (*width == 0) {
    auto files = views::open_bands(bands_, most_bytes());
    if (!files) return tl::unexpected(files.error());
    files_ = std::move(*files);
  } else if (bands_.size() > 1) {
    return fail(printable(bands_[1]), "the generated planet cannot be combined with files",
                "give clouds alone, or files alone");
  } else {
    is_planet_ = true;
    files_ = {*width, *width / 2, views::kCloudBands, {}};
  }
  return {};
}

// Refuses too much memory. In memory at the same time are the bands, the kept components, the
// reconstructed bands, and a copy of these if they are written to a file.
Result<void> ViewsKltCommand::check_memory(int kept) const {
  const int planes = 2 * files_.count + kept + (output_ ? files_.count : 0);
  return views::check_planes(std::uint64_t(files_.width), std::uint64_t(files_.height),
                             std::uint64_t(planes), most_bytes(),
                             "the bands, their components and the reconstructed bands");
}

Result<KltInput> ViewsKltCommand::read() const {
  KltInput input;
  input.source = bands_.size() == 1 ? bands_.front() : fmt::format("{} files", bands_.size());
  if (is_planet_) {
    views::CloudScene scene = views::make_clouds(files_.width);
    input.bands = std::move(scene.bands);
    input.ground = std::move(scene.ground);
    input.opacity = std::move(scene.opacity);
    return input;
  }
  auto bands = views::decode_bands(files_);
  if (!bands) return tl::unexpected(bands.error());
  input.bands = std::move(*bands);
  return input;
}

Result<void> ViewsKltCommand::write_folder(const KltInput& input, const KltReport& report) const {
  std::error_code error;
  std::filesystem::create_directories(*output_, error);
  if (error)
    return fail("-o",
                "the folder " + printable(*output_) + " cannot be created: " + error.message(),
                "name another folder");
  for (int k = 0; k < report.kept; ++k) {
    const auto written = write_image(fmt::format("{}/component{}.png", *output_, k + 1),
                                     picture_of(report.components, report.klt, k));
    if (!written) return written;
  }
  if (const auto written = views::write_cube(*output_ + "/components", report.components); !written)
    return written;
  if (const auto written = views::write_cube(*output_ + "/again", report.reconstructed); !written)
    return written;
  for (int b = 0; input.ground && b < input.bands.count(); ++b) {
    const StoredImage band{
        input.bands.width, input.bands.height, 1,
        std::vector<std::uint16_t>(input.bands.bands[std::size_t(b)].samples.begin(),
                                   input.bands.bands[std::size_t(b)].samples.end())};
    const auto written = encode_png(band).and_then([&](const std::vector<std::byte>& png) {
      return write_file(fmt::format("{}/band{}.png", *output_, b + 1), png);
    });
    if (!written) return written;
  }
  return {};
}

Result<void> ViewsKltCommand::write_outputs(const KltInput& input, const KltReport& report) const {
  if (output_) {
    if (const auto written = write_folder(input, report); !written) return written;
  }
  if (globe_) {
    const Image<Rgba8> sea(2, 1, {40, 70, 110, 255});
    const Scene scene =
        views::make_globe(input.ground.value_or(sea), views::cloud_alpha(report.components));
    if (const auto written = write_glb(scene, *globe_); !written) return written;
  }
  const nlohmann::ordered_json json = klt_json(input, report);
  if (page_) {
    const std::string line =
        shell_line({{"views", "klt"}, bands_, option_words(options_), {"--html", *page_}});
    const auto written = write_text_result(
        *page_, make_klt_page(input, report, json, {"glassbox " GLASSBOX_VERSION, line}));
    if (!written) return written;
  }
  return json_output_ ? write_json(*json_output_, json) : Result<void>();
}

int ViewsKltCommand::run() {
  if (const auto legal = check_outputs(); !legal) return refuse(legal.error());
  Progress progress;
  progress.phase("reading the bands");
  if (const auto good = open(); !good) return refuse(good.error());
  const int count = files_.count, kept = kept_.value_or(std::min(2, count));
  if (kept < 1 || kept > count) {
    return refuse({{},
                   "--components",
                   fmt::format("the number must be from 1 to {}", count),
                   "give a number in that range"});
  }
  for (const auto& good : {check_memory(kept), check_files(kept)}) {
    if (!good) return refuse(good.error());
  }
  if (page_) {
    const auto good = check_klt_page(std::uint64_t(files_.width), std::uint64_t(files_.height),
                                     std::uint64_t(count));
    if (!good) return refuse(good.error());
  }
  const auto input = read();
  if (!input) return refuse(input.error());
  progress.phase("finding the components");
  const auto report = report_klt(*input, kept);
  if (!report) return refuse(report.error());
  progress.phase("writing");
  if (const auto written = write_outputs(*input, *report); !written) return refuse(written.error());
  progress.done();
  const int exit = report->holds() ? kSuccess : kFailure;
  if (json_output_ == "-") return exit;
  fmt::print("{}", klt_text(*input, *report));
  if (page_) fmt::print("\n{}: open it in a browser\n", printable(*page_, kLongestMessage));
  return exit;
}

void add_klt_command(CLI::App& views, int& exit_code) {
  add_command<ViewsKltCommand>(views, exit_code);
}

}  // namespace glassbox::views
