#include <glassbox/compare/pictures/sidecar.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include <glassbox/base/printable.h>
#include <glassbox/base/trimmed.h>
#include <glassbox/base/utf8.h>
#include <glassbox/images/read.h>

namespace glassbox {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxBytes = 64 * 1024;

// Splits "key: value" into key and value. A line without a key is the fuzzy annotation itself.
std::pair<std::string, std::string> split_line(std::string_view line) {
  const auto colon = line.find(':');
  if (colon == std::string_view::npos) return {"fuzzy", std::string(line)};
  return {std::string(trimmed(line.substr(0, colon))),
          std::string(trimmed(line.substr(colon + 1)))};
}

// Whether the key has already been read. Only for keys that a sidecar may have no more than once.
bool is_known(const Sidecar& sidecar, const std::string& key) {
  return (key == "fuzzy" && sidecar.tolerance.fuzzy) ||
         (key == "max-ulp" && sidecar.tolerance.max_ulp) ||
         (key == "threshold" && sidecar.tolerance.set_aside.threshold) ||
         (key == "max-differing" && sidecar.tolerance.max_differing) ||
         (key == "ignore-antialiasing" && sidecar.tolerance.set_aside.moved_edges) ||
         (key == "mask" && !sidecar.mask.empty()) || (key == "reason" && !sidecar.reason.empty());
}

Result<void> read_line(Sidecar& sidecar, const std::string& key, const std::string& value) {
  if (is_known(sidecar, key)) {
    return fail("", in_quotes(key) + " occurs twice", "keep one of the two lines");
  }
  if (key == "fuzzy") {
    const auto fuzzy = parse_fuzzy(value);
    if (!fuzzy) return tl::unexpected(fuzzy.error());
    sidecar.tolerance.fuzzy = *fuzzy;
  } else if (key == "max-ulp") {
    const auto ulps = parse_max_ulp(value);
    if (!ulps) return tl::unexpected(ulps.error());
    sidecar.tolerance.max_ulp = *ulps;
  } else if (key == "threshold") {
    const auto threshold = parse_threshold(value);
    if (!threshold) return tl::unexpected(threshold.error());
    sidecar.tolerance.set_aside.threshold = *threshold;
  } else if (key == "max-differing") {
    const auto most = parse_max_differing(value);
    if (!most) return tl::unexpected(most.error());
    sidecar.tolerance.max_differing = *most;
  } else if (key == "ignore-antialiasing") {
    if (value != "yes") {
      return fail("", in_quotes(key) + " has the value " + in_quotes(value),
                  "write yes, or delete the line");
    }
    sidecar.tolerance.set_aside.moved_edges = true;
  } else if (key == "metric") {
    const auto metrics = parse_metrics(value);
    if (!metrics) return tl::unexpected(metrics.error());
    sidecar.metrics.insert(sidecar.metrics.end(), metrics->begin(), metrics->end());
  } else if (key == "ignore") {
    const auto box = parse_pixel_box(value);
    if (!box) return tl::unexpected(box.error());
    sidecar.ignore.push_back(*box);
  } else if (key == "mask") {
    if (value.empty())
      return fail("", "the mask has no name", "name a picture, or delete the line");
    sidecar.mask = (fs::path(sidecar.path).parent_path() / value).string();
  } else if (key == "reason") {
    sidecar.reason = printable(value, 1000);
  } else {
    return fail(
        "", "unknown key " + in_quotes(key),
        "the keys are fuzzy, max-ulp, threshold, max-differing, ignore-antialiasing, metric, "
        "ignore, mask and reason");
  }
  return {};
}

}  // namespace

Result<Sidecar> parse_sidecar(const std::string& path, const std::string& text) {
  Sidecar sidecar;
  sidecar.path = path;
  int number = 0;
  for (std::size_t start = text.size() - without_byte_order_mark(text).size();
       start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view line = trimmed(std::string_view(text).substr(start, end - start));
    start = end + 1;
    ++number;
    if (line.empty() || line.front() == '#') continue;
    const auto [key, value] = split_line(line);
    const auto read = read_line(sidecar, key, value);
    if (!read) {
      return tl::unexpected(
          Error{path, "line " + std::to_string(number), read.error().cause, read.error().remedy});
    }
  }
  if (sidecar.reason.empty()) {
    return tl::unexpected(Error{path, "", "has no reason", "add a line \"reason: ...\""});
  }
  return sidecar;
}

Result<std::optional<Sidecar>> find_sidecar(const std::string& reference) {
  const std::string full = reference + ".fuzzy";
  const std::string stem = fs::path(reference).replace_extension(".fuzzy").string();
  std::error_code ignored;
  const bool has_full = fs::exists(full, ignored);
  const bool has_stem = stem != full && fs::exists(stem, ignored);
  if (has_full && has_stem) {
    return tl::unexpected(
        Error{full, "", "there are two files for one picture, this one and " + in_quotes(stem),
              "keep one of the two"});
  }
  if (!has_full && !has_stem) return std::optional<Sidecar>{};
  const std::string path = has_full ? full : stem;
  const auto bytes = read_file(path, kMaxBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto sidecar =
      parse_sidecar(path, std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()));
  if (!sidecar) return tl::unexpected(sidecar.error());
  return std::optional<Sidecar>(std::move(*sidecar));
}

}  // namespace glassbox
