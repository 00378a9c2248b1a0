// A strict reader for the part of XML that JUnit reports use.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glassbox/base/utf8.h>

namespace glassbox::test {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::vector<Element> children;
  std::string text;  // the element's own text, with references replaced
};

// Reads one document: elements, attributes in double quotes, text and the references &amp; &lt;
// &gt; &quot; and &#N;. Throws if the document violates XML 1.0 (fifth edition).
class XmlReader {
public:
  explicit XmlReader(std::string_view text) : rest_(text) {
    for (std::string_view all = text; !all.empty();) {
      const auto c = take_character(all);
      check(c.has_value(), "not UTF-8");
      check(is_legal(*c), "a character that XML 1.0 does not have");
    }
    expect("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
    skip_blanks();
  }

  Element document() {
    Element root = element();
    skip_blanks();
    check(rest_.empty(), "something after the document");
    return root;
  }

private:
  // Production Char of section 2.2.
  static bool is_legal(char32_t c) {
    return c == 9 || c == 10 || c == 13 || (c >= 0x20 && c <= 0xd7ff) ||
           (c >= 0xe000 && c <= 0xfffd) || (c >= 0x10000 && c <= 0x10ffff);
  }
  static void check(bool good, const char* what) {
    if (!good) throw std::runtime_error(what);
  }
  bool take(std::string_view word) {
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }
  void expect(std::string_view word) {
    if (!take(word)) throw std::runtime_error("no " + std::string(word));
  }
  bool skip_blanks() {
    const std::size_t before = rest_.size();
    while (!rest_.empty() && std::string_view(" \t\r\n").find(rest_[0]) != std::string_view::npos) {
      rest_.remove_prefix(1);
    }
    return rest_.size() < before;
  }
  std::string name() {
    std::size_t end = 0;
    while (end < rest_.size() && ((rest_[end] >= 'a' && rest_[end] <= 'z'))) ++end;
    check(end > 0, "no name");
    const std::string word(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return word;
  }
  // One character, or the character that a reference denotes.
  char character() {
    check(!rest_.empty(), "the end in the middle");
    if (rest_[0] != '&') {
      const char c = rest_[0];
      rest_.remove_prefix(1);
      return c;
    }
    for (const auto& [word, c] : std::map<std::string_view, char>{{"&amp;", '&'},
                                                                  {"&lt;", '<'},
                                                                  {"&gt;", '>'},
                                                                  {"&quot;", '"'},
                                                                  {"&#9;", '\t'},
                                                                  {"&#10;", '\n'},
                                                                  {"&#13;", '\r'}}) {
      if (take(word)) return c;
    }
    throw std::runtime_error("an unknown reference");
  }
  void attribute(Element& element) {
    const std::string key = name();
    expect("=\"");
    std::string value;
    while (!take("\"")) {
      check(!rest_.starts_with("<"), "< in an attribute");
      check(!rest_.starts_with("\n") && !rest_.starts_with("\t") && !rest_.starts_with("\r"),
            "white space that a reader would replace");
      value += character();
    }
    check(element.attributes.emplace(key, value).second, "an attribute twice");
  }
  Element element() {
    Element result;
    expect("<");
    result.name = name();
    while (skip_blanks() && !rest_.starts_with("/>") && !rest_.starts_with(">")) attribute(result);
    if (take("/>")) return result;
    expect(">");
    while (!take("</")) {
      if (rest_.starts_with("<")) {
        result.children.push_back(element());
      } else {
        check(!rest_.starts_with("]]>"), "]]> in text");
        result.text += character();
      }
    }
    expect(result.name);
    expect(">");
    return result;
  }

  std::string_view rest_;
};

}  // namespace glassbox::test
