// Lab 13 in a picture: eight pictures of the scene are taken from around it, the student's
// functions make its voxels from them, and the voxels are drawn as the camera sees them.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "labs/13-voxels/reference.h"
#include "labs/drawing/drawing.h"
#include "views/rings/draw_ring.h"
#include "views/two_view/camera.h"
#include "views/voxels/draw_voxels.h"

namespace glassbox::labs {

namespace lab_13_drawing {

// The number of views, and the side in px of each picture; the grid's resolution in voxels. The
// first view is at the angle kStart, which is in no plane of symmetry of a scene, so that no
// voxel's centre is projected exactly between two pixels.
constexpr int kViews = 8, kSide = 64, kResolution = 32;
constexpr double kElevation = 40, kStart = 7.3;
// The deviation of up to eight colours with whole levels is never exactly this threshold, so
// rounding cannot change a verdict.
constexpr double kThreshold = 18.3;

using views::Vector3d;

// ---- the reference ----

lab_13::Place place(RecordReader& in) {
  const double x = in.number(), y = in.number();
  return {x, y, in.number()};
}

Numbers order(RecordReader& in) {
  const lab_13::Place low = place(in);
  const lab_13::Box box{low, place(in)};
  std::vector<lab_13::Place> cameras;
  while (in.more()) cameras.push_back(place(in));
  const lab_13::Order found = voxels::classify(cameras, box);
  return {double(found.kind), double(found.away[0]), double(found.away[1]), double(found.away[2])};
}

Numbers sweep(RecordReader& in) {
  lab_13::Grid grid;
  for (int& count : grid.count) count = in.integer();
  grid.axis = in.integer();
  grid.away = in.integer();
  const double k1 = in.number();
  const lab_13::Threshold threshold{k1, in.number()};
  std::vector<lab_13::Picture> pictures;
  while (in.more()) {
    lab_13::Picture& picture = pictures.emplace_back();
    for (auto& row : picture.pixel_from_grid)
      for (double& entry : row) entry = in.number();
    picture.width = in.integer();
    picture.height = in.integer();
    for (int i = 0; i < picture.width * picture.height; ++i) {
      const int rgb = in.integer();
      lab_13::Pixel pixel;
      pixel.is_background = rgb < 0;
      if (rgb >= 0)
        pixel.colour = {double(rgb >> 16 & 255), double(rgb >> 8 & 255), double(rgb & 255)};
      picture.pixels.push_back(pixel);
    }
  }
  Numbers out;
  for (const lab_13::Coloured& voxel : voxels::sweep(std::move(pictures), grid, threshold)) {
    for (const int coordinate : {voxel.at.x, voxel.at.y, voxel.at.z}) out.push_back(coordinate);
    out.insert(out.end(), voxel.mean.begin(), voxel.mean.end());
  }
  return out;
}

// ---- judgement ----

std::optional<WrongNumber> judge_order(const Numbers&, const Numbers& yours,
                                       const Numbers& reference) {
  return first_wrong(
      yours, reference, [](std::size_t) { return 0; }, "",
      [](std::size_t i) {
        return i == 0 ? std::string("kind")
                      : fmt::format("direction away from the cameras, {}", "xyz"[i - 1]);
      });
}

// The three coordinates of a voxel must be exact; its colour is a mean of at most eight values.
std::optional<WrongNumber> judge_sweep(const Numbers&, const Numbers& yours,
                                       const Numbers& reference) {
  return first_wrong(
      yours, reference,
      [](std::size_t i) { return i % 6 < 3 ? 0 : 2 * (kViews + 4) * voxels::kUnit * 255; }, "",
      [](std::size_t i) {
        static constexpr const char* kNames[] = {"x", "y", "z", "red", "green", "blue"};
        return fmt::format("voxel {}, {}", i / 6, kNames[i % 6]);
      });
}

const std::vector<DrawnStage>& stages() {
  static const std::vector<DrawnStage> all{
      {"order", "world", "classify", order, judge_order,
       in_words({{"low corner", 3}, {"high corner", 3}, {"camera", 3, kAllThatFollow}})},
      {"sweep", "depth", "sweep, judge, statistics", sweep, judge_sweep,
       in_words({{"voxels along x, y, z", 3},
                 {"axis"},
                 {"away"},
                 {"k1, k2", 2},
                 {"P of the first picture", 12},
                 {"its width, height", 2},
                 {"colour of pixel", 1, kAllThatFollow}})}};
  return all;
}
enum Stage : std::size_t { kOrder, kSweep };

// ---- in the pipeline ----

Result<Numbers> ask_one(AnswerSource& answer_source, Stage stage, Numbers numbers) {
  const std::vector<Question> questions{{std::move(numbers)}};
  return answer_source.ask(stages()[stage], questions).map([](std::vector<Numbers>&& answers) {
    return std::move(answers[0]);
  });
}

Result<views::PictureSet> ring_of(const DrawingInput& input) {
  views::RingOptions options;
  options.views = kViews;
  options.elevations = {kElevation};
  options.start_degrees = kStart;
  options.width = options.height = kSide;
  const auto ring = views::ring_views(input.scene, options);
  if (!ring) return tl::unexpected(ring.error());
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  return views::draw_ring(input.scene, *ring, settings, views::Matte::kDepth);
}

Numbers order_question(const views::PictureSet& set) {
  Numbers numbers;
  const auto add = [&](const Vector3d& p) { numbers.insert(numbers.end(), {p.x(), p.y(), p.z()}); };
  add(set.box->low);
  add(set.box->high);
  for (const views::CalibratedPicture& picture : set.pictures) add(picture.camera.centre);
  return numbers;
}

Numbers sweep_question(const views::PictureSet& set, const views::VoxelGrid& grid, int axis,
                       int away) {
  Numbers numbers{double(grid.count[0]),
                  double(grid.count[1]),
                  double(grid.count[2]),
                  double(axis),
                  double(away),
                  0,
                  kThreshold};
  for (const views::CalibratedPicture& picture : set.pictures) {
    const views::GridPicture lens = views::grid_picture(grid, views::projection_of(picture.camera),
                                                        picture.color.width, picture.color.height);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        numbers.push_back(lens.pixel_from_grid(row, column));
    numbers.push_back(picture.color.width);
    numbers.push_back(picture.color.height);
    for (std::size_t i = 0; i < picture.color.pixels.size(); ++i) {
      const Rgba8& c = picture.color.pixels[i];
      numbers.push_back(picture.matte.pixels[i] == 0 ? -1 : 65536.0 * c.r + 256.0 * c.g + c.b);
    }
  }
  return numbers;
}

// The voxels of an answer that are in the grid.
std::vector<views::ColoredVoxel> voxels_in(const Numbers& answer, const views::VoxelGrid& grid) {
  std::vector<views::ColoredVoxel> all;
  for (std::size_t i = 0; i + 6 <= answer.size(); i += 6) {
    bool is_in = true;
    for (std::size_t k = 0; k < 3; ++k)
      is_in = is_in && answer[i + k] >= 0 && answer[i + k] < grid.count[k];
    if (!is_in) continue;
    const auto level = [&](std::size_t k) {
      const double value = answer[i + 3 + k];
      // A mean of whole levels can be exactly halfway between two levels. It is always rounded up,
      // even if its last digit makes it slightly too small.
      constexpr double kHalf = 0.5 + 0x1p-20;
      return std::uint8_t(std::floor(std::clamp(value > 0 ? value : 0.0, 0.0, 255.0) + kHalf));
    };
    all.push_back({{int(answer[i]), int(answer[i + 1]), int(answer[i + 2])},
                   {level(0), level(1), level(2), 255},
                   0,
                   0});
  }
  return all;
}

// The first axis along which the student's answer gives an order of layers, and its direction (1 or
// -1); the z axis if there is none.
std::pair<int, int> sweep_direction(const Numbers& order) {
  for (std::size_t axis = 0; axis < 3 && axis + 1 < order.size(); ++axis) {
    if (order[axis + 1] == 1 || order[axis + 1] == -1) return {int(axis), int(order[axis + 1])};
  }
  return {2, 1};
}

Result<PictureSetup> draw(const DrawingInput& input, AnswerSource& answer_source) {
  if (const auto opaque = check_opaque(input.scene, "lab 13"); !opaque)
    return tl::unexpected(opaque.error());
  const auto set = ring_of(input);
  if (!set) return tl::unexpected(set.error());
  const auto grid = views::grid_of(*set->box, views::size_for(*set->box, kResolution),
                                   views::Matrix3d::Identity());
  if (!grid) return tl::unexpected(grid.error());
  const auto camera = views::camera_of(input.view);
  if (!camera) return tl::unexpected(camera.error());
  const auto order = ask_one(answer_source, kOrder, order_question(*set));
  if (!order) return tl::unexpected(order.error());
  const auto [axis, away] = sweep_direction(*order);
  const auto found = ask_one(answer_source, kSweep, sweep_question(*set, *grid, axis, away));
  if (!found) return tl::unexpected(found.error());

  PictureSetup made{input.scene, input.view, input.settings, nullptr, {}};
  made.settings.show = Show::kColor;
  made.finish = [picture = views::draw_voxels(*grid, voxels_in(*found, *grid), *camera,
                                              int(input.view.viewport.width()),
                                              int(input.view.viewport.height()),
                                              input.settings.background)
                               .color](Framebuffer& buffers) {
    if (buffers.color.pixels.size() == picture.pixels.size()) buffers.color.pixels = picture.pixels;
  };
  return made;
}

// The camera's picture of the scene itself, as the pipeline draws it, for comparison.
PictureSetup truth(const DrawingInput& input) {
  PictureSetup scene{input.scene, input.view, input.settings, nullptr, {}};
  scene.settings.show = Show::kColor;
  return scene;
}

}  // namespace lab_13_drawing

LabDrawing drawing_13() {
  using namespace lab_13_drawing;
  return {.stages = stages(), .draw = draw, .not_drawn = "footprint", .truth = truth};
}

}  // namespace glassbox::labs
