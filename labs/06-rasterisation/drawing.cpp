// Lab 6 in a picture: the student's functions snap positions, divide polygons into fans and find
// the covered pixels.
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "labs/06-rasterisation/words.h"
#include "labs/drawing/drawing.h"

#include <glassbox/raster/coverage.h>
#include <glassbox/raster/fan.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/triangle_setup.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/primitives.h>

namespace glassbox::labs {

namespace lab_06_drawing {

constexpr int kTile = 64;  // pixels, as in stages.cpp
constexpr std::size_t kFirstTile =
    4;  // numbers of a "cover" answer before the tiles: the area and the owned edges
constexpr std::size_t kPixelNumbers = 5;  // x, y, and three edge functions
// the largest coordinate in steps of 1/256 pixel, so that no product needs more than 64 bits
constexpr double kMaxSteps = 1 << 23;

// ---- the reference ----

Numbers snapped(RecordReader& in) {
  Numbers out;
  while (in.more()) out.push_back(snap(in.real()));
  return out;
}

std::vector<SnappedVertex> vertices_of(RecordReader& in) {
  std::vector<SnappedVertex> vertices;
  while (in.more()) {
    const int x = in.integer();
    vertices.push_back({x, in.integer()});
  }
  return vertices;
}

Numbers fanned(RecordReader& in) {
  return {double(fan_apex(vertices_of(in)))};
}

struct Window {
  PixelRect pixels;
  std::array<SnappedVertex, 3> triangle;
};

Window window_of(RecordReader& in) {
  Window window;
  window.pixels = {in.integer(), in.integer(), in.integer(), in.integer()};
  const std::vector<SnappedVertex> vertices = vertices_of(in);
  std::copy_n(vertices.begin(), 3, window.triangle.begin());
  return window;
}

std::vector<PixelRect> tiles_of(const PixelRect& window) {
  std::vector<PixelRect> tiles;
  const auto next = [](int at) { return (at / kTile + 1) * kTile; };
  for (int top = window.y0; top < window.y1; top = next(top)) {
    for (int left = window.x0; left < window.x1; left = next(left))
      tiles.push_back(intersect({left, top, next(left), next(top)}, window));
  }
  return tiles;
}

// Classifies a tile edge by edge: an edge function has its smallest and largest values at the pixel
// centres in the tile's corners.
double class_of(const TriangleSetup& setup, const PixelRect& tile) {
  constexpr double kNone = 0, kSome = 1, kAll = 2;
  double cover = kAll;
  for (const EdgeFunction& edge : setup.edges) {
    int inside = 0;
    for (const int x : {tile.x0, tile.x1 - 1}) {
      for (const int y : {tile.y0, tile.y1 - 1})
        inside += edge.covers(edge.at(x * kSubpixels + kPixelCentre, y * kSubpixels + kPixelCentre))
                      ? 1
                      : 0;
    }
    if (inside == 0) return kNone;
    if (inside < 4) cover = kSome;
  }
  return cover;
}

// Undoes the sorting of the vertices by the triangle set-up: numbers[k] belongs to the vertex that
// was number order[k] before.
template <class T>
std::array<T, 3> in_input_order(const TriangleSetup& setup, const std::array<T, 3>& numbers) {
  std::array<T, 3> came;
  for (std::size_t k = 0; k < 3; ++k) came[std::size_t(setup.order[k])] = numbers[k];
  return came;
}

Numbers covered(RecordReader& in) {
  const Window window = window_of(in);
  const auto setup = setup_triangle({}, window.triangle);
  if (!setup) return {0, 0, 0, 0};
  Numbers out{double(setup->clockwise ? setup->double_area : -setup->double_area)};
  for (const bool owns : in_input_order<bool>(
           *setup,
           {setup->edges[0].owns_zero, setup->edges[1].owns_zero, setup->edges[2].owns_zero}))
    out.push_back(owns ? 1 : 0);
  const std::vector<PixelRect> tiles = tiles_of(window.pixels);
  for (const PixelRect& tile : tiles) out.push_back(class_of(*setup, tile));
  for (const PixelRect& tile : tiles) {
    for_each_covered(*setup, tile, [&](const Coverage& pixel) {
      out.insert(out.end(), {double(pixel.x), double(pixel.y)});
      for (const std::int64_t e : in_input_order(*setup, pixel.edges)) out.push_back(double(e));
    });
  }
  return out;
}

// ---- in words ----

std::string restated_polygon(const Numbers& numbers) {
  RecordReader in(numbers.data(), numbers.size());
  std::string text = "polygon";
  for (const SnappedVertex& vertex : vertices_of(in)) text += " " + text_of(vertex);
  return text + " px";
}

std::string restated_window(const Numbers& numbers) {
  RecordReader in(numbers.data(), numbers.size());
  const auto [pixels, triangle] = window_of(in);
  return fmt::format("triangle {}; pixels ({}, {}) to ({}, {})", text_of(triangle), pixels.x0,
                     pixels.y0, pixels.x1 - 1, pixels.y1 - 1);
}

// ---- judgement ----

std::optional<WrongNumber> judge_snap(const Numbers&, const Numbers& yours,
                                      const Numbers& reference) {
  return first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "steps",
      [](std::size_t i) { return fmt::format("vertex {}, {}", i / 2, i % 2 == 0 ? 'x' : 'y'); });
}

std::optional<WrongNumber> judge_fan(const Numbers&, const Numbers& yours,
                                     const Numbers& reference) {
  return first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "",
      [](std::size_t) { return std::string("the fan's first vertex"); });
}

