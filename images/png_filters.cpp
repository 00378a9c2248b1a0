#include <glassbox/images/png_filters.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <vector>

namespace glassbox {
namespace {

using Byte = std::uint8_t;

enum class RowFilter : Byte { kNone, kSub, kUp, kAverage, kPaeth };

// The functions below undo one filter. `row` has `size` bytes, as has `above`, the row over it
// (zeros over the first row); both are whole pixels of kPixel bytes.

template <std::size_t kPixel>
void undo_sub(Byte* row, std::size_t size) {
  for (std::size_t i = kPixel; i < size; ++i) row[i] = Byte(row[i] + row[i - kPixel]);
}

void undo_up(Byte* row, const Byte* above, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) row[i] = Byte(row[i] + above[i]);
}

template <std::size_t kPixel>
void undo_average(Byte* row, const Byte* above, std::size_t size) {
  for (std::size_t i = 0; i < kPixel; ++i) row[i] = Byte(row[i] + above[i] / 2);
  for (std::size_t i = kPixel; i < size; ++i) {
    row[i] = Byte(row[i] + (row[i - kPixel] + above[i]) / 2);
  }
}

// Whichever of its three neighbours is nearest to left + above - above_left (9.4).
int paeth(int left, int above, int above_left) {
  const int to_left = std::abs(above - above_left);
  const int to_above = std::abs(left - above_left);
  const int to_above_left = std::abs(left + above - 2 * above_left);
  if (to_left <= to_above && to_left <= to_above_left) return left;
  return to_above <= to_above_left ? above : above_left;
}

template <std::size_t kPixel>
void undo_paeth(Byte* row, const Byte* above, std::size_t size) {
  std::array<int, kPixel> left{}, above_left{};
  for (std::size_t i = 0; i < size; i += kPixel) {
    for (std::size_t c = 0; c < kPixel; ++c) {
      const int up = above[i + c];
      row[i + c] = Byte(row[i + c] + paeth(left[c], up, above_left[c]));
      left[c] = row[i + c];
      above_left[c] = up;
    }
  }
}

template <std::size_t kPixel>
bool undo_filter(Byte filter, Byte* row, const Byte* above, std::size_t size) {
  switch (RowFilter(filter)) {
    case RowFilter::kNone:
      return true;
    case RowFilter::kSub:
      undo_sub<kPixel>(row, size);
      return true;
    case RowFilter::kUp:
      undo_up(row, above, size);
      return true;
    case RowFilter::kAverage:
      undo_average<kPixel>(row, above, size);
      return true;
    case RowFilter::kPaeth:
      undo_paeth<kPixel>(row, above, size);
      return true;
  }
  return false;
}

template <std::size_t kPixel>
bool undo_filters(Byte* bytes, std::size_t rows, std::size_t row_bytes) {
  const std::vector<Byte> zeros(row_bytes);
  const Byte* above = zeros.data();
  for (std::size_t y = 0; y < rows; ++y) {
    Byte* filtered = bytes + y * (row_bytes + 1);
    if (!undo_filter<kPixel>(*filtered, filtered + 1, above, row_bytes)) return false;
    Byte* row = bytes + y * row_bytes;
    std::memmove(row, filtered + 1, row_bytes);
    above = row;
  }
  return true;
}

}  // namespace

bool undo_png_filters(std::span<Byte> bytes, std::size_t rows, std::size_t row_bytes,
                      std::size_t pixel_bytes) {
  switch (pixel_bytes) {
    case 1:
      return undo_filters<1>(bytes.data(), rows, row_bytes);
    case 2:
      return undo_filters<2>(bytes.data(), rows, row_bytes);
    case 3:
      return undo_filters<3>(bytes.data(), rows, row_bytes);
    case 4:
      return undo_filters<4>(bytes.data(), rows, row_bytes);
    case 6:
      return undo_filters<6>(bytes.data(), rows, row_bytes);
    case 8:
      return undo_filters<8>(bytes.data(), rows, row_bytes);
    default:
      return false;
  }
}

}  // namespace glassbox
