// A page of HTML that needs nothing else: one file, which fetches nothing and runs no script but its own.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace glassbox {

// What html/embed.cmake embeds of a page: kNamePage in "name_page.h".
struct PageParts {
  std::string_view body, style, style_hash;
  std::span<const std::string_view> script;  // one text in pieces
  std::string_view script_hash;              // none where the page has no script
};

// The page: its body begins with that of the parts, and `content` is markup that follows. `title` is text. Its
// Content-Security-Policy allows the style and the script of these hashes, and pictures that are in the page.
std::string assemble_page(const PageParts& parts, const std::string& title,
                          std::string_view content);

}  // namespace glassbox
