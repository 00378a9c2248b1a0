#include <glassbox/images/netpbm_header.h>

#include <charconv>
#include <string_view>

#include <glassbox/base/printable.h>
#include <glassbox/images/image_size.h>

namespace glassbox {
namespace {

using Bytes = std::span<const std::byte>;

bool is_space(int c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

tl::unexpected<Error> bad_header() {
  return fail("", "not a valid PBM, PGM, PPM, PAM or PFM header", "save the image again");
}

template <class Number>
std::optional<Number> number_in(const std::string& text) {
  Number value = 0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  if (parsed.ec != std::errc{} || parsed.ptr != end) return std::nullopt;
  return value;
}

bool is_legal_largest(std::optional<std::uint32_t> largest) {
  return largest && *largest >= 1 && *largest <= 65535;
}

// Reads what follows the magic number of PBM, PGM, PPM and PFM.
Result<NetpbmHeader> read_words(NetpbmWords& words, NetpbmHeader header) {
  const auto width = words.number(), height = words.number();
  if (!width || !height) return bad_header();
  header.width = *width;
  header.height = *height;
  const char kind = header.magic[1];
  header.channels = kind == '3' || kind == '6' || kind == 'F' ? 3 : 1;
  if (kind == 'f' || kind == 'F') {
    const auto scale = number_in<double>(words.word());
    if (!scale || !(*scale < 0 || *scale > 0)) return bad_header();
    header.scale = *scale;
  } else if (kind == '1' || kind == '4') {
    header.largest = 1;
  } else {
    const auto largest = words.number();
    if (!is_legal_largest(largest)) return bad_header();
    header.largest = *largest;
  }
  return header;
}

// Reads the lines of a PAM header up to ENDHDR, each a keyword and its value.
Result<NetpbmHeader> read_pam_lines(NetpbmWords& words, NetpbmHeader header) {
  std::string tuple;
  for (std::string key = words.word(); key != "ENDHDR"; key = words.word()) {
    if (key == "TUPLTYPE") {
      tuple = words.rest_of_line();
      continue;
    }
    const auto value = words.number();
    if (!value) return bad_header();
    if (key == "WIDTH") {
      header.width = *value;
    } else if (key == "HEIGHT") {
      header.height = *value;
    } else if (key == "DEPTH") {
      header.channels = *value;
    } else if (key == "MAXVAL") {
      header.largest = *value;
    } else {
      return bad_header();
    }
  }
  if (!is_legal_largest(header.largest)) return bad_header();
  // The names of one to four channels; without a name, the number of channels decides.
  static constexpr const char* kTuples[][2] = {{"GRAYSCALE", "BLACKANDWHITE"},
                                               {"GRAYSCALE_ALPHA", "BLACKANDWHITE_ALPHA"},
                                               {"RGB", "RGB"},
                                               {"RGB_ALPHA", "RGB_ALPHA"}};
  const bool known = header.channels >= 1 && header.channels <= 4;
  const auto* names = known ? kTuples[header.channels - 1] : nullptr;
  if (!known || (!tuple.empty() && tuple != names[0] && tuple != names[1])) {
    return fail("",
                "is a PAM of " + std::to_string(header.channels) + " channels" +
                    (tuple.empty() ? "" : " named " + in_quotes(tuple)) +
                    ", which is neither grey nor RGB, with or without alpha",
                "convert it to PNG");
  }
  return header;
}

// The most pixels that a byte of the samples can hold.
std::uint64_t pixels_per_byte(const std::string& magic) {
  return magic == "P4" ? 8 : 1;
}

}  // namespace

bool NetpbmWords::at_space() const {
  return is_space(character());
}

void NetpbmWords::skip_spaces() {
  while (at_space() || character() == '#') {
    if (character() == '#') {
      while (character() >= 0 && character() != '\n') ++at_;
    } else {
      ++at_;
    }
  }
}

std::string NetpbmWords::word() {
  constexpr std::size_t kLongestWord = 32;
  skip_spaces();
  std::string text;
  while (character() > ' ' && text.size() <= kLongestWord) {
    text += char(character());
    ++at_;
  }
  return text;
}

std::optional<std::uint32_t> NetpbmWords::number() {
  return number_in<std::uint32_t>(word());
}

int NetpbmWords::digit() {
  skip_spaces();
  const int found = character();
  if (found >= 0) ++at_;
  return found;
}

std::string NetpbmWords::rest_of_line() {
  std::string text;
  for (; character() >= 0 && character() != '\n'; ++at_) {
    if (!at_space()) text += char(character());
  }
  return text;
}

Result<NetpbmHeader> read_netpbm_header(Bytes bytes, const DecodeLimits& limits) {
  NetpbmWords words(bytes);
  NetpbmHeader start;
  start.magic = words.word();
  constexpr std::string_view kKinds = "1234567fF";
  if (start.magic.size() != 2 || start.magic[0] != 'P' ||
      kKinds.find(start.magic[1]) == std::string_view::npos) {
    return bad_header();
  }
  auto header = start.magic == "P7" ? read_pam_lines(words, start) : read_words(words, start);
  if (!header) return header;
  // Exactly one separator is before the samples, because the first sample's bytes may look like
  // white space themselves.
  if (!words.at_space()) return bad_header();
  header->size = words.at() + 1;
  // netpbm_samples checks the exact number of bytes.
  const auto fits = check_image_size(header->width, header->height, bytes.size(),
                                     pixels_per_byte(header->magic), limits);
  if (!fits) return tl::unexpected<Error>(fits.error());
  return header;
}

Result<Bytes> netpbm_samples(const NetpbmHeader& header, Bytes bytes, std::uint64_t needed) {
  const Bytes rest = bytes.subspan(header.size);
  if (rest.size() >= needed) return rest;
  return fail("",
              "the file is cut off: its pixels need " + std::to_string(needed) +
                  " bytes, but it has only " + std::to_string(rest.size()) + " for them",
              "save the image again");
}

}  // namespace glassbox
