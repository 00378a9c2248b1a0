#include <glassbox/mesh/obj/mtl.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>

#include <glassbox/base/ascii_case.h>

namespace glassbox::obj {
namespace {

// Options of map statements and the largest number of arguments of each. Options with more than one
// argument take words only as long as they are numbers.
struct MapOption {
  std::string_view name;
  int max_arguments;
};
constexpr MapOption kMapOptions[] = {
    {"-o", 3},      {"-s", 3},      {"-t", 3},       {"-mm", 2},         {"-clamp", 1},
    {"-blendu", 1}, {"-blendv", 1}, {"-cc", 1},      {"-bm", 1},         {"-boost", 1},
    {"-texres", 1}, {"-type", 1},   {"-imfchan", 1}, {"-colorspace", 1},
};

const MapOption* find_option(std::string_view word) {
  for (const MapOption& option : kMapOptions) {
    if (equal_ignoring_case(option.name, word)) return &option;
  }
  return nullptr;
}

void set_pair(std::array<float, 2>& pair, const std::vector<float>& numbers) {
  for (std::size_t i = 0; i < pair.size() && i < numbers.size(); ++i) pair[i] = numbers[i];
}

// Takes the arguments of an option from `words`. All numbers after the first are optional, so a
// word that is not a number begins the file name.
void read_option(const MapOption& option, Words& words, MapStatement& map) {
  if (option.max_arguments == 1) {
    const std::string_view argument = words.next();
    if (option.name == "-clamp") map.clamp = equal_ignoring_case(argument, "on");
    return;
  }
  std::vector<float> numbers;
  while (int(numbers.size()) < option.max_arguments) {
    Words ahead = words;
    const Number number = parse_number(ahead.next());
    // The last word is the file name, even if it is a number.
    if (number.kind != Number::Kind::kFinite || ahead.rest().empty()) break;
    numbers.push_back(number.value);
    words = ahead;
  }
  if (option.name == "-o") set_pair(map.offset, numbers);
  if (option.name == "-s") set_pair(map.scale, numbers);
}

// The keywords in these lists are in small letters: exporters write them in any case.

// Whether the statement names a map that changes the look of a surface but is not drawn here.
bool is_unsupported_map(std::string_view keyword) {
  constexpr std::string_view kKeywords[] = {"map_ka", "map_ks", "map_ns", "map_bump",
                                            "bump",   "disp",   "decal",  "refl",
                                            "norm",   "map_pr", "map_pm", "map_ps"};
  return std::ranges::find(kKeywords, keyword) != std::end(kKeywords);
}

// Whether the statement gives a number of a reflection model that is not drawn: ambient light,
// refraction, and the metalness and roughness of other programs.
bool is_unused_number(std::string_view keyword) {
  constexpr std::string_view kKeywords[] = {"ka", "km", "tf", "ni",  "sharpness", "map_aat", "pr",
                                            "pm", "ps", "pc", "pcr", "aniso",     "anisor"};
  return std::ranges::find(kKeywords, keyword) != std::end(kKeywords);
}

class MtlParser {
public:
  MtlParser(std::string_view text, std::string_view library, std::vector<MtlMaterial>& materials,
            Warnings& warnings)
      : lines_(text), library_(library), materials_(materials), warnings_(warnings) {}

