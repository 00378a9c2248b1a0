#include <glassbox/compare/metrics/metric.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <glassbox/base/trimmed.h>

namespace glassbox {
namespace {

enum class Better : std::uint8_t { kSmaller, kLarger };

struct KnownMetric {
  std::string_view name;
  Better better;
};
constexpr std::array kKnown{
    KnownMetric{"absmax", Better::kSmaller},      KnownMetric{"rmse", Better::kSmaller},
    KnownMetric{"psnr", Better::kLarger},         KnownMetric{"ssim.mean", Better::kLarger},
    KnownMetric{"ssim.min", Better::kLarger},     KnownMetric{"flip.mean", Better::kSmaller},
    KnownMetric{"flip.median", Better::kSmaller}, KnownMetric{"flip.p95", Better::kSmaller},
    KnownMetric{"flip.max", Better::kSmaller},
};

std::string known_names() {
  std::string names;
  for (const KnownMetric& known : kKnown) {
    if (!names.empty()) names += ", ";
    names += known.name;
  }
  return names + ", ssim or flip";
}

// Returns "ssim" for "ssim.mean"; nothing for "rmse".
std::string_view family(std::string_view name) {
  const std::size_t dot = name.find('.');
  return dot == std::string_view::npos ? std::string_view() : name.substr(0, dot);
}

bool wants_larger(LimitKind kind) {
  return kind == LimitKind::kAbove || kind == LimitKind::kAtLeast;
}

constexpr std::string_view kSigns[] = {"<", "<=", ">", ">="};  // in the order of LimitKind
static_assert(std::size(kSigns) == std::size_t(LimitKind::kAtLeast) + 1);

std::string_view sign(LimitKind kind) {
  return kSigns[int(kind)];
}

LimitKind kind_of(std::string_view sign) {
  return LimitKind(std::ranges::find(kSigns, sign) - std::begin(kSigns));
}

Result<double> parse_number(std::string_view text, std::string_view word) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return fail("--metric", fmt::format("'{}' has no number as its limit", word),
                "write the limit as in psnr>40 or flip.mean<0.05");
  }
  return value;
}

// One word of the list of metrics: a name, with or without a limit.
struct Word {
  std::string_view name;
  std::optional<Limit> limit;
};

Result<Word> parse_word(std::string_view word) {
  const std::size_t sign_at = word.find_first_of("<>");
  if (sign_at == std::string_view::npos) return Word{word, {}};
  const std::size_t sign_size = word.substr(sign_at + 1).starts_with('=') ? 2 : 1;
  const auto value = parse_number(trimmed(word.substr(sign_at + sign_size)), word);
  if (!value) return tl::unexpected(value.error());
  return Word{trimmed(word.substr(0, sign_at)),
              Limit{kind_of(word.substr(sign_at, sign_size)), *value}};
}

Result<void> check_direction(const KnownMetric& known, const Word& word, std::string_view text) {
  const bool larger = known.better == Better::kLarger;
  if (!word.limit || wants_larger(word.limit->kind) == larger) return {};
  return fail("--metric",
              fmt::format("the limit '{}' would accept bad pictures and refuse good ones", text),
              fmt::format("{} is better for {}: write {}{}{}", larger ? "larger" : "smaller",
                          word.name, word.name, larger ? '>' : '<', word.limit->value));
}

// Appends the request of one word: one number, or all numbers of a family with the limit on the
// mean.
Result<void> append(std::string_view text, std::vector<MetricRequest>& requests) {
  const auto word = parse_word(text);
  if (!word) return tl::unexpected(word.error());
  bool found = false;
  for (const KnownMetric& known : kKnown) {
    const bool by_family = !word->name.empty() && family(known.name) == word->name;
    if (known.name != word->name && !by_family) continue;
    found = true;
    const auto direction = check_direction(known, *word, text);
    if (!direction) return tl::unexpected(direction.error());
    const bool takes_limit = !by_family || known.name.ends_with(".mean");
    requests.push_back({std::string(known.name), takes_limit ? word->limit : std::nullopt});
  }
  if (found) return {};
  return fail("--metric",
              text.empty() ? std::string("the name of a metric is missing")
                           : fmt::format("there is no metric '{}'", word->name),
              "use one of " + known_names());
}

}  // namespace

Result<std::vector<MetricRequest>> parse_metrics(const std::string& text) {
  std::vector<MetricRequest> requests;
  for (std::string_view rest = text;;) {
    const std::size_t comma = rest.find(',');
    const auto appended = append(trimmed(rest.substr(0, comma)), requests);
    if (!appended) return tl::unexpected(appended.error());
    if (comma == std::string_view::npos) return requests;
    rest.remove_prefix(comma + 1);
  }
}

std::string to_string(const MetricRequest& request) {
  if (!request.limit) return request.name;
  return fmt::format("{}{}{}", request.name, sign(request.limit->kind), request.limit->value);
}

}  // namespace glassbox
