#include "tests/compare/moved_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include <glassbox/base/random.h>
#include <glassbox/images/srgb.h>

namespace glassbox::test {
namespace {

struct Point {
  double x = 0, y = 0;
};

using Ink = std::array<double, 3>;  // codes of sRGB, 0 to 255
using Line = std::vector<Point>;
using Glyph = std::vector<Line>;

// The points nearer to a segment than half of its width.
struct Stroke {
  Point from, to;
  double half_width = 0;  // px
};

// What is drawn in one colour, as the union of its strokes.
struct Figure {
  std::vector<Stroke> strokes;
  Ink ink{};
};

struct Look {
  const char* name;
  Ink paper, ink;
  double x_height;    // px; 0: shapes
  double half_width;  // px
  bool linear;        // blended in linear light
  bool gradient;      // of the paper
};

constexpr Look kLooks[] = {
    {"small-dark-text", {255, 255, 255}, {0, 0, 0}, 7, 0.6, false, false},
    {"grey-text", {255, 255, 255}, {68, 68, 68}, 8.5, 0.75, false, false},
    {"large-light-text", {20, 40, 120}, {255, 255, 255}, 13, 1.2, true, false},
    {"pale-text", {240, 230, 200}, {120, 160, 90}, 7, 0.6, true, false},
    {"text-on-gradient", {255, 255, 255}, {40, 0, 60}, 8.5, 0.75, false, true},
    {"shapes", {235, 235, 235}, {0, 0, 0}, 0, 0, true, false},
};

const Look& look_named(const std::string& name) {
  return *std::find_if(std::begin(kLooks), std::end(kLooks),
                       [&](const Look& look) { return look.name == name; });
}

Line arc(Point centre, double radius, double from_degrees, double to_degrees) {
  constexpr int kParts = 16;
  Line line;
  for (int i = 0; i <= kParts; ++i) {
    const double turn = from_degrees + (to_degrees - from_degrees) * i / kParts;
    const double angle = turn * std::numbers::pi / 180;
    line.push_back({centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)});
  }
  return line;
}

// Glyphs that look like o e c n t x l i v b z . A; y is down from 0 at the x-height to 1 at the
// base line.
const std::vector<Glyph>& glyphs() {
  static const std::vector<Glyph> all{
      {arc({.45, .5}, .45, 0, 360)},
      {arc({.45, .5}, .45, 0, 315), {{0, .5}, {.9, .5}}},
      {arc({.45, .5}, .45, 45, 315)},
      {{{.1, 0}, {.1, 1}}, arc({.45, .45}, .38, 180, 0), {{.83, .45}, {.83, 1}}},
      {{{.3, -.4}, {.3, 1}}, {{0, .05}, {.6, .05}}},
      {{{0, 0}, {.8, 1}}, {{.8, 0}, {0, 1}}},
      {{{.2, -.5}, {.2, 1}}},
      {{{.2, .1}, {.2, 1}}, {{.2, -.3}, {.2, -.3}}},
      {{{0, 0}, {.4, 1}, {.8, 0}}},
      {{{.1, -.5}, {.1, 1}}, arc({.5, .55}, .42, 0, 360)},
      {{{0, 0}, {.8, 0}, {0, 1}, {.8, 1}}},
      {{{.2, 1}, {.2, 1}}},
      {{{0, 1}, {.45, -.5}, {.9, 1}}, {{.17, .45}, {.73, .45}}},
  };
  return all;
}

Figure figure_of(const Glyph& glyph, Point corner, const Look& look) {
  const auto place = [&](Point p) {
    return Point{corner.x + p.x * look.x_height, corner.y + p.y * look.x_height};
  };
  Figure figure{{}, look.ink};
  for (const Line& line : glyph) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      figure.strokes.push_back({place(line[i]), place(line[i + 1]), look.half_width});
    }
  }
  return figure;
}

std::vector<Figure> text(const Look& look, int width, int height, Random& random) {
  const double size = look.x_height;
  std::vector<Figure> figures;
  for (double y = size; y < height - 2.5 * size; y += 2.6 * size) {
    for (double x = 6; x < width - 1.4 * size;) {
      const auto glyph = std::size_t(random.integer(0, std::int64_t(glyphs().size()) - 1));
      const bool blank = random.unit() < 0.15;
      if (!blank) figures.push_back(figure_of(glyphs()[glyph], {x, y}, look));
      x += size * (blank ? 0.6 : 1.25) + 0.3 * random.unit();
    }
  }
  return figures;
}

