#include "views/matching/census.h"

#include <algorithm>

#include <tbb/parallel_for.h>

namespace glassbox::views {

namespace {

constexpr int kAcross = 3, kDown = 2;  // px from the window's centre to its edge

// One plane of a picture, with its edge columns repeated outwards.
class PaddedPlane {
public:
  PaddedPlane(const CacheAlignedVector<std::uint8_t>& plane, int width, int height)
      : height_(height),
        padded_(std::size_t(width) + 2 * kAcross + kByteLanes),
        bytes_(padded_ * std::size_t(height)) {
    for (int y = 0; y < height; ++y) {
      const std::uint8_t* from = plane.data() + std::size_t(y) * std::size_t(width);
      std::uint8_t* to = bytes_.data() + std::size_t(y) * padded_;
      std::fill_n(to, kAcross, from[0]);
      std::copy_n(from, width, to + kAcross);
      std::fill_n(to + kAcross + width, kAcross + kByteLanes, from[width - 1]);
    }
  }

  CensusRows around(int y) const {
    CensusRows rows;
    for (int dy = -kDown; dy <= kDown; ++dy) {
      const int row = std::clamp(y + dy, 0, height_ - 1);
      rows[std::size_t(dy + kDown)] = bytes_.data() + std::size_t(row) * padded_;
    }
    return rows;
  }

private:
  int height_;
  std::size_t padded_;
  CacheAlignedVector<std::uint8_t> bytes_;
};

// Makes planes by calling one(y, out) for each row; `out` points to the row in each of the planes.
template <class One>
CensusPlanes planes_of_rows(const ColorPlanes& picture, const One& one) {
  CensusPlanes planes;
  planes.pitch = (std::size_t(picture.width) + kByteLanes - 1) / kByteLanes * kByteLanes;
  for (auto& bytes : planes.bytes) bytes.resize(planes.pitch * std::size_t(picture.height));
  tbb::parallel_for(0, picture.height, [&](int y) {
    CensusPointers<std::uint8_t> out;
    for (std::size_t k = 0; k < kCensusBytes; ++k) {
      out[k] = planes.bytes[k].data() + std::size_t(y) * planes.pitch;
    }
    one(y, out);
  });
  return planes;
}

}  // namespace

CensusPointers<const std::uint8_t> CensusPlanes::row(int y) const {
  CensusPointers<const std::uint8_t> result;
  for (std::size_t k = 0; k < kCensusBytes; ++k)
    result[k] = bytes[k].data() + std::size_t(y) * pitch;
  return result;
}

CensusPlanes darker_neighbours(const ColorPlanes& picture, Target target) {
  const ByteKernels& kernels = byte_kernels(target);
  const PaddedPlane grey(picture.grey, picture.width, picture.height);
  return planes_of_rows(picture, [&](int y, const CensusPointers<std::uint8_t>& out) {
    kernels.darker(grey.around(y), picture.width, out);
  });
}

CensusPlanes similar_neighbours(const ColorPlanes& picture, Target target) {
  const ByteKernels& kernels = byte_kernels(target);
  const PaddedPlane r(picture.r, picture.width, picture.height),
      g(picture.g, picture.width, picture.height), b(picture.b, picture.width, picture.height);
  return planes_of_rows(picture, [&](int y, const CensusPointers<std::uint8_t>& out) {
    kernels.similar({r.around(y), g.around(y), b.around(y)}, kSimilarColor, kMinSimilar,
                    picture.width, out);
  });
}

}  // namespace glassbox::views
