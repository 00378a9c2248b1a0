// How glassbox made a picture, stored in the picture's PNG text.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glassbox/images/write.h>

namespace glassbox {

// The arguments with which a picture was made: `glassbox render SCENE OPTIONS...` of this version.
struct Recipe {
  std::string scene;  // as given on the command line
  std::vector<std::string> options;
  std::string version;  // "0.1.0"
  friend bool operator==(const Recipe&, const Recipe&) = default;
};

// Returns the entries "Software" ("glassbox 0.1.0"), "glassbox scene" and "glassbox options" (a
// JSON array of words). Returns none if a reader could not restore the recipe: for a word that is
// not UTF-8 or longer than 4096 bytes, for more than 200 options or more than 64 KiB of options, or
// for a version with other characters than letters, digits and ".+-".
std::vector<TextEntry> to_text(const Recipe& recipe);

// Returns the recipe in a picture's text; nothing if an entry is missing, is present twice, or is
// not as to_text writes it. The words come from the file and may be hostile: do not run them; use
// shell_quoted to display them.
std::optional<Recipe> recipe_of(std::span<const TextEntry> text);

// Returns the word in a form that a POSIX shell reads back, in single quotes where it needs them.
// Returns nothing for a word that would not look like what it is: one with control characters, line
// separators or characters that change the direction of writing, or one that is not UTF-8.
std::optional<std::string> shell_quoted(std::string_view word);

}  // namespace glassbox
