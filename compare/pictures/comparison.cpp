#include <glassbox/compare/pictures/comparison.h>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <glassbox/base/printable.h>
#include <glassbox/compare/pictures/prepared_pair.h>
#include <glassbox/compare/pictures/rules.h>
#include <glassbox/compare/pictures/sidecar.h>
#include <glassbox/compare/pixels/difference_text.h>
#include <glassbox/compare/pixels/explanation.h>
#include <glassbox/images/png_text.h>
#include <glassbox/images/read.h>
#include <glassbox/images/stored_file.h>

namespace glassbox {
namespace {

PictureFacts facts(const std::string& path, const StoredImage& image) {
  return {path, image.width, image.height, channel_names(image), format_name(image)};
}

bool is_float(const StoredImage& image) {
  return std::holds_alternative<std::vector<float>>(image.samples);
}

// The limits that do not allow the differences, in words; empty if all limits do.
std::vector<std::string> broken_limits(const CompareOptions& options, const PicturePair& pair,
                                       const Differences& found,
                                       const std::vector<MetricValue>& metrics) {
  std::vector<std::string> broken;
  const auto& [fuzzy, max_ulp, max_differing, set_aside] = options.tolerance;
  if (fuzzy && !allows(*fuzzy, found)) {
    const std::string needed = found.largest == kUnbounded ? steps_text(kUnbounded, pair.reference)
                                                           : to_string(tightest_fuzzy(found));
    broken.push_back(fmt::format("{} is not within {}", needed, to_string(*fuzzy)));
  }
  if (max_ulp && found.largest > *max_ulp) {
    broken.push_back(fmt::format("{} is not within {}", steps_text(found.largest, pair.reference),
                                 steps_text(*max_ulp, pair.reference)));
  }
  if (max_differing && !allows(*max_differing, found)) {
    broken.push_back(found.largest == kUnbounded
                         ? "no number of pixels allows NaN or an infinity in place of a number"
                         : fmt::format("more than {} of {} pixels differ",
                                       to_string(*max_differing), found.compared));
  }
  if (set_aside.threshold && !fuzzy && !max_differing && found.differing > 0) {
    broken.push_back(fmt::format(
        "{} further apart than the threshold {}",
        found.differing == 1 ? "a pixel is" : fmt::format("{} pixels are", found.differing),
        *set_aside.threshold));
  }
  for (const MetricValue& metric : metrics) {
    if (metric.passes) continue;
    const std::string value = metric.value ? fmt::format("{:.6g}", *metric.value)
                                           : "not defined (" + metric.why_not + ")";
    broken.push_back(fmt::format("{} is {}, not {}", metric.name, value,
                                 to_string({metric.name, metric.limit})));
  }
  return broken;
}

// Whether there is a limit. Without one, no pixel may differ, except those that are set aside.
bool gates(const Tolerance& tolerance, const std::vector<MetricRequest>& metrics) {
  return tolerance.fuzzy || tolerance.max_ulp || tolerance.max_differing ||
         tolerance.set_aside.threshold || has_limit(metrics);
}

// What the pictures have where both are, for pictures of different sizes.
std::string overlap_text(const Canvas& canvas, const std::string& differences) {
  const PixelBox overlap = canvas.overlap();
  const std::string size = fmt::format("{} x {} pixels", overlap.width, overlap.height);
  return differences.empty() ? fmt::format("the {} that both have are the same", size)
                             : fmt::format("in the {} that both have, {}", size, differences);
}

// The reasons and the verdict, from `differences` and `metrics`. `mismatch` says that the sizes
// differ; it is empty where they do not.
void decide_verdict(Comparison& comparison, const CompareOptions& options, const PicturePair& pair,
                    const std::vector<std::string>& mismatch) {
  const Differences& found = *comparison.differences;
  std::vector<std::string>& reasons = comparison.reasons;
  const bool gated = gates(options.tolerance, options.metrics);
  if (gated) reasons = broken_limits(options, pair, found, comparison.metrics);
  const bool allowed = gated ? reasons.empty() : found.differing == 0;
  reasons.insert(reasons.end(), mismatch.begin(), mismatch.end());
  const std::string words = found.has_any() ? differences_text(pair, found) : "";
  if (comparison.canvas) {
    reasons.push_back(overlap_text(*comparison.canvas, words));
  } else if (!words.empty()) {
    reasons.push_back(words);
  }
  if (!allowed || (comparison.canvas && !options.ignore_size)) {
    comparison.verdict = Verdict::kDifferent;
  } else {
    const bool same = !found.has_any() && !comparison.canvas;
    comparison.verdict = same ? Verdict::kSame : Verdict::kWithinTolerance;
  }
}

// A sentence about where pictures of different sizes lie; empty if their top left corners lie on
// each other.
std::string place_text(const Canvas& canvas) {
  const int x = canvas.test.x - canvas.reference.x, y = canvas.test.y - canvas.reference.y;
  if (x == 0 && y == 0) return {};
  std::string text =
      fmt::format("the test begins at ({}, {}), counted from the reference's top left pixel", x, y);
  if (canvas.reference.x > 0 || canvas.reference.y > 0) {
    text += fmt::format(
        "; positions are counted on a canvas on which the reference begins at ({}, {}), the test "
        "at ({}, {})",
        canvas.reference.x, canvas.reference.y, canvas.test.x, canvas.test.y);
  }
  return text;
}

// Options that would let the pictures pass.
std::vector<std::string> suggestions_for(const PicturePair& pair, const Comparison& comparison,
                                         bool ignore_size) {
  const auto fails = [](const MetricValue& metric) { return !metric.passes; };
  if (std::ranges::any_of(comparison.metrics, fails)) {
    return {"no suggestion: a metric does not keep its limit"};
  }
  const Differences& found = *comparison.differences;
  std::vector<std::string> lines{"fuzzy: " + suggested_fuzzy(found)};
  const std::string options = suggested_options(pair, found);
  if (!options.empty()) lines.push_back("short: " + options);
  if (comparison.canvas && !ignore_size) lines.push_back("together with: --ignore-size");
  return lines;
}

std::string words_of(const Recipe& recipe) {
  std::string text = recipe.scene;
  for (const std::string& word : recipe.options) text += " " + word;
  return printable(text, 400);
}

std::optional<Recipe> recipe_in(const std::string& path) {
  const auto bytes = read_file(path);
  if (!bytes) return std::nullopt;
  const auto text = read_png_text(*bytes);
  return text ? recipe_of(*text) : std::nullopt;
}

// Adds what the recipes in the two files say about the difference.
void consult_recipes(Comparison& comparison, const CompareOptions& options) {
  const auto reference = recipe_in(comparison.reference.path);
  const auto test = recipe_in(comparison.test.path);
  if (!reference || !test) return;
  if (reference->scene != test->scene || reference->options != test->options) {
    comparison.hints.push_back("they were rendered with other options: the reference with \"" +
                               words_of(*reference) + "\", the test with \"" + words_of(*test) +
                               "\"");
  }
  if (reference->version != test->version) {
    comparison.hints.push_back("the reference was rendered by glassbox " + reference->version +
                               ", the test by " + test->version);
  }
  if (options.inspect_command && comparison.differences && comparison.differences->differing > 0) {
    PixelPosition pixel = comparison.differences->first;
    if (comparison.canvas) {
      pixel = {pixel.x - comparison.canvas->test.x, pixel.y - comparison.canvas->test.y};
    }
    comparison.inspect_command = options.inspect_command(*test, pixel);
  }
}

Comparison uncompared(Comparison comparison, Error error) {
  comparison.verdict = Verdict::kUncompared;
  comparison.error = std::move(error);
  return comparison;
}

// Notes what is odd about the files, and what of them is not compared pixel by pixel. Refuses a
// verdict that passes where the rest of the files could look different.
void consider_rest(Comparison& comparison, const StoredFile& reference, const StoredFile& test) {
  std::vector<std::string>& notes = comparison.notes;
  for (const auto& [name, file] :
       {std::pair("the reference: ", &reference), std::pair("the test: ", &test)}) {
    for (const std::string& note : file->notes) notes.push_back(name + note);
  }
  if (reference.orientation != test.orientation) {
    notes.push_back(
        fmt::format("turned upright: the Exif orientation of the reference is {}, that "
                    "of the test {}",
                    reference.orientation, test.orientation));
  }
  if (reference.rest.empty() && test.rest.empty()) return;
  const auto name_of = [](const StoredFile& file) {
    return file.rest.empty() ? "nothing" : file.rest_name;
  };
  const std::string what =
      fmt::format("besides the first picture, the reference has {}, the test {}",
                  name_of(reference), name_of(test));
  if (reference.rest == test.rest) {
    notes.push_back(what + "; these are the same bytes, and are not compared further");
  } else if (!passes(comparison.verdict)) {
    notes.push_back(what + "; only the first pictures are compared");
  } else {
    comparison.verdict = Verdict::kUncompared;
    comparison.error = Error{comparison.test.path, "",
                             "the first pictures pass, but nothing else can be compared: " + what +
                                 ", which are not the same bytes",
                             (reference.rest.empty() ? test : reference).rest_remedy};
  }
}

}  // namespace

Result<Selection> selection_of(const StoredImage& reference, const std::vector<PixelBox>& ignore,
                               const std::string& mask) {
  Selection selection(reference.width, reference.height);
  for (const PixelBox& box : ignore) {
    if (const auto done = selection.exclude(box); !done) return tl::unexpected(done.error());
  }
  if (!mask.empty()) {
    const auto image = read_stored(mask);
    if (!image) return tl::unexpected(image.error());
    if (auto done = selection.exclude_black(*image); !done) {
      done.error().file = mask;
      return tl::unexpected(done.error());
    }
  }
  if (selection.compared_pixels() == 0) {
    return fail("", "all pixels are left out, so there is nothing to compare",
                "make --ignore or --mask smaller");
  }
  return selection;
}

Comparison compare_files(const std::string& reference_path, const std::string& test_path,
                         const CompareOptions& options) {
  Comparison comparison;
  comparison.name = test_path;
  comparison.reference.path = reference_path;
  comparison.test.path = test_path;

  const auto sidecar = find_sidecar(reference_path);
  if (!sidecar) return uncompared(std::move(comparison), sidecar.error());
  auto reference_file = read_stored_file(reference_path);
  if (!reference_file) return uncompared(std::move(comparison), reference_file.error());
  comparison.reference = facts(reference_path, reference_file->image);
  auto test_file = read_stored_file(test_path);
  if (!test_file) return uncompared(std::move(comparison), test_file.error());
  comparison.test = facts(test_path, test_file->image);

  const auto pixels = std::make_shared<PreparedPair>(
      prepare_pair(std::move(reference_file->image), std::move(test_file->image), options));
  const PreparedPair& prepared = *pixels;
  comparison.opaque_alpha = prepared.opaque_alpha;
  if (!prepared.is_comparable()) {
    comparison.reasons = prepared.mismatch;
    comparison.verdict = Verdict::kDifferent;
    consult_recipes(comparison, options);
    consider_rest(comparison, *reference_file, *test_file);
    return comparison;
  }
  ComparisonRules rules = combine_rules(options, *sidecar, comparison.notes);
  // max_ulp applies to floats only.
  if (!is_float(prepared.reference)) rules.options.tolerance.max_ulp.reset();
  comparison.tolerance = tolerance_text(rules.options, prepared.canvas.has_value());
  comparison.tolerance_reason = rules.reason;
  comparison.ignore = rules.options.ignore;
  comparison.mask = rules.options.mask;
  comparison.nan_equals_nan = options.nan_equals_nan;
  comparison.canvas = prepared.canvas;
  comparison.set_aside = rules.options.tolerance.set_aside;
  const auto selection = selection_of(prepared, comparison);
  if (!selection) return uncompared(std::move(comparison), selection.error());

  PicturePair pair = picture_pair(prepared, *selection, comparison);
  comparison.differences =
      find_differences(pair, pair.set_aside.empty() ? nullptr : &pixels->kinds);
  pair.kinds = pixels->kinds;
  if (options.keep_pixels) comparison.pixels = pixels;
  comparison.metrics = measure_metrics(pair, rules.options.metrics);
  decide_verdict(comparison, rules.options, pair, prepared.mismatch);
  if (comparison.differences->differing > 0) {
    comparison.hints = explain_differences(pair, *comparison.differences);
  }
  if (rules.tolerance_of_sidecar && passes(comparison.verdict)) {
    const std::string note = stale_tolerance_text(rules, *comparison.differences);
    if (!note.empty()) comparison.notes.push_back(note);
  }
  const std::string place = prepared.canvas ? place_text(*prepared.canvas) : "";
  if (!place.empty()) comparison.notes.push_back(place);
  if (options.suggest_tolerance) {
    comparison.suggestions = suggestions_for(pair, comparison, options.ignore_size);
  }
  if (!passes(comparison.verdict)) consult_recipes(comparison, options);
  consider_rest(comparison, *reference_file, *test_file);
  return comparison;
}

Comparison compare_pair(const PicturePaths& paths, const CompareOptions& options) {
  if (paths.has_reference && paths.has_test) {
    Comparison comparison = compare_files(paths.reference, paths.test, options);
    comparison.name = paths.name;
    return comparison;
  }
  Comparison comparison;
  comparison.name = paths.name;
  comparison.reference.path = paths.reference;
  comparison.test.path = paths.test;
  if (paths.has_test) {
    comparison.verdict = Verdict::kNew;
    comparison.error = Error{paths.reference, "", "there is no such reference",
                             "look at " + paths.test + "; --approve makes it the reference"};
  } else {
    comparison.verdict = Verdict::kMissing;
    comparison.error = Error{paths.test, "", "there is no such picture",
                             paths.has_reference ? "render it, or delete its reference"
                                                 : "name two pictures that are there"};
  }
  return comparison;
}

}  // namespace glassbox
