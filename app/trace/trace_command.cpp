// glassbox trace SCENE -o run.json|run.npz: writes a whole run as data.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/trace/json.h"
#include "app/trace/json_text.h"
#include "cli/options/add_command.h"
#include "cli/options/arguments.h"
#include "cli/options/builtin_help.h"
#include "cli/options/output_options.h"
#include "cli/options/picture_options.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"
#include "labs/framework/zip.h"

#include <glassbox/base/closest_word.h>
#include <glassbox/base/counted.h>
#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>
#include <glassbox/images/atomic_file.h>
#include <glassbox/render/trace/arrays.h>
#include <glassbox/render/trace/numbering.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox::app {

// Writes arrays in NumPy's .npz format: a zip archive with one .npy file for each
// (numpy.lib.format, version 1.0).

namespace {

// The shape as a Python tuple: "(5, 3)", "(5,)", "()"
std::string tuple_of(const std::vector<std::size_t>& shape) {
  std::string text = "(";
  for (std::size_t i = 0; i < shape.size(); ++i)
    text += fmt::format("{}{}", i ? ", " : "", shape[i]);
  return text + (shape.size() == 1 ? ",)" : ")");
}

// The header that precedes an array's bytes.
std::string npy_header(const std::string& type, const std::vector<std::size_t>& shape) {
  std::string text = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': {}, }}", type,
                                 tuple_of(shape));
  // Magic number, version and length take 10 bytes. The size of the whole header must be a multiple
  // of 64, and its last byte a line break.
  constexpr std::size_t kBefore = 10, kMultiple = 64;
  const std::size_t whole = (kBefore + text.size() + 1 + kMultiple - 1) / kMultiple * kMultiple;
  text.resize(whole - kBefore - 1, ' ');
  text += '\n';
  const std::size_t length = text.size();
  return std::string("\x93NUMPY\x01\x00", 8) + char(length & 0xffu) + char(length >> 8) + text;
}

labs::ZipEntry entry(const std::string& name, const std::string& type,
                     const std::vector<std::size_t>& shape, const std::string& bytes) {
  const std::string header = npy_header(type, shape);
  labs::ZipEntry file{name + ".npy", {}, false};
  file.text.reserve(header.size() + bytes.size());
  file.text += header;
  file.text += bytes;
  return file;
}

}  // namespace

// An archive of the wanted arrays, and of `about` as an array of bytes with this name. The bytes
// are moved out of `arrays`.
Result<std::vector<std::byte>> make_npz(TraceArrays& arrays, const std::string& about) {
  std::vector<labs::ZipEntry> files;
  files.push_back(entry("about", "|u1", {about.size()}, about));
  for (Table& table : arrays.tables()) {
    for (Array& array : table.arrays()) {
      if (!array.wanted) continue;
      files.push_back(
          entry(array.name, array.type, table.shape_of(array), std::exchange(array.bytes, {})));
    }
  }
  return labs::make_zip(files);
}

class TraceCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  void add_filter(CLI::App& command);
  int run();
  bool is_json() const;
  Result<void> check_words() const;
  Result<void> check_filter(const Scene& scene) const;
  Result<void> check_size(std::uint64_t bytes, const TraceCounts& counts, Progress& progress) const;
  // Each of these returns a sentence about what was written.
  Result<std::string> write_json(const Scene& scene, const View& view, Progress& progress);
  Result<std::string> write_npz(const Scene& scene, const View& view, Progress& progress);

  std::string scene_;
  std::string output_;
  PictureOptions picture_;
  TraceFilter filter_;
  std::vector<std::string> arrays_;
  std::uint32_t max_megabytes_ = 500;
};