using PixelNumbers = std::array<double, kPixelNumbers>;

// Reads the pixels row by row. Numbers at the end that do not make a whole pixel are ignored.
std::vector<PixelNumbers> pixels_in(const Numbers& answer, std::size_t first) {
  std::vector<PixelNumbers> pixels;
  for (std::size_t i = first; i + kPixelNumbers <= answer.size(); i += kPixelNumbers) {
    pixels.emplace_back();
    std::copy_n(answer.begin() + std::ptrdiff_t(i), kPixelNumbers, pixels.back().begin());
  }
  std::sort(pixels.begin(), pixels.end(), [](const PixelNumbers& a, const PixelNumbers& b) {
    return std::tie(a[1], a[0]) < std::tie(b[1], b[0]);
  });
  return pixels;
}

std::string place_of(const PixelNumbers& pixel) {
  return fmt::format("pixel ({}, {})", pixel[0], pixel[1]);
}

std::optional<WrongNumber> judge_pixels(const std::vector<PixelNumbers>& yours,
                                        const std::vector<PixelNumbers>& reference) {
  static const char* const kNames[] = {"the edge from vertex 1 to vertex 2",
                                       "the edge from vertex 2 to vertex 0",
                                       "the edge from vertex 0 to vertex 1"};
  const auto before = [](const PixelNumbers& a, const PixelNumbers& b) {
    return std::tie(a[1], a[0]) < std::tie(b[1], b[0]);
  };
  for (std::size_t i = 0; i < std::max(yours.size(), reference.size()); ++i) {
    if (i >= yours.size() || (i < reference.size() && before(reference[i], yours[i])))
      return WrongNumber{place_of(reference[i]), 0, 1, 0, "times covered", "missing"};
    if (i >= reference.size() || before(yours[i], reference[i])) {
      const bool again = i > 0 && !before(yours[i - 1], yours[i]);
      return WrongNumber{
          place_of(yours[i]), again ? 2.0 : 1.0,
          again ? 1.0 : 0.0,  0,
          "times covered",    again ? "covered twice" : "covered, and should not be"};
    }
    for (std::size_t k = 2; k < kPixelNumbers; ++k) {
      if (yours[i][k] != reference[i][k])
        return WrongNumber{place_of(reference[i]) + ", " + kNames[k - 2],
                           yours[i][k],
                           reference[i][k],
                           0,
                           "steps squared",
                           ""};
    }
  }
  return std::nullopt;
}

