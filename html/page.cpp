#include <glassbox/html/page.h>

#include <fmt/format.h>

#include <glassbox/html/escaped_html.h>

namespace glassbox {
namespace {

// The Content-Security-Policy: it allows only what the page needs.
std::string policy_of(const PageParts& parts) {
  std::string policy = "default-src 'none'; img-src data:; ";
  if (!parts.script_hash.empty()) {
    // 'self' means nothing to some browsers where a page was opened without a server.
    const char* beside = parts.loads_scripts ? " 'self' file:" : "";
    policy += fmt::format("script-src 'sha256-{}'{}; ", parts.script_hash, beside);
  }
  return policy + fmt::format("style-src 'sha256-{}'", parts.style_hash);
}

}  // namespace

std::string assemble_page(const PageParts& parts, const std::string& title,
                          std::string_view content) {
  std::string page = fmt::format(
      R"(<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<title>{}</title>
<style>{}</style>
</head>
<body>
)",
      policy_of(parts), escaped_html(title), parts.style);
  page.append(parts.body).append(content);
  if (!parts.script_hash.empty()) {
    page += "<script type=\"module\">";
    for (const std::string_view piece : parts.script) page += piece;
    page += "</script>\n";
  }
  return page + "</body>\n</html>\n";
}

}  // namespace glassbox
