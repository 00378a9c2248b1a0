// Lab 8 in a picture: the student's functions interpolate the attributes of triangles, two numbers
// at a time, and divide the teapot into triangles.
#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "labs/drawing/drawing.h"

#include <glassbox/base/rounding.h>
#include <glassbox/mesh/builtin/teapot_data.h>
#include <glassbox/raster/snap.h>
#include <glassbox/raster/texture.h>
#include <glassbox/render/engine/draw_list.h>
#include <glassbox/render/staged/primitives.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox::labs {

namespace lab_08_drawing {

constexpr double u24 = double(unit_roundoff<float>);
constexpr double u53 = unit_roundoff<double>;

// ---- a question to the student's function, in the order in which stages.cpp reads it ----

constexpr std::size_t kHead = 3;  // how many pairs of attributes; the texture's width and height
constexpr std::size_t kPixelNumbers = 5;  // x, y, three edge functions

struct Corner {
  double x = 0, y = 0, inverse_w = 1;
  std::span<const double> attributes;
};

struct ParsedQuestion {
  std::size_t pairs = 0;
  int width = 0, height = 0;
  std::array<Corner, 3> corners;
  std::span<const double> pixels;

  explicit ParsedQuestion(const Numbers& in)
      : pairs(std::size_t(in[0])), width(int(in[1])), height(int(in[2])) {
    const std::size_t of_corner = 3 + 2 * pairs;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::span<const double> at = std::span(in).subspan(kHead + k * of_corner, of_corner);
      corners[k] = {at[0], at[1], at[2], at.subspan(3)};
    }
    pixels = std::span(in).subspan(kHead + 3 * of_corner);
  }
  // How many numbers an answer has for each pixel.
  std::size_t numbers_per_pixel() const { return 2 * pairs + (width > 0 ? 1 : 0); }
};

// The perspective-correct weights of the three corners, from the edge functions and 1/w.
std::array<double, 3> weights_at(const ParsedQuestion& asked, std::span<const double> pixel) {
  std::array<double, 3> share{};
  for (std::size_t k = 0; k < 3; ++k) share[k] = pixel[2 + k] * asked.corners[k].inverse_w;
  const double sum = share[0] + share[1] + share[2];
  return {share[0] / sum, share[1] / sum, share[2] / sum};
}

// ---- footprints ----

struct Gradient {
  double along_x = 0, along_y = 0;
};

struct Edges {
  std::array<double, 3> at, along_x, along_y;
};

Edges edges_at(const ParsedQuestion& asked, double x, double y) {
  Edges edges{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &from = asked.corners[(k + 1) % 3], &to = asked.corners[(k + 2) % 3];
    edges.along_x[k] = from.y - to.y;
    edges.along_y[k] = to.x - from.x;
    edges.at[k] = edges.along_x[k] * (x - from.x) + edges.along_y[k] * (y - from.y);
  }
  return edges;
}

// The derivatives along screen x and y of an attribute N / D, with N = sum E_k q_k a_k and D = sum
// E_k q_k. For corner k, E_k is the edge function, q_k is 1/w and a_k the attribute. The quotient
// rule gives (N/D)' = (N' - (N/D) D') / D.
Gradient gradient_of(const ParsedQuestion& asked, const Edges& edges, std::size_t attribute) {
  double n = 0, d = 0, nx = 0, ny = 0, dx = 0, dy = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double q = asked.corners[k].inverse_w, a = asked.corners[k].attributes[attribute];
    n += edges.at[k] * q * a, d += edges.at[k] * q;
    nx += edges.along_x[k] * q * a, dx += edges.along_x[k] * q;
    ny += edges.along_y[k] * q * a, dy += edges.along_y[k] * q;
  }
  return {(nx - n / d * dx) / d, (ny - n / d * dy) / d};
}

// The bound of task 8.4: 2048 k^2 (U / e) u53. U is the largest |attribute| of the corners, e the
// longer side of the triangle's bounding box, and u53 = 2^-53. k = (e^2 / twice the area) (the
// largest 1/w / the 1/w at the pixel).
double gradient_bound(const ParsedQuestion& asked, const Edges& edges, std::size_t attribute) {
  double left = INFINITY, right = -INFINITY, top = INFINITY, bottom = -INFINITY;
  double largest = 0, largest_w = 0, area = 0, here = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner& c = asked.corners[k];
    left = std::min(left, c.x), right = std::max(right, c.x);
    top = std::min(top, c.y), bottom = std::max(bottom, c.y);
    largest = std::max(largest, std::abs(c.attributes[attribute]));
    largest_w = std::max(largest_w, c.inverse_w);
    area += edges.at[k];
    here += edges.at[k] * c.inverse_w;
  }
  const double e = std::max(right - left, bottom - top);
  const double k = e * e / std::abs(area) * (largest_w / std::abs(here / area));
  return 2048 * k * k * (largest / e) * u53;
}