std::optional<WrongNumber> judge_cover(const Numbers& in, const Numbers& yours,
                                       const Numbers& reference) {
  if (yours == reference) return std::nullopt;
  RecordReader reader(in.data(), in.size());
  const std::vector<PixelRect> tiles = tiles_of(window_of(reader).pixels);
  const std::size_t head = kFirstTile + tiles.size();
  const auto name = [&](std::size_t i) {
    static const char* const kNames[] = {"twice the area",
                                         "whether the edge from vertex 1 to vertex 2 is owned",
                                         "whether the edge from vertex 2 to vertex 0 is owned",
                                         "whether the edge from vertex 0 to vertex 1 is owned"};
    if (i < kFirstTile) return std::string(kNames[i]);
    const PixelRect& tile = tiles[i - kFirstTile];
    return fmt::format("tile ({}, {}) to ({}, {}): 0 none, 1 some, 2 all", tile.x0, tile.y0,
                       tile.x1 - 1, tile.y1 - 1);
  };
  const auto wrong = first_wrong(
      std::span(yours).first(std::min(head, yours.size())),
      std::span(reference).first(std::min(head, reference.size())), [](std::size_t) { return 0; },
      "", name);
  return wrong ? wrong : judge_pixels(pixels_in(yours, head), pixels_in(reference, head));
}

// ---- in the pipeline ----

class StageObserver : public Observer {
public:
  explicit StageObserver(const View& view)
      : picture_{0, 0, int(view.viewport.width()), int(view.viewport.height())} {}

  void draw(const Draw& draw) override { draw_ = &draw; }

  void clipped(const PrimitiveStage&, const Triangle& triangle, const std::array<ClipVertex, 3>&,
               ClipPolygon& polygon) override {
    number_ = draw_->first_number + triangle.number;
    count_ = std::size_t(polygon.count);
    if (pass_ == Pass::kSnap && count_ > 0) snap_questions.push_back({{}, number_});
  }

  void mapped_to_screen(const NdcVertex&, ScreenVertex& screen) override {
    if (pass_ != Pass::kSnap || snap_questions.empty()) return;
    Numbers& numbers = snap_questions.back().numbers;
    if (numbers.size() < 2 * count_)
      numbers.insert(numbers.end(), {double(screen.position.x), double(screen.position.y)});
  }

  void fanned(std::span<SnappedVertex> polygon, int& apex) override {
    if (pass_ == Pass::kSnap || number_ >= snaps_.size()) return;
    const Numbers& given = snaps_[number_];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      polygon[i] = {steps(given, 2 * i), steps(given, 2 * i + 1)};
    }
    if (const auto found = apexes_.find(number_); found != apexes_.end())
      apex = std::clamp(found->second, 0, std::max(0, int(polygon.size()) - 1));
    polygon_.assign(polygon.begin(), polygon.end());
    apex_ = apex;
  }

  void piece_ready(const ReadyTriangle& triangle) override {
    if (pass_ == Pass::kCover) {
      Question question{{}, triangle.number};
      const std::array<SnappedVertex, 3>& corners = corners_.at({triangle.number, triangle.piece});
      const PixelRect window = intersect(triangle.setup.bounds, picture_);
      question.numbers = {double(window.x0), double(window.y0), double(window.x1),
                          double(window.y1)};
      for (const SnappedVertex& v : corners)
        question.numbers.insert(question.numbers.end(), {double(v.x), double(v.y)});
      places_[{triangle.number, triangle.piece}] = cover_questions.size();
      cover_questions.push_back(std::move(question));
    }
    order_ = triangle.setup.order;
  }

  void set_up(std::uint32_t piece, const std::array<ScreenVertex, 3>&,
              std::optional<TriangleSetup>& setup) override {
    if (pass_ != Pass::kCover || !setup) return;
    const auto at = fan_vertices(apex_, int(polygon_.size()), int(piece));
    corners_[{number_, piece}] = {polygon_[at[0]], polygon_[at[1]], polygon_[at[2]]};
  }

  const std::vector<Coverage>* covered(const FragmentSource& source) override {
    if (pass_ != Pass::kDraw || !source.is_triangle) return nullptr;
    pixels_.clear();
    const auto place = places_.find({source.number, source.piece});
    if (place == places_.end()) return &pixels_;
    RecordReader reader(cover_questions[place->second].numbers.data(), 4);
    const PixelRect window{reader.integer(), reader.integer(), reader.integer(), reader.integer()};
    const Numbers& answer = covers_[place->second];
    for (std::size_t i = kFirstTile + tiles_of(window).size(); i + kPixelNumbers <= answer.size();
         i += kPixelNumbers)
      add_pixel(&answer[i]);
    return &pixels_;
  }

  void take_snaps(const std::vector<Numbers>& answers) {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const std::uint32_t number = snap_questions[i].triangle;
      snaps_.resize(std::max(snaps_.size(), std::size_t(number) + 1));
      snaps_[number] = answers[i];
      const std::size_t count = snap_questions[i].numbers.size();
      if (count <= 6) continue;
      Question fan{{}, number};
      for (std::size_t k = 0; k < count; ++k) fan.numbers.push_back(double(steps(answers[i], k)));
      fan_questions.push_back(std::move(fan));
    }
  }
  void take_fans(const std::vector<Numbers>& answers) {
    for (std::size_t i = 0; i < answers.size(); ++i)
      apexes_[fan_questions[i].triangle] =
          answers[i].empty() ? 0 : int(to_finite_float(answers[i][0], 1000));
    pass_ = Pass::kCover;
  }
  void take_covers(std::vector<Numbers> answers) {
    covers_ = std::move(answers);
    pass_ = Pass::kDraw;
  }

  std::vector<Question> snap_questions, fan_questions, cover_questions;

