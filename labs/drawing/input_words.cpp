#include "labs/drawing/input_words.h"

#include <utility>

#include <fmt/format.h>

namespace glassbox::labs {

namespace {

constexpr int kShown = 12;  // the most that is written of repeated numbers and parts

// The fewest digits that give the same number. Most inputs are floats.
std::string digits(double number) {
  const auto near = float(number);
  return double(near) == number ? fmt::format("{}", near) : fmt::format("{}", number);
}

// How many numbers a row of the text has: matrices are written row by row.
int row_length(int columns) {
  return columns == 16 || columns == 12 ? 4 : columns == 9 ? 3 : columns;
}

std::string tuple_text(RecordReader& in, int columns) {
  if (columns == 1) return digits(in.number());
  const bool is_list = columns == kCounted;
  if (is_list) columns = in.integer();
  const int row = row_length(columns);
  std::string text = "(";
  for (int i = 0; i < columns && in.more(); ++i) {
    const std::string number = digits(in.number());
    if (is_list && i >= kShown) continue;
    text += (i == 0 ? "" : i % row == 0 ? "; " : ", ") + number;
  }
  return text + (is_list && columns > kShown ? ", ...)" : ")");
}

std::string part_text(const InputPart& part, RecordReader& in) {
  if (part.meanings.empty()) return part.name + " " + tuple_text(in, part.columns);
  const double number = in.number();
  for (std::size_t i = 0; i < part.meanings.size(); ++i) {
    if (number == double(i)) return part.meanings[i];
  }
  return part.name + " " + digits(number);
}

std::string repeated_text(const InputPart& part, RecordReader& in) {
  const int count = part.count == kCounted ? in.integer() : part.count;
  std::string text;
  int made = 0;
  for (; in.more() && (count == kAllThatFollow || made < count); ++made) {
    const std::string tuple = tuple_text(in, part.columns);
    if (made < kShown)
      text += fmt::format("{}{} {} {}", made == 0 ? "" : ", ", part.name, made, tuple);
  }
  return made > kShown ? fmt::format("{} and {} more", text, made - kShown) : text;
}

}  // namespace

std::function<std::string(const Numbers& input)> in_words(std::vector<InputPart> parts) {
  return [parts = std::move(parts)](const Numbers& input) {
    RecordReader in(input.data(), input.size());
    std::string text;
    for (const InputPart& part : parts) {
      if (!in.more()) break;
      if (!text.empty()) text += ", ";
      text += part.count == 1 ? part_text(part, in) : repeated_text(part, in);
    }
    return text;
  };
}

}  // namespace glassbox::labs