namespace {

constexpr const char* kTraceFooter =
    "Examples:\n"
    "  glassbox trace teapot --size 320x180 -o run.npz\n"
    "  glassbox trace room --size 320x180 --rect 150,80,170,100 -o run.json\n"
    "  glassbox trace room --arrays vertex,fragment.depth,fragment.pixel -o depths.npz\n"
    "  glassbox trace cube --size 64x48 --stages triangles -o - | jq '.triangles[0].corners'\n\n"
    "Every stage's numbers with their bounds; docs/trace.md has the names, shapes and units. An "
    ".npz\n"
    "opens with numpy.load. The options of the picture are those of glassbox render.\n\n";

constexpr double kMegabyte = 1e6;
// sizes below this number of bytes are printed with decimals
constexpr std::uint64_t kWorthSaying = 10'000'000;

std::string megabytes(std::uint64_t bytes) {
  return fmt::format("{:.{}f} MB", double(bytes) / kMegabyte, bytes < kWorthSaying ? 2 : 0);
}

std::string text_of(const TraceCounts& counts) {
  return counted(counts.triangles, "triangle") + " and " + counted(counts.fragments, "fragment");
}

void parse_stages(const std::string& text, TraceFilter& filter) {
  filter.triangles = filter.fragments = filter.colors = false;
  for (const std::string& name : split(text, ',')) {
    if (name == "triangles") {
      filter.triangles = true;
    } else if (name == "fragments") {
      filter.fragments = true;
    } else if (name == "colors") {
      filter.fragments = filter.colors = true;
    } else {
      throw CLI::ValidationError(
          "--stages",
          "needs some of triangles, fragments and colors, separated by commas, not '" + name + "'");
    }
  }
}

// The names of all arrays, and of the groups that they belong to.
std::vector<std::string> names_of(const TraceArrays& arrays) {
  std::vector<std::string> names;
  for (const Table& table : arrays.tables()) {
    for (const Array& array : table.arrays()) {
      names.push_back(array.name);
      const std::string group = array.name.substr(0, array.name.find('.'));
      if (std::ranges::find(names, group) == names.end()) names.push_back(group);
    }
  }
  return names;
}

}  // namespace

void TraceCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand(
      "trace", "write the numbers of every stage of a run, as JSON or NumPy arrays");
  command.footer(kTraceFooter + builtin_help());
  command.add_option("SCENE", scene_, kSceneHelp)->required();
  command.add_option("-o,--output", output_, ".json or .npz; - is JSON on standard output")
      ->type_name("FILE|-")
      ->required();
  add_filter(command);
  add_picture_options(command, picture_);
  add_max_megabytes(command, max_megabytes_, ", before compression");
  command.callback([this, &exit_code] { exit_code = run(); });
}

void TraceCommand::add_filter(CLI::App& command) {
  const std::string group = "What is kept";
  command
      .add_option_function<std::string>(
          "--stages", [this](const std::string& text) { parse_stages(text, filter_); },
          "parts to record: triangles (the geometric stages), fragments (coverage, depth and "
          "weights), colors (attributes and colours) [all]")
      ->type_name("LIST")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--arrays", [this](const std::string& text) { arrays_ = split(text, ','); },
          "for an .npz: only these arrays (vertex.ndc) or groups of arrays (vertex) [all]")
      ->type_name("LIST")
      ->group(group);
  command
      .add_option("--triangle", filter_.triangle, "only this triangle, by its number in the scene")
      ->type_name("N")
      ->group(group);
  command.add_option("--instance", filter_.instance, "only this instance of a mesh")
      ->type_name("K")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--rect",
          [this](const std::string& text) { filter_.pixels = parse_rectangle("--rect", text); },
          "only triangles and fragments in these pixels, X0 <= x < X1 and Y0 <= y < Y1")
      ->type_name("X0,Y0,X1,Y1")
      ->group(group);
}

bool TraceCommand::is_json() const {
  return output_ == "-" || check_extension(output_, ".json").has_value();
}

Result<void> TraceCommand::check_words() const {
  if (!is_json() && !check_extension(output_, ".npz")) {
    return tl::unexpected(Error{output_, "", "a trace is a .json or an .npz file",
                                "end the name in one of them, or give - for JSON"});
  }
  if (is_json() && !arrays_.empty()) {
    return fail("--arrays", "JSON has records, not arrays", "give -o FILE.npz, or --stages");
  }
  for (const std::string& array : arrays_) {
    const bool of_fragments = array.substr(0, array.find('.')) == "fragment";
    if (of_fragments && !filter_.fragments) {
      return fail("--arrays " + array, "--stages leaves the fragments out",
                  "add fragments to --stages, or leave --stages out");
    }
  }
  if (output_ != "-") {
    if (const auto legal = check_outputs({output_}); !legal) return legal;
  }
  if (filter_.pixels) return check_rectangle("--rect", *filter_.pixels, picture_.size);
  return {};
}

