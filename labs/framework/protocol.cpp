#include "labs/framework/protocol.h"

#include <bit>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "labs/framework/batch.h"

namespace glassbox::labs {

namespace {

using Json = nlohmann::json;

std::optional<double> number_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  if (!json.is_string()) return std::nullopt;
  const auto& text = json.get_ref<const std::string&>();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text == "inf") return kInfinity;
  if (text == "-inf") return -kInfinity;
  return std::nullopt;
}

// The value of a hexadecimal digit as runners write it; -1 for any other character.
int digit_of(char c) {
  return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

// The doubles of a batch (batch.h), whose bits are 16 hexadecimal digits each.
std::optional<std::vector<double>> packed_numbers(const std::string& digits) {
  if (digits.size() % 16 != 0) return std::nullopt;
  std::vector<double> values;
  values.reserve(digits.size() / 16);
  for (std::size_t at = 0; at < digits.size(); at += 16) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < 16; ++i) {
      const int digit = digit_of(digits[at + i]);
      if (digit < 0) return std::nullopt;
      bits = bits << 4 | std::uint64_t(digit);
    }
    values.push_back(std::bit_cast<double>(bits));
  }
  return values;
}

// Reads `fields` into `answer`, and appends `suffix` to their names. Returns what is wrong with
// them; empty if nothing is.
std::string read_fields(const Json& fields, const char* suffix, Answer& answer) {
  if (!fields.is_object()) return "\"fields\" or \"sizes\" is not an object";
  if (fields.size() > kMaxFields)
    return fmt::format("an answer has more than {} fields", kMaxFields);
  for (const auto& [name, list] : fields.items()) {
    if (list.is_string()) {
      auto packed = packed_numbers(list.get_ref<const std::string&>());
      if (!packed) return "a field is neither a list of numbers nor hexadecimal digits";
      answer.emit(name + suffix, std::move(*packed));
      continue;
    }
    if (!list.is_array()) return "a field is not a list of numbers";
    std::vector<double> values;
    values.reserve(list.size());
    for (const Json& each : list) {
      const auto value = number_of(each);
      if (!value) return "a field has a value that is not a number";
      values.push_back(*value);
    }
    answer.emit(name + suffix, std::move(values));
  }
  return {};
}

void read_line(std::string_view line, std::size_t number, CheckAnswers& answers) {
  const auto malformed = [&](const std::string& why) {
    if (answers.malformed.empty())
      answers.malformed = fmt::format("line {} of the answers {}", number, why);
  };
  // The JSON parser is not recursive, but copying and destroying its result is. Brackets that are
  // nested deeply would overflow the stack, so they are refused.
  const auto too_deep = [](int depth, Json::parse_event_t, Json&) {
    if (depth > 8) throw std::length_error("nested");
    return true;
  };
  Json json;
  try {
    json = Json::parse(line, too_deep);
  } catch (const std::exception&) {
    return malformed("is not valid JSON");
  }
  if (!json.is_object()) return malformed("is not a JSON object");
  const auto index = json.find("case");
  if (index == json.end() || !index->is_number_unsigned()) return malformed("has no case number");
  const auto at = index->get<std::uint64_t>();
  if (at >= answers.cases.size())
    return malformed(
        fmt::format("answers case {}, but there are only {} cases", at, answers.cases.size()));
  CaseAnswer& answer = answers.cases[std::size_t(at)];
  const auto refuse = [&](const std::string& why) {
    answer.state = CaseAnswer::State::kMalformed;
    answer.text = why;
  };
  if (answer.state != CaseAnswer::State::kMissing) return refuse("this case is answered twice");
  const auto threw = json.find("threw");
  const auto fields = json.find("fields");
  if ((threw != json.end()) == (fields != json.end()))
    return refuse("the line with the answer must have either \"fields\" or \"threw\"");
  if (threw != json.end()) {
    if (!threw->is_string()) return refuse("\"threw\" is not a string");
    answer.state = CaseAnswer::State::kThrew;
    answer.text = threw->get<std::string>();
    return;
  }
  std::string why = read_fields(*fields, "", answer.answer);
  const auto sizes = json.find("sizes");
  if (why.empty() && sizes != json.end()) why = read_fields(*sizes, kSizes, answer.answer);
  if (!why.empty()) {
    answer.answer = {};
    return refuse(why);
  }
  answer.state = CaseAnswer::State::kAnswered;
}

}  // namespace

void read_answers(std::string_view lines, CheckAnswers& answers) {
  std::size_t number = 0;
  while (true) {
    const std::size_t end = lines.find('\n');
    if (end == std::string_view::npos) return;
    ++number;
    read_line(lines.substr(0, end), number, answers);
    lines.remove_prefix(end + 1);
  }
}

}  // namespace glassbox::labs
