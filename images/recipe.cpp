#include <glassbox/images/recipe.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <glassbox/base/printable.h>
#include <glassbox/base/utf8.h>
#include <glassbox/images/png_text.h>

namespace glassbox {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kProgram = "glassbox ";
constexpr const char* kSoftwareKey = "Software";
constexpr const char* kSceneKey = "glassbox scene";
constexpr const char* kOptionsKey = "glassbox options";

constexpr std::size_t kMaxWords = 200;
constexpr std::size_t kMaxWordBytes = 4096;
constexpr std::size_t kMaxVersionBytes = 40;

bool is_letter_or_digit(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool is_version(std::string_view text) {
  return !text.empty() && text.size() <= kMaxVersionBytes &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return is_letter_or_digit(c) || c == '.' || c == '+' || c == '-';
         });
}

// Whether the text can be a program argument, which cannot contain a zero byte.
bool is_word(std::string_view text) {
  return text.size() <= kMaxWordBytes && text.find('\0') == std::string_view::npos && is_utf8(text);
}

bool is_sound(const Recipe& recipe) {
  return is_version(recipe.version) && !recipe.scene.empty() && is_word(recipe.scene) &&
         recipe.options.size() <= kMaxWords &&
         std::all_of(recipe.options.begin(), recipe.options.end(), is_word);
}

// Returns the text with this keyword, or nullptr unless there is exactly one.
const std::string* find(std::span<const TextEntry> text, std::string_view keyword) {
  const auto has_keyword = [&](const TextEntry& entry) { return entry.first == keyword; };
  const auto found = std::find_if(text.begin(), text.end(), has_keyword);
  if (found == text.end() || std::any_of(found + 1, text.end(), has_keyword)) return nullptr;
  return &found->second;
}

std::optional<std::vector<std::string>> words_of(const std::string& text) {
  if (text.size() > kMaxTextBytes) return std::nullopt;
  // The result is_discarded() if the text is not JSON.
  const Json list = Json::parse(text, nullptr, false);
  if (!list.is_array() || list.size() > kMaxWords) return std::nullopt;
  std::vector<std::string> words;
  for (const Json& word : list) {
    if (!word.is_string()) return std::nullopt;
    words.push_back(word.get_ref<const std::string&>());
  }
  return words;
}

bool needs_quotes(std::string_view word) {
  constexpr std::string_view kPlain = "_-./:,+@=";
  // zsh replaces a word with a leading = by the path of a program.
  return word.empty() || word.front() == '=' || std::any_of(word.begin(), word.end(), [&](char c) {
           return !is_letter_or_digit(c) && kPlain.find(c) == std::string_view::npos;
         });
}

}  // namespace

std::vector<TextEntry> to_text(const Recipe& recipe) {
  if (!is_sound(recipe)) return {};
  std::string options = Json(recipe.options).dump();
  if (options.size() > kMaxTextBytes) return {};
  return {{kSoftwareKey, std::string(kProgram) + recipe.version},
          {kSceneKey, recipe.scene},
          {kOptionsKey, std::move(options)}};
}

std::optional<Recipe> recipe_of(std::span<const TextEntry> text) {
  const std::string* software = find(text, kSoftwareKey);
  const std::string* scene = find(text, kSceneKey);
  const std::string* options = find(text, kOptionsKey);
  if (!software || !scene || !options || !software->starts_with(kProgram)) return std::nullopt;
  auto words = words_of(*options);
  if (!words) return std::nullopt;
  Recipe recipe{*scene, std::move(*words), software->substr(kProgram.size())};
  if (!is_sound(recipe)) return std::nullopt;
  return recipe;
}

std::optional<std::string> shell_quoted(std::string_view word) {
  std::string_view rest = word;
  while (const auto character = take_character(rest)) {
    if (!is_shown_as_itself(*character)) return std::nullopt;
  }
  if (!rest.empty()) return std::nullopt;  // the rest is not UTF-8
  if (!needs_quotes(word)) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

}  // namespace glassbox