struct Level {
  double level = 0, bound = 0;
};

Level level_at(const ParsedQuestion& asked, std::span<const double> pixel) {
  const Edges edges = edges_at(asked, pixel[0] + 0.5, pixel[1] + 0.5);
  const Gradient u = gradient_of(asked, edges, 0), v = gradient_of(asked, edges, 1);
  const double longer = std::max(std::hypot(asked.width * u.along_x, asked.height * v.along_x),
                                 std::hypot(asked.width * u.along_y, asked.height * v.along_y));
  const double last = std::log2(std::max(asked.width, asked.height));
  const double off = std::hypot(asked.width * gradient_bound(asked, edges, 0),
                                asked.height * gradient_bound(asked, edges, 1));
  // log2 multiplies an error of the length by 1 / (length ln 2). Lengths below 1 all give level 0.
  // The bound is doubled, because both the student's level and ours have this error.
  return {std::clamp(longer > 0 ? std::log2(longer) : 0.0, 0.0, last),
          2 * off / std::max(longer, 0.5) / std::log(2.0) + 32 * u53 * last};
}

// ---- the reference ----

Numbers attributes(RecordReader& in) {
  Numbers question;
  while (in.more()) question.push_back(in.number());
  const ParsedQuestion asked(question);
  Numbers out;
  out.reserve(asked.pixels.size() / kPixelNumbers * asked.numbers_per_pixel());
  for (std::size_t i = 0; i < asked.pixels.size(); i += kPixelNumbers) {
    const std::span<const double> pixel = asked.pixels.subspan(i, kPixelNumbers);
    const std::array<double, 3> b = weights_at(asked, pixel);
    for (std::size_t k = 0; k < 2 * asked.pairs; ++k) {
      const auto [a0, a1, a2] =
          std::array{asked.corners[0].attributes[k], asked.corners[1].attributes[k],
                     asked.corners[2].attributes[k]};
      out.push_back(a0 + (b[1] * (a1 - a0) + b[2] * (a2 - a0)));
    }
    if (asked.width > 0) out.push_back(level_at(asked, pixel).level);
  }
  return out;
}

using Vec = Vector<Object, double>;

// The Bernstein polynomials at i/n. They are computed from integers, so that at (n - i)/n they are
// exactly the same four numbers in the opposite order.
std::array<double, 4> bernstein(int i, int n) {
  const double a = n - i, b = i, whole = double(n) * n * n;
  return {a * a * a / whole, 3 * (a * a * b) / whole, 3 * (a * b * b) / whole, b * b * b / whole};
}

Vec weighted(const std::array<double, 4>& weight, const std::array<Vec, 4>& p) {
  return (p[0] * weight[0] + p[3] * weight[3]) + (p[1] * weight[1] + p[2] * weight[2]);
}

using Rows = std::array<std::array<Vec, 4>, 4>;

bool starts_at_pole(const Rows& rows) {
  return rows[0][0] == rows[0][1] && rows[0][1] == rows[0][2] && rows[0][2] == rows[0][3];
}

Numbers patch(RecordReader& in) {
  const int n = in.integer();
  Rows rows;
  for (auto& row : rows) {
    for (Vec& p : row) p = in.point<Vec>();
  }
  Numbers positions, triangles;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      std::array<Vec, 4> across;
      for (std::size_t k = 0; k < 4; ++k) across[k] = weighted(bernstein(i, n), rows[k]);
      append_point(positions, weighted(bernstein(j, n), across));
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      const bool at_pole = j == 0 && starts_at_pole(rows);
      if (!at_pole) triangles.insert(triangles.end(), {a, b, c});
      triangles.insert(triangles.end(), {a, c, d});
    }
  }
  Numbers out{double(positions.size() / 3), double(triangles.size() / 3)};
  out.insert(out.end(), positions.begin(), positions.end());
  out.insert(out.end(), triangles.begin(), triangles.end());
  return out;
}

// ---- judgement ----