Result<void> TraceCommand::check_filter(const Scene& scene) const {
  if (filter_.triangle) {
    const auto legal = check_triangle("--triangle", scene, *filter_.triangle);
    if (!legal) return legal;
  }
  if (filter_.instance && *filter_.instance >= scene.instances.size()) {
    return fail(fmt::format("--instance {}", *filter_.instance),
                "the scene has " + counted(scene.instances.size(), "instance"),
                "they are numbered from 0");
  }
  return {};
}

Result<void> TraceCommand::check_size(std::uint64_t bytes, const TraceCounts& counts,
                                      Progress& progress) const {
  const std::string size =
      fmt::format("{}, {}{}", text_of(counts), is_json() ? "about " : "", megabytes(bytes));
  if (double(bytes) > double(max_megabytes_) * kMegabyte) {
    return fail(fmt::format("--max-mb {}", max_megabytes_), "the run needs " + size,
                fmt::format("keep less of it (--triangle, --instance, --rect, --stages{}, a "
                            "smaller --size), or allow more with --max-mb {}",
                            is_json() ? "" : ", --arrays",
                            bytes / std::uint64_t(kMegabyte) + 1 +
                                (is_json() ? bytes / std::uint64_t(kMegabyte) / 20 : 0)));
  }
  if (bytes > kWorthSaying) progress.print_line(size + " will be written");
  return {};
}

Result<std::string> TraceCommand::write_json(const Scene& scene, const View& view,
                                             Progress& progress) {
  constexpr std::uint64_t kOneIn = 101;
  TraceText sample(scene, view, picture_.settings, kOneIn);
  trace(scene, view, picture_.settings, filter_, sample);
  const TraceCounts counts = sample.counts();
  if (const auto legal = check_size(sample.bytes(), counts, progress); !legal) {
    return tl::unexpected(legal.error());
  }
  TraceText whole(scene, view, picture_.settings);
  trace(scene, view, picture_.settings, filter_, whole);
  const std::string text = whole.finish(scene_);
  progress.done();
  return write_text(output_, text).map([&] {
    return text_of(counts) + ", " + megabytes(text.size());
  });
}

Result<std::string> TraceCommand::write_npz(const Scene& scene, const View& view,
                                            Progress& progress) {
  TraceArrays arrays(view, arrays_);
  if (!arrays.unknown().empty()) {
    const std::string word = arrays.unknown()[0];
    const std::vector<std::string> names = names_of(arrays);
    const auto near = closest_word(word, names);
    return fail("--arrays", "there is no array or group " + in_quotes(word),
                near ? "did you mean " + std::string(*near) + "?" : "docs/trace.md lists them");
  }
  TraceCounter counter;
  trace(scene, view, picture_.settings, filter_, counter);
  const TraceCounts counts = counter.counts();
  const std::uint64_t bytes = arrays.bytes_for(counts);
  if (const auto legal = check_size(bytes, counts, progress); !legal) {
    return tl::unexpected(legal.error());
  }
  arrays.reserve(counts);
  trace(scene, view, picture_.settings, filter_, arrays);
  arrays.finish();
  const auto npz =
      make_npz(arrays, head_text(scene, scene_, view, picture_.settings, counter.draws()));
  if (!npz) return tl::unexpected(npz.error());
  progress.done();
  return write_file(output_, *npz).map([&] {
    return text_of(counts) + ", " + megabytes(bytes) + " of arrays";
  });
}

int TraceCommand::run() {
  if (const auto legal = check_words(); !legal) return refuse(legal.error());
  print_pixel_centres_note(picture_);
  // the filter needs no limit, because --max-mb limits the size
  filter_.max_bytes = std::numeric_limits<std::uint64_t>::max();
  Progress progress;
  const Result<Scene> scene = load_scene_argument(scene_, picture_, progress);
  if (!scene) return refuse(scene.error());
  if (const auto legal = check_filter(*scene); !legal) return refuse(legal.error());
  const Result<ChosenView> chosen = choose_view(*scene, picture_);
  if (!chosen) return refuse(chosen.error());
  progress.phase("tracing " + scene_title(scene_));
  const Result<std::string> written = is_json() ? write_json(*scene, chosen->view, progress)
                                                : write_npz(*scene, chosen->view, progress);
  if (!written) return refuse(written.error());
  if (output_ != "-") fmt::print("{}: {}\n", printable(output_), *written);
  return kSuccess;
}

void add_trace_command(CLI::App& app, int& exit_code) {
  add_command<TraceCommand>(app, exit_code);
}

}  // namespace glassbox::app
