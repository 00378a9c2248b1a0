#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "views/files/colmap_model.h"

#include <glassbox/base/counted.h>

namespace glassbox::views {

namespace {

using Bytes = std::span<const std::byte>;

constexpr const char* kCopy = "copy the file again, or export the model again";

// Takes numbers from the front of a file. They are little-endian.
class Source {
public:
  Source(const char* file, Bytes rest) : file_(file), rest_(rest) {}

  template <std::unsigned_integral Number>
  std::optional<Number> take() {
    if (rest_.size() < sizeof(Number)) return std::nullopt;
    Number value = 0;
    for (std::size_t i = sizeof(Number); i-- > 0;) {
      value = Number(std::uint64_t(value) << 8 | std::uint64_t(rest_[i]));
    }
    rest_ = rest_.subspan(sizeof(Number));
    return value;
  }
  // The numbers of cameras have 32 bits and a sign.
  std::optional<std::int64_t> take_id() {
    const auto bits = take<std::uint32_t>();
    return bits ? std::optional<std::int64_t>(std::bit_cast<std::int32_t>(*bits)) : std::nullopt;
  }
  std::optional<std::vector<double>> take_doubles(std::size_t count) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) {
      const auto bits = take<std::uint64_t>();
      if (!bits) return std::nullopt;
      numbers.push_back(std::bit_cast<double>(*bits));
    }
    return numbers;
  }
  // A name, which ends with a zero byte.
  std::optional<std::string> take_name() {
    const auto* begin = reinterpret_cast<const char*>(rest_.data());
    const std::size_t length = std::string_view(begin, rest_.size()).find('\0');
    if (length == std::string_view::npos) return std::nullopt;
    rest_ = rest_.subspan(length + 1);
    return std::string(begin, length);
  }
  bool skip(std::uint64_t count, std::uint64_t bytes_each) {
    if (count > rest_.size() / bytes_each) return false;
    rest_ = rest_.subspan(std::size_t(count * bytes_each));
    return true;
  }

  std::string place(const char* what, std::uint64_t number) const {
    return fmt::format("{}, {} {}", file_, what, number);
  }
  tl::unexpected<Error> cut_off(const std::string& where) const {
    return fail(where, "the file is cut off", kCopy);
  }
  Result<void> at_end() const {
    if (rest_.empty()) return {};
    return fail(file_,
                counted(rest_.size(), "byte") + " stand behind what the file announces to have",
                kCopy);
  }

private:
  const char* file_;
  Bytes rest_;
};

bool are_finite(const std::vector<double>& numbers) {
  for (const double number : numbers) {
    if (!std::isfinite(number)) return false;
  }
  return true;
}

tl::unexpected<Error> not_finite(const std::string& place) {
  return fail(place, "a number is not finite", "export the model again");
}

struct Entry {
  std::int64_t id = 0;
  Result<ColmapLens> lens;
};

Result<Entry> take_lens(Source& source, std::uint64_t number) {
  const std::string place = source.place("camera", number);
  const auto id = source.take_id(), kind_id = source.take_id();
  const auto width = source.take<std::uint64_t>(), height = source.take<std::uint64_t>();
  if (!id || !kind_id || !width || !height) return source.cut_off(place);
  if (*kind_id < 0 || std::size_t(*kind_id) >= std::size(kColmapLensKinds)) {
    return fail(place,
                fmt::format("its model is number {}, whose parameters are not known", *kind_id),
                "export the model as text (colmap model_converter --output_type TXT)");
  }
  const ColmapLensKind& kind = kColmapLensKinds[*kind_id];
  auto parameters = source.take_doubles(kind.parameters);
  if (!parameters) return source.cut_off(place);
  const auto size = colmap_size(place, double(*width), double(*height));
  if (!size) return Entry{*id, tl::unexpected(size.error())};
  if (!are_finite(*parameters)) return Entry{*id, not_finite(place)};
  return Entry{*id, ColmapLens{place, kind, *size, std::move(*parameters)}};
}

Result<ColmapLenses> take_lenses(Source source) {
  const auto count = source.take<std::uint64_t>();
  if (!count) return source.cut_off(source.place("camera", 1));
  ColmapLenses lenses;
  for (std::uint64_t i = 1; i <= *count; ++i) {
    auto entry = take_lens(source, i);
    if (!entry) return tl::unexpected(entry.error());
    if (!lenses.emplace(entry->id, std::move(entry->lens)).second) {
      return fail(source.place("camera", i), "another camera has the same number",
                  "give each camera its own number");
    }
  }
  if (const auto whole = source.at_end(); !whole) return tl::unexpected(whole.error());
  return lenses;
}

// Takes a picture and leaves out its points, each two coordinates and the number of a point in
// space.
Result<ColmapPicture> take_picture(Source& source, std::uint64_t number) {
  constexpr std::uint64_t kBytesOfPoint = 24;
  const std::string place = source.place("picture", number);
  const auto id = source.take_id();
  const auto pose = source.take_doubles(7);
  const auto lens = source.take_id();
  auto name = source.take_name();
  const auto points = source.take<std::uint64_t>();
  if (!id || !pose || !lens || !name || !points || !source.skip(*points, kBytesOfPoint)) {
    return source.cut_off(place);
  }
  if (!are_finite(*pose)) return not_finite(place);
  const std::vector<double>& n = *pose;
  return ColmapPicture{
      place, {n[0], n[1], n[2], n[3]}, {n[4], n[5], n[6]}, *lens, std::move(*name)};
}

Result<std::vector<ColmapPicture>> take_pictures(Source source) {
  const auto count = source.take<std::uint64_t>();
  if (!count) return source.cut_off(source.place("picture", 1));
  std::vector<ColmapPicture> pictures;
  for (std::uint64_t i = 1; i <= *count; ++i) {
    auto picture = take_picture(source, i);
    if (!picture) return tl::unexpected(picture.error());
    pictures.push_back(std::move(*picture));
  }
  if (const auto whole = source.at_end(); !whole) return tl::unexpected(whole.error());
  return pictures;
}

}  // namespace

Result<ColmapModel> parse_colmap_binary(Bytes cameras, Bytes images) {
  const auto lenses = take_lenses(Source("cameras.bin", cameras));
  if (!lenses) return tl::unexpected(lenses.error());
  const auto pictures = take_pictures(Source("images.bin", images));
  if (!pictures) return tl::unexpected(pictures.error());
  return colmap_model(*lenses, *pictures);
}

}  // namespace glassbox::views