// Thin lines, thick lines and discs in many colours.
std::vector<Figure> shapes(int width, int height, Random& random) {
  std::vector<Figure> figures;
  for (int i = 0; i < 24; ++i) {
    Figure figure;
    for (double& code : figure.ink) code = double(random.integer(0, 255));
    const double x = random.between(10, width - 10);
    const Point from{x, random.between(10, height - 10)};
    const double angle = random.between(0, 2 * std::numbers::pi);
    const double length = i % 3 == 0 ? 0 : random.between(15, 70);
    const Point to{from.x + length * std::cos(angle), from.y + length * std::sin(angle)};
    const double half = i % 3 == 1 ? random.between(0.4, 1.2) : random.between(3, 14);
    figure.strokes.push_back({from, to, half});
    figures.push_back(figure);
  }
  return figures;
}

// Below 0 inside of a stroke.
double distance(Point p, const Stroke& stroke) {
  const double x = stroke.to.x - stroke.from.x, y = stroke.to.y - stroke.from.y;
  const double square = x * x + y * y;
  const double along =
      square > 0 ? ((p.x - stroke.from.x) * x + (p.y - stroke.from.y) * y) / square : 0;
  const double nearest = std::clamp(along, 0.0, 1.0);
  return std::hypot(p.x - stroke.from.x - nearest * x, p.y - stroke.from.y - nearest * y) -
         stroke.half_width;
}

double distance(Point p, const Figure& figure) {
  double nearest = 1e9;
  for (const Stroke& stroke : figure.strokes) nearest = std::min(nearest, distance(p, stroke));
  return nearest;
}

// The share of pixel (x, y) that the figure covers if it moves by `shift`.
double coverage(const Figure& figure, int x, int y, Point shift) {
  constexpr int kSide = 16;
  const Point corner{x - shift.x, y - shift.y};
  const double middle = distance({corner.x + 0.5, corner.y + 0.5}, figure);
  constexpr double kHalfDiagonal = std::numbers::sqrt2 / 2;
  if (middle > kHalfDiagonal) return 0;
  if (middle < -kHalfDiagonal) return 1;
  int inside = 0;
  for (int v = 0; v < kSide; ++v) {
    for (int u = 0; u < kSide; ++u) {
      const Point sample{corner.x + (u + 0.5) / kSide, corner.y + (v + 0.5) / kSide};
      inside += distance(sample, figure) < 0 ? 1 : 0;
    }
  }
  return double(inside) / (kSide * kSide);
}

// Colours during drawing: codes of sRGB in [0, 1], or linear light.
class Painting {
public:
  Painting(const Look& look, int width, int height)
      : linear_(look.linear), width_(width), values_(std::size_t(width * height)) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const double darker = look.gradient ? 0.5 * x / width + 0.1 * y / height : 0;
        Ink& pixel = values_[index(x, y)];
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = value_of(look.paper[c] * (1 - darker));
      }
    }
  }

  void draw(const Figure& figure, Point shift) {
    const int height = int(values_.size()) / width_;
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const Stroke& stroke : figure.strokes) {
      for (const Point p : {stroke.from, stroke.to}) {
        left = std::min(left, p.x - stroke.half_width);
        right = std::max(right, p.x + stroke.half_width);
        top = std::min(top, p.y - stroke.half_width);
        bottom = std::max(bottom, p.y + stroke.half_width);
      }
    }
    for (int y = std::max(int(top) - 2, 0); y < std::min(int(bottom) + 3, height); ++y) {
      for (int x = std::max(int(left) - 2, 0); x < std::min(int(right) + 3, width_); ++x) {
        const double covered = coverage(figure, x, y, shift);
        Ink& pixel = values_[index(x, y)];
        for (std::size_t c = 0; c < 3; ++c) {
          pixel[c] += (value_of(figure.ink[c]) - pixel[c]) * covered;
        }
      }
    }
  }

  StoredImage stored() const {
    std::vector<std::uint8_t> codes;
    for (const Ink& pixel : values_) {
      for (const double value : pixel) codes.push_back(code_of(value));
    }
    return {width_, int(values_.size()) / width_, 3, codes};
  }