  void run() {
    const std::size_t before = materials_.size();
    while (lines_.next()) {
      Words words(lines_.text());
      const std::string_view written = words.next();
      const std::string keyword = lower_case(written);
      if (keyword == "newmtl") {
        materials_.emplace_back().name = words.rest();
      } else if (materials_.size() > before) {
        statement(keyword, written, words, materials_.back());
      } else {
        stray_.add(lines_.number());
      }
    }
    const std::string name = in_quotes(library_);
    unreadable_.report("statement of " + name + " could not be read",
                       "statements of " + name + " could not be read", warnings_);
    stray_.report("statement of " + name + " stands before the first newmtl and was ignored",
                  "statements of " + name + " stand before the first newmtl and were ignored",
                  warnings_);
    unknown_.report(
        "unknown statement of " + name + " was ignored: " + first_unknown_,
        "unknown statements of " + name + " were ignored, " + first_unknown_ + " among them",
        warnings_);
    for (const auto& [keyword, map] : left_out_) {
      warnings_.add(name + " names textures that are not drawn: " + map.written + " (" +
                    std::to_string(map.count) + ")");
    }
  }

private:
  // `keyword` is the word `written` in small letters.
  void statement(const std::string& keyword, std::string_view written, Words words,
                 MtlMaterial& material) {
    if (keyword == "kd") return read_color(words, material.diffuse);
    if (keyword == "ks") return read_color(words, material.specular);
    if (keyword == "ke") return read_color(words, material.emission);
    if (keyword == "ns") return read_number(words, material.exponent);
    if (keyword == "tr") return read_number(words, material.transparency);
    if (keyword == "d") return read_number(words, material.opacity);
    if (keyword == "illum") return read_illumination(words, material);
    if (keyword == "map_kd") return read_map(words, material.diffuse_map);
    if (keyword == "map_d") return read_map(words, material.opacity_map);
    if (keyword == "map_ke") return read_map(words, material.emission_map);
    if (is_unsupported_map(keyword)) {
      LeftOut& map = left_out_[keyword];
      if (map.count++ == 0) map.written = written;
    } else if (!is_unused_number(keyword)) {
      if (first_unknown_.empty()) first_unknown_ = in_quotes(written);
      unknown_.add(lines_.number());
    }
  }

  void read_illumination(Words words, MtlMaterial& material) {
    material.illumination = parse_integer(words.next());
    if (!material.illumination) unreadable_.add(lines_.number());
  }

  // r [g b]: g and b equal r if they are left out. The forms "spectral" and "xyz" are not read.
  void read_color(Words words, std::optional<std::array<float, 3>>& color) {
    const Number r = parse_number(words.next());
    const std::string_view second = words.next();
    const std::string_view third = words.next();
    const Number g = second.empty() ? r : parse_number(second);
    const Number b = third.empty() ? r : parse_number(third);
    for (const Number& channel : {r, g, b}) {
      if (channel.kind != Number::Kind::kFinite) return unreadable_.add(lines_.number());
    }
    color = {r.value, g.value, b.value};
  }

  // "d -halo factor" is read as "d factor": the halo depends on the view.
  void read_number(Words words, std::optional<float>& value) {
    std::string_view word = words.next();
    if (equal_ignoring_case(word, "-halo")) word = words.next();
    const Number number = parse_number(word);
    if (number.kind != Number::Kind::kFinite) return unreadable_.add(lines_.number());
    value = number.value;
  }

  void read_map(Words words, std::optional<MapStatement>& map) {
    MapStatement statement = parse_map(words.rest());
    if (statement.file.empty()) return unreadable_.add(lines_.number());
    map = std::move(statement);
  }

  Lines lines_;
  std::string_view library_;
  std::vector<MtlMaterial>& materials_;
  Warnings& warnings_;
  OccurrenceCount unreadable_, stray_, unknown_;
  std::string first_unknown_;
  struct LeftOut {
    std::string written;  // at the first occurrence
    int count = 0;
  };
  std::map<std::string, LeftOut> left_out_;  // by keyword
};

}  // namespace

MapStatement parse_map(std::string_view arguments) {
  MapStatement map;
  Words words(arguments);
  // The file name goes from its first word to the end of its last one, with the blanks between the
  // words as written.
  const char* file_begin = nullptr;
  const char* file_end = nullptr;
  while (!words.rest().empty()) {
    Words ahead = words;
    // The word is taken from the rest of the line and not with Words::next(), which stops at a '#':
    // a file name may contain one.
    const std::string_view rest = words.rest();
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t\v\f"));
    const MapOption* const option = find_option(word);
    if (option != nullptr) {
      ahead.next();
      read_option(*option, ahead, map);
      words = ahead;
      continue;
    }
    if (file_begin == nullptr) file_begin = word.data();
    file_end = word.data() + word.size();
    words = Words(rest.substr(word.size()));
  }
  if (file_begin != nullptr) map.file.assign(file_begin, file_end);
  return map;
}

void parse_mtl(std::string_view text, std::string_view library, std::vector<MtlMaterial>& materials,
               Warnings& warnings) {
  MtlParser(text, library, materials, warnings).run();
}

}  // namespace glassbox::obj