std::optional<WrongNumber> judge_attributes(const Numbers& in, const Numbers& yours,
                                            const Numbers& reference) {
  const ParsedQuestion asked(in);
  const std::size_t numbers_per_pixel = asked.numbers_per_pixel();
  const auto pixel_of = [&](std::size_t i) {
    return asked.pixels.subspan(
        std::min(i / numbers_per_pixel * kPixelNumbers, asked.pixels.size() - kPixelNumbers),
        kPixelNumbers);
  };
  // The bound of task 8.1 for an attribute a: 16 u24 (b1 |a1 - a0| + b2 |a2 - a0|) + u24 |a|, where
  // a0, a1, a2 are the corners' values, b1, b2 their weights, and u24 = 2^-24.
  const auto bound = [&](std::size_t i) {
    const std::span<const double> pixel = pixel_of(i);
    const std::size_t k = i % numbers_per_pixel;
    if (k == 2 * asked.pairs) return level_at(asked, pixel).bound;
    const std::array<double, 3> b = weights_at(asked, pixel);
    const double a0 = asked.corners[0].attributes[k];
    const double spread = b[1] * std::abs(asked.corners[1].attributes[k] - a0) +
                          b[2] * std::abs(asked.corners[2].attributes[k] - a0);
    return 16 * u24 * spread + u24 * std::abs(reference[i]);
  };
  return first_wrong(yours, reference, bound, "", [&](std::size_t i) {
    const std::span<const double> pixel = pixel_of(i);
    const std::size_t k = i % numbers_per_pixel;
    return fmt::format("pixel ({}, {}), {}", pixel[0], pixel[1],
                       k == 2 * asked.pairs ? "mip level" : fmt::format("attribute {}", k));
  });
}

// The bound of task 8.5 for a position: 64 u53 (u53 = 2^-53) times the largest coordinate of a
// control point.
std::optional<WrongNumber> judge_patch(const Numbers& in, const Numbers& yours,
                                       const Numbers& reference) {
  double largest = 0;
  for (std::size_t i = 1; i < in.size(); ++i) largest = std::max(largest, std::abs(in[i]));
  const std::size_t coordinates = 3 * std::size_t(reference[0]);
  const auto is_position = [&](std::size_t i) { return i >= 2 && i < 2 + coordinates; };
  return first_wrong(
      yours, reference, [&](std::size_t i) { return is_position(i) ? 64 * u53 * largest : 0; },
      "object units",
      [&](std::size_t i) {
        if (i < 2) return std::string(i == 0 ? "how many positions" : "how many triangles");
        const std::size_t at = is_position(i) ? i - 2 : i - 2 - coordinates;
        return fmt::format(
            "{} {}, {}", is_position(i) ? "position" : "triangle", at / 3,
            is_position(i) ? std::string(1, "xyz"[at % 3]) : fmt::format("corner {}", at % 3));
      });
}

// ---- the teapot ----

// The level n of the built-in teapot, or 0 for another scene. The teapot has 32 patches of n x n
// cells with two triangles each. In 8 patches one row is a pole, where each of the n cells has a
// single triangle.
int teapot_level(const Scene& scene) {
  if (scene.name != "teapot" || !scene.file.empty() || scene.meshes.size() != 1) return 0;
  for (int n = 1; n <= 256; ++n) {
    if (scene.meshes[0].faces.size() == std::size_t(64 * n * n - 8 * n)) return n;
  }
  return 0;
}

std::vector<Question> patch_questions(int level) {
  std::vector<Question> questions;
  for (const TeapotPatch& indices : kTeapotPatches) {
    Question question;
    question.numbers.push_back(level);
    for (const std::uint16_t index : indices) {
      const auto& p = kTeapotPoints[index];
      // the teapot has z up, the scene y up
      append_point(question.numbers, Vec(p[0], p[2], 0 - p[1]));
    }
    questions.push_back(std::move(question));
  }
  return questions;
}

