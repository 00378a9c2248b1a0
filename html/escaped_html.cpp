#include <glassbox/html/escaped_html.h>

#include <optional>
#include <string_view>

#include <glassbox/base/utf8.h>

namespace glassbox {
namespace {

constexpr std::string_view kReplacement = "\xef\xbf\xbd";  // U+FFFD

bool fits_xml(char32_t c) {
  return c >= 0x20 ? c != 0xfffe && c != 0xffff : c == '\t' || c == '\n' || c == '\r';
}

}  // namespace

std::string escaped_html(const std::string& text) {
  std::string out;
  for (std::string_view rest = text; !rest.empty();) {
    const std::string_view from = rest;
    const std::optional<char32_t> character = take_character(rest);
    if (!character) rest.remove_prefix(1);
    if (!character || !fits_xml(*character)) {
      out += kReplacement;
    } else if (*character == '&') {
      out += "&amp;";
    } else if (*character == '<') {
      out += "&lt;";
    } else if (*character == '>') {
      out += "&gt;";
    } else if (*character == '"') {
      out += "&quot;";
    } else {
      out += from.substr(0, from.size() - rest.size());
    }
  }
  return out;
}

}  // namespace glassbox
