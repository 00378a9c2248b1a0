// The beginning of every page, and the escaping of text in it.
#include <string>

#include <glassbox/html/escaped_html.h>
#include <glassbox/html/page.h>

#include "tests/support/catch.h"

namespace glassbox {
namespace {

TEST_CASE("text in a page ends neither an element nor an attribute, and is UTF-8") {
  CHECK(escaped_html("a <b> & \"c\"") == "a &lt;b&gt; &amp; &quot;c&quot;");
  CHECK(escaped_html("line\n\ttab, \xc3\xa4") == "line\n\ttab, \xc3\xa4");
  CHECK(escaped_html("\x1b[1m") == "\xef\xbf\xbd[1m");
  CHECK(escaped_html("\xc3<") == "\xef\xbf\xbd&lt;");
}

TEST_CASE("a page's policy names the hashes of its style and its script, and nothing more") {
  constexpr std::string_view kScript[] = {"let a", " = 1;"};
  const PageParts parts{"<p>body</p>\n", "p {}", "STYLE=", kScript, "SCRIPT="};
  const std::string page = assemble_page(parts, "<title>", "<p>content</p>\n");
  CHECK(page.starts_with("<!doctype html>\n"));
  CHECK(page.find("content=\"default-src 'none'; img-src data:; script-src 'sha256-SCRIPT='; "
                  "style-src 'sha256-STYLE='\"") != std::string::npos);
  CHECK(page.find("<title>&lt;title&gt;</title>") != std::string::npos);
  CHECK(page.find("<body>\n<p>body</p>\n<p>content</p>\n<script type=\"module\">let a = "
                  "1;</script>\n</body>\n</html>\n") != std::string::npos);
}

TEST_CASE("a page that loads files allows scripts from where it comes from, and no others") {
  constexpr std::string_view kScript[] = {"load();"};
  const PageParts parts{"", "", "STYLE=", kScript, "SCRIPT=", true};
  CHECK(assemble_page(parts, "t", "").find("script-src 'sha256-SCRIPT=' 'self' file:; ") !=
        std::string::npos);
}

TEST_CASE("a page without a script allows none") {
  const std::string page = assemble_page({}, "t", "");
  CHECK(page.find("script") == std::string::npos);
}

}  // namespace
}  // namespace glassbox