private:
  std::size_t index(int x, int y) const { return std::size_t(y * width_ + x); }
  double value_of(double code) const {
    return linear_ ? double(decode_srgb(std::uint8_t(code))) : code / 255;
  }
  std::uint8_t code_of(double value) const {
    return linear_ ? encode_srgb(float(value)) : std::uint8_t(std::lround(value * 255));
  }

  bool linear_;
  int width_;
  std::vector<Ink> values_;
};

StoredImage drawn(const Look& look, const std::vector<Figure>& figures, Point shift, int width,
                  int height) {
  Painting painting(look, width, height);
  for (const Figure& figure : figures) painting.draw(figure, shift);
  return painting.stored();
}

std::uint8_t* pixel_of(StoredImage& image, int x, int y) {
  return std::get<std::vector<std::uint8_t>>(image.samples).data() +
         std::ptrdiff_t(3) * (std::ptrdiff_t(y) * image.width + x);
}

int largest_step(const std::uint8_t* a, const std::uint8_t* b) {
  int largest = 0;
  for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(int(a[c]) - int(b[c])));
  return largest;
}

// Whether a pixel less than 3 px away has another colour. A gradient is not another colour.
bool is_beside_edge(StoredImage& image, PixelPosition at) {
  constexpr int kOther = 6;
  for (int y = at.y - 2; y <= at.y + 2; ++y) {
    for (int x = at.x - 2; x <= at.x + 2; ++x) {
      if (largest_step(pixel_of(image, x, y), pixel_of(image, at.x, at.y)) > kOther) return true;
    }
  }
  return false;
}

bool is_near(const std::vector<ChangedPixel>& changed, PixelPosition at) {
  return std::any_of(changed.begin(), changed.end(), [at](const ChangedPixel& one) {
    return std::max(std::abs(one.at.x - at.x), std::abs(one.at.y - at.y)) < 5;
  });
}

// A colour for a pixel that changes: any, or ink, or paper.
std::array<std::uint8_t, 3> changed_colour(const Look& look, Random& random) {
  const auto choice = random.integer(0, 3);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto any = std::uint8_t(random.integer(0, 255));
    colour[c] = choice < 2 ? any : std::uint8_t(choice == 2 ? look.ink[c] : look.paper[c]);
  }
  return colour;
}

void change_pixels(MovedPair& pair, const Look& look, int changes, Random& random) {
  constexpr int kMargin = 3, kTries = 40, kSmallestChange = 64;
  for (int i = 0; i < changes * kTries && int(pair.changed.size()) < changes; ++i) {
    const auto x = int(random.integer(kMargin, pair.test.width - 1 - kMargin));
    const PixelPosition at{x, int(random.integer(kMargin, pair.test.height - 1 - kMargin))};
    const bool edge = is_beside_edge(pair.reference, at);
    const bool wanted = edge == (pair.changed.size() % 2 == 1);
    const auto colour = changed_colour(look, random);
    std::uint8_t* pixel = pixel_of(pair.test, at.x, at.y);
    if (!wanted || is_near(pair.changed, at) ||
        largest_step(pixel, colour.data()) < kSmallestChange) {
      continue;
    }
    std::copy(colour.begin(), colour.end(), pixel);
    pair.changed.push_back({at, edge ? ChangeKind::kAtEdge : ChangeKind::kOnPlain});
  }
}

}  // namespace

bool MovedPair::has_changed(int x, int y) const {
  const PixelPosition place{x, y};
  return std::any_of(changed.begin(), changed.end(),
                     [&place](const ChangedPixel& one) { return one.at == place; });
}

std::vector<std::string> moved_edge_looks() {
  std::vector<std::string> names;
  for (const Look& look : kLooks) names.push_back(look.name);
  return names;
}

MovedPair moved_pair(const std::string& look_name, double shift, int changes, std::uint64_t seed,
                     int width, int height) {
  const Look& look = look_named(look_name);
  Random random(seed);
  const auto figures =
      look.x_height > 0 ? text(look, width, height, random) : shapes(width, height, random);
  const double angle = random.between(0, 2 * std::numbers::pi);
  const Point by{shift * std::cos(angle), shift * std::sin(angle)};
  MovedPair pair{fmt::format("{}-{:.1f}", look_name, shift),
                 shift,
                 drawn(look, figures, {}, width, height),
                 drawn(look, figures, by, width, height),
                 {}};
  change_pixels(pair, look, changes, random);
  return pair;
}

}  // namespace glassbox::test