// The teapot made of the student's patches. It keeps the normals and texture coordinates of the
// original teapot, which are listed patch by patch in the order of the positions.
Mesh teapot_of(const std::vector<Numbers>& patches, int level, Mesh mesh) {
  mesh.positions.clear(), mesh.corners.clear(), mesh.faces.clear();
  std::map<std::array<float, 3>, std::uint32_t> shared;  // finds equal positions of two patches
  const auto count = std::size_t(level + 1) * std::size_t(level + 1);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const Numbers& answer = patches[p];
    if (answer.size() < 2 + 3 * count) continue;
    const auto triangles = std::size_t(std::clamp(answer[1], 0.0, 2.0 * level * level));
    std::vector<std::uint32_t> index;
    for (std::size_t i = 0; i < count; ++i) {
      const double* at = &answer[2 + 3 * i];
      const std::array<float, 3> place{to_finite_float(at[0]), to_finite_float(at[1]),
                                       to_finite_float(at[2])};
      const auto [entry, is_first] = shared.try_emplace(place, mesh.positions.size());
      if (is_first) mesh.positions.push_back({place[0], place[1], place[2]});
      index.push_back(entry->second);
    }
    for (std::size_t t = 0; t < triangles && 2 + 3 * (count + t) + 3 <= answer.size(); ++t) {
      const double* at = &answer[2 + 3 * (count + t)];
      const auto names_one = [&](double c) { return c >= 0 && c < double(count); };
      if (!std::all_of(at, at + 3, names_one)) continue;
      mesh.faces.push_back({std::uint32_t(mesh.corners.size()), 3});
      for (int k = 0; k < 3; ++k) {
        const auto i = std::size_t(at[k]);
        const auto table = std::uint32_t(p * count + i);
        mesh.corners.push_back({index[i], table, table, kNone});
      }
    }
  }
  return mesh;
}

// ---- in the pipeline ----

constexpr std::size_t kPairs = 9;

// The attributes of a fragment, which the student's function interpolates in pairs: texture
// coordinates, normal, position, colour, diffuse light, specular light.
std::array<float*, 2 * kPairs> varying_pointers(Varyings& v) {
  return {&v.texcoord[0], &v.texcoord[1], &v.normal[0],   &v.normal[1],  &v.normal[2],
          &v.position[0], &v.position[1], &v.position[2], &v.color[0],   &v.color[1],
          &v.color[2],    &v.color[3],    &v.diffuse[0],  &v.diffuse[1], &v.diffuse[2],
          &v.specular[0], &v.specular[1], &v.specular[2]};
}

class StageObserver : public Observer {
public:
  explicit StageObserver(const RenderSettings& settings) : settings_(settings) {}

  void draw(const Draw& draw) override {
    draw_ = &draw;
    const bool textured = draw.texture != nullptr || draw.emission_texture != nullptr;
    const bool lit = needs_normals(draw, settings_);
    const bool at_vertices = lit && settings_.shading != Shading::kPhong;
    requested_pairs_.clear();
    if (textured || settings_.show == Show::kUv) requested_pairs_.push_back(0);
    if (lit) requested_pairs_.insert(requested_pairs_.end(), {1, 2, 3});
    if (!draw.mesh->colors.empty()) requested_pairs_.insert(requested_pairs_.end(), {4, 5});
    if (at_vertices) requested_pairs_.insert(requested_pairs_.end(), {6, 7, 8});
  }

  void clipped(const PrimitiveStage&, const Triangle& triangle, const std::array<ClipVertex, 3>&,
               ClipPolygon&) override {
    number_ = draw_->first_number + triangle.number;
  }

  void set_up(std::uint32_t piece, const std::array<ScreenVertex, 3>& vertices,
              std::optional<TriangleSetup>& setup) override {
    if (gathering_ && setup)
      corners_[{number_, piece}] = {snap(vertices[0]), snap(vertices[1]), snap(vertices[2])};
  }

  void piece_ready(const ReadyTriangle& triangle) override {
    ready_ = &triangle;
    answer_ = nullptr;
    question_begun_ = false;
    if (gathering_) return;
    const auto place = places_.find({triangle.number, triangle.piece});
    if (place != places_.end()) answer_ = &answers_[place->second];
    at_ = 0;
  }

  void interpolated(const FragmentSource& source, const Coverage& coverage, Fragment&) override {
    coverage_ = coverage;
    is_triangle_ = source.is_triangle;
  }

  void attributes_interpolated(const Fragment&, Varyings& at) override {
    if (!is_triangle_ || requested_pairs_.empty()) return;
    if (gathering_) return gather();
    level_.reset();
    const auto all = varying_pointers(at);
    for (const std::size_t pair : requested_pairs_) {
      for (const std::size_t slot : {2 * pair, 2 * pair + 1}) *all[slot] = next();
    }
    if (draw_->texture != nullptr) level_ = std::clamp(next(), 0.0f, 32.0f);
  }