private:
  static std::int32_t steps(const Numbers& answer, std::size_t i) {
    return i < answer.size() ? std::int32_t(std::clamp(answer[i], -kMaxSteps, kMaxSteps)) : 0;
  }

  // Adds a pixel of an answer. One outside the picture is wrong, and cannot be drawn.
  void add_pixel(const double* numbers) {
    const auto inside = [](double at, int size) { return at >= 0 && at < size; };
    if (!inside(numbers[0], picture_.x1) || !inside(numbers[1], picture_.y1)) return;
    Coverage pixel{int(numbers[0]), int(numbers[1]), {}};
    for (std::size_t k = 0; k < 3; ++k) {
      const double e = numbers[2 + std::size_t(order_[k])];
      pixel.edges[k] = std::abs(e) < 0x1p62 ? std::int64_t(e) : 0;
    }
    pixels_.push_back(pixel);
  }

  enum class Pass { kSnap, kCover, kDraw };
  // the number of a triangle, and of one of the triangles of the fan that clipping makes of it
  using Piece = std::pair<std::uint32_t, std::uint32_t>;
  const PixelRect picture_;
  Pass pass_ = Pass::kSnap;
  const Draw* draw_ = nullptr;
  std::uint32_t number_ = 0;
  std::size_t count_ = 0;
  std::vector<SnappedVertex> polygon_;
  int apex_ = 0;
  std::array<int, 3> order_{};
  std::vector<Numbers> snaps_;  // one for each triangle
  std::map<std::uint32_t, int> apexes_;
  std::map<Piece, std::array<SnappedVertex, 3>> corners_;
  std::map<Piece, std::size_t> places_;  // the index of the question about it
  std::vector<Numbers> covers_;
  std::vector<Coverage> pixels_;
};

const std::vector<DrawnStage>& stages() {
  static const std::vector<DrawnStage> all{
      {"snap", "screen", "snap", snapped, judge_snap,
       in_words({{"position in px of vertex", 2, kAllThatFollow}})},
      {"fan", "screen", "fan_apex", fanned, judge_fan, restated_polygon},
      {"cover", "coverage", "edge, owns_edge, covered_pixels, classify_tile", covered, judge_cover,
       restated_window}};
  return all;
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  made.settings.cull_stage = CullStage::kScreen;
  auto stage_observer = std::make_shared<StageObserver>(input.view);
  observe_run(made, *stage_observer);
  const auto snaps = answer_source.ask(stages()[0], stage_observer->snap_questions);
  if (!snaps) return tl::unexpected(snaps.error());
  stage_observer->take_snaps(*snaps);
  const auto fans = answer_source.ask(stages()[1], stage_observer->fan_questions);
  if (!fans) return tl::unexpected(fans.error());
  stage_observer->take_fans(*fans);
  observe_run(made, *stage_observer);
  auto covers = answer_source.ask(stages()[2], stage_observer->cover_questions);
  if (!covers) return tl::unexpected(covers.error());
  stage_observer->take_covers(std::move(*covers));
  made.stages = stage_observer;
  return made;
}

}  // namespace lab_06_drawing

LabDrawing drawing_06() {
  using namespace lab_06_drawing;
  return {stages(), draw, ""};
}

}  // namespace glassbox::labs
