#include "study/extremes/common/matching_pair.h"

#include <algorithm>
#include <cstdlib>

namespace glassbox::study {

Image<Rgba8> grey_noise(int width, int height, std::uint64_t seed, int most) {
  Random random(seed);
  Image<Rgba8> image(width, height);
  for (Rgba8& pixel : image.pixels) {
    const auto grey = std::uint8_t(random.integer(0, most));
    pixel = {grey, grey, grey, 255};
  }
  return image;
}

Image<Rgba8> moved_left(const Image<Rgba8>& left, int d, std::uint64_t seed, int most) {
  Image<Rgba8> right = grey_noise(left.width, left.height, seed, most);
  for (int y = 0; y < left.height; ++y) {
    for (int x = std::max(0, d); x < std::min(left.width, left.width + d); ++x)
      right.at(x - d, y) = left.at(x, y);
  }
  return right;
}

views::DenseMatch matched(const Image<Rgba8>& left, const Image<Rgba8>& right,
                          const views::MatchSettings& settings) {
  views::MatchSettings single = settings;
  single.threads = 1;
  return views::match_pictures(left, right, single).value();
}

views::MatchSettings plain_settings(const char* name, views::DisparityRange range) {
  views::MatchSettings settings = *views::settings_named(name);
  settings.range = range;
  settings.fill = settings.median = settings.vote = false;
  return settings;
}

}  // namespace glassbox::study