  void textured(const Varyings& at, Rgba& surface) override {
    if (gathering_ || !level_ || draw_->texture == nullptr) return;
    const Rgba& base = draw_->material->base_color;
    const Rgba texel =
        sample_mip_chain(draw_->texture->get(), *draw_->sampler, at.texcoord, *level_);
    surface = {base.r * at.color[0] * texel.r, base.g * at.color[1] * texel.g,
               base.b * at.color[2] * texel.b, base.a * at.color[3] * texel.a};
  }

  void take(std::vector<Numbers> answers) {
    answers_ = std::move(answers);
    gathering_ = false;
  }

  std::vector<Question> questions;

private:
  void gather() {
    if (!question_begun_) begin_question();
    question_begun_ = true;
    Numbers& numbers = questions.back().numbers;
    numbers.insert(numbers.end(), {double(coverage_.x), double(coverage_.y)});
    for (const std::int64_t e : coverage_.edges) numbers.push_back(double(e));
  }

  void begin_question() {
    const FragmentSource source{ready_->number, ready_->piece, true};
    places_[{source.number, source.piece}] = questions.size();
    const MipChain* texture = draw_->texture != nullptr ? &draw_->texture->get() : nullptr;
    Question question{
        {double(requested_pairs_.size()), double(texture != nullptr ? texture->width : 0),
         double(texture != nullptr ? texture->height : 0)},
        source.number};
    const auto& came = corners_.at({source.number, source.piece});
    for (std::size_t k = 0; k < 3; ++k) {
      const SnappedVertex& v = came[std::size_t(ready_->setup.order[k])];
      question.numbers.insert(
          question.numbers.end(),
          {double(v.x) / kSubpixels, double(v.y) / kSubpixels, double(ready_->setup.inverse_w[k])});
      Varyings carried_here = ready_->vertices[k];
      const auto all = varying_pointers(carried_here);
      for (const std::size_t pair : requested_pairs_)
        question.numbers.insert(question.numbers.end(),
                                {double(*all[2 * pair]), double(*all[2 * pair + 1])});
    }
    questions.push_back(std::move(question));
  }

  float next() {
    return answer_ != nullptr && at_ < answer_->size() ? to_finite_float((*answer_)[at_++]) : 0.0f;
  }

  using Piece = std::pair<std::uint32_t, std::uint32_t>;
  const RenderSettings settings_;
  bool gathering_ = true;
  const Draw* draw_ = nullptr;
  std::vector<std::size_t> requested_pairs_;  // pairs of varying_pointers() that are needed
  std::uint32_t number_ = 0;
  const ReadyTriangle* ready_ = nullptr;
  bool question_begun_ = false, is_triangle_ = false;
  Coverage coverage_;
  std::map<Piece, std::array<SnappedVertex, 3>> corners_;
  std::map<Piece, std::size_t> places_;
  std::vector<Numbers> answers_;
  const Numbers* answer_ = nullptr;
  std::size_t at_ = 0;
  std::optional<float> level_;
};

std::string restated_attributes(const Numbers& in) {
  const int attributes = in.empty() ? 0 : 2 * int(in[0]);
  return in_words({{"pairs of attributes"},
                   {"texture width, height", 2},
                   {"x, y, 1/w, attributes of corner", 3 + attributes, 3},
                   {"x, y, edge functions of pixel", 5, kAllThatFollow}})(in);
}

const std::vector<DrawnStage>& stages() {
  static const std::vector<DrawnStage> all{{"patch", "object", "tessellate", patch, judge_patch,
                                            in_words({{"level"}, {"control point", 3, 16}})},
                                           {"attributes", "shading", "texcoord_at, footprint_at",
                                            attributes, judge_attributes, restated_attributes}};
  return all;
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  if (const int level = teapot_level(input.scene); level > 0) {
    const auto patches = answer_source.ask(stages()[0], patch_questions(level));
    if (!patches) return tl::unexpected(patches.error());
    made.scene.meshes[0] = teapot_of(*patches, level, input.scene.meshes[0]);
  }
  auto stage_observer = std::make_shared<StageObserver>(input.settings);
  observe_run(made, *stage_observer);
  auto answers = answer_source.ask(stages()[1], stage_observer->questions);
  if (!answers) return tl::unexpected(answers.error());
  stage_observer->take(std::move(*answers));
  made.stages = stage_observer;
  return made;
}

}  // namespace lab_08_drawing

LabDrawing drawing_08() {
  using namespace lab_08_drawing;
  return {stages(), draw, "span_coordinates, longest_span, patch_level"};
}

}  // namespace glassbox::labs
