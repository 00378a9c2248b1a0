// How glassbox made a picture, kept in the picture's PNG text.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/images/write.h>

namespace glassbox {

// `glassbox render SCENE OPTIONS...` of this version made the picture.
struct Recipe {
  std::string scene;  // as given on the command line
  std::vector<std::string> options;
  std::string version;  // "0.1.0"
  friend bool operator==(const Recipe&, const Recipe&) = default;
};

// The entries "Software" ("glassbox 0.1.0"), "glassbox scene" and "glassbox options" (a JSON array of words). None where
// a reader would not get the recipe back: a word that is not UTF-8 or longer than 4096 bytes, more than 200 options or
// 64 KiB of them, a version of other characters than letters, digits and ".+-".
std::vector<TextEntry> to_text(const Recipe& recipe);

// None where an entry is missing, there twice, or not as to_text writes it. The words are the file's, which may be
// hostile: they are nothing to run, and shell_quoted makes them fit to be shown.
std::optional<Recipe> recipe_of(std::span<const TextEntry> text);

// The word as a POSIX shell reads it back, in single quotes where it needs them. None for a word that would not look
// like what it is: with control characters, separators of lines or marks that turn the direction of writing, or not
// UTF-8.
std::optional<std::string> shell_quoted(std::string_view word);

}  // namespace glassbox
