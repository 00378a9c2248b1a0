// Assembles an HTML page that runs no script but its own, and that fetches nothing, except for
// files beside it if it is made so.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace glassbox {

// The parts of a page that html/embed.cmake embeds as kNamePage in "name_page.h".
struct PageParts {
  std::string_view body, style, style_hash;
  std::span<const std::string_view> script;  // one text, in parts
  std::string_view script_hash;              // empty if the page has no script
  bool loads_scripts = false;                // whether the script loads files beside the page
};

// Assembles the page. Its body begins with the body of the parts; `content` is the markup that
// follows. `title` is plain text. The page's Content-Security-Policy allows only the style and the
// script with the hashes in `parts`, pictures that are inside the page, and, if the script loads
// files beside the page, scripts from where the page comes from.
std::string assemble_page(const PageParts& parts, const std::string& title,
                          std::string_view content);

}  // namespace glassbox
