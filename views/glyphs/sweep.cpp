#include "views/glyphs/sweep.h"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <glassbox/base/trig.h>

#include "views/glyphs/decoys.h"
#include "views/glyphs/picture_effects.h"
#include "views/glyphs/sensor.h"
#include "views/rings/ring.h"

namespace glassbox::views {

namespace {

struct Photo {
  PinholeCamera camera;
  Image<Rgba8> picture;
  Image<std::uint8_t> covered;
};

constexpr double kDistance = 2;  // metres

Wall wall_of_panels(int panels) {
  WallLayout layout;
  layout.panels = panels;
  if (panels == 1) layout.columns = 12;
  return *make_wall(layout);
}

Photo take_photo(WallPhotographer& photographer, double azimuth, int width) {
  const int height = width * 3 / 4;
  Photo photo{camera_in_front(kDistance, azimuth, 5, width, height), {}, {}};
  photo.picture = photographer.photograph(photo.camera, width, height);
  return photo;
}

constexpr double kDpi = 50;

RenderSettings unlit_on_grey() {
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  settings.samples = 4;
  settings.background = {128, 128, 128, 255};
  return settings;
}

// Each sensor has one effect (distortion, darker corners, a mosaic or noise), except one that has
// two.
std::vector<std::pair<std::string, Sensor>> sensors() {
  std::vector<std::pair<std::string, Sensor>> all{{"as it is", {}}};
  for (const double lost : {0.3, 0.6})
    all.emplace_back(fmt::format("{:.0f} % darker corners", 100 * lost), Sensor{.falloff = lost});
  all.emplace_back("mosaic", Sensor{.has_mosaic = true});
  for (const double electrons : {5000.0, 500.0, 50.0})
    all.emplace_back(fmt::format("noise of {} electrons", electrons),
                     Sensor{.electrons = electrons});
  all.emplace_back("mosaic, 500 electrons", Sensor{.has_mosaic = true, .electrons = 500});
  for (const double bend : {0.002, 0.01, 0.05})
    all.emplace_back(fmt::format("bent by {}", bend), Sensor{.distortion = bend});
  return all;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void add_result(SweepRow& row, const Wall& wall, const Photo& photo, const FindSettings& settings,
                double least_across) {
  const int width = photo.picture.width, height = photo.picture.height;
  const FoundGlyphs found = find_glyphs(photo.picture, settings, wall.identities());
  auto visible = visible_glyphs(wall, photo.camera, width, height, photo.covered);
  std::erase_if(visible, [&](const VisibleGlyph& glyph) { return glyph.shorter < least_across; });
  const GlyphScore score = glyph_score(found, wall, photo.camera, visible);
  row.score.visible += score.visible;
  row.score.right += score.right;
  row.score.wrong += score.wrong;
  row.score.partly += score.partly;
  PoseRequest request;
  request.known = KnownIntrinsics::kAll;
  request.intrinsic = photo.camera.intrinsic;
  const auto pose = find_pose(points_of(found, wall).points, request);
  const PoseError error = pose ? pose_error(pose->camera, photo.camera) : PoseError{kNan, kNan};
  // If one photo has no pose (nan), the worst error stays nan.
  const auto keep_worst = [](double& worst, double one) {
    if (!std::isnan(worst) && !(one <= worst)) worst = one;
  };
  keep_worst(row.degrees, error.degrees);
  keep_worst(row.millimetres, 1000 * error.distance);
}

std::vector<SweepRow> without_rules(const FindSettings& settings) {
  const DecoyPicture picture = draw_decoys();
  std::vector<SweepRow> rows;
  const auto add = [&](const std::string& level, const FindSettings& asked) {
    const DecoyScore score = score_decoys(picture, asked);
    rows.push_back({level, {score.glyphs, score.found, score.all_accepted(), 0}, kNan, kNan});
  };
  add("all", settings);
  for (int rule = 0; rule < kGlyphRules; ++rule) {
    FindSettings some = settings;
    some.enabled_rules[std::size_t(rule)] = false;
    add("without " + std::string(name_of(GlyphRule(rule))), some);
  }
  return rows;
}

}  // namespace

std::string_view name_of(SweepVariable what) {
  switch (what) {
    case SweepVariable::kSize:
      return "size";
    case SweepVariable::kBlur:
      return "blur";
    case SweepVariable::kOcclusion:
      return "occlusion";
    case SweepVariable::kTilt:
      return "tilt";
    case SweepVariable::kJpeg:
      return "jpeg";
    case SweepVariable::kBalance:
      return "balance";
    case SweepVariable::kCamera:
      return "camera";
    case SweepVariable::kThreshold:
      return "threshold";
    case SweepVariable::kRules:
      return "rules";
  }
  return "";
}

PinholeCamera camera_in_front(double distance, double azimuth_degrees, double elevation_degrees,
                              int width, int height) {
  const SinCos around = sin_cos_degrees(azimuth_degrees), up = sin_cos_degrees(elevation_degrees);
  PinholeCamera camera;
  const double focal = height / 2.0 / tan_half_degrees(40);
  camera.intrinsic << focal, 0, width / 2.0, 0, focal, height / 2.0, 0, 0, 1;
  camera.centre = distance * Vector3d(around.sin * up.cos, up.sin, around.cos * up.cos);
  const Vector3d gaze = -camera.centre.normalized();
  const Vector3d right = gaze.cross(Vector3d::UnitY()).normalized();
  camera.camera_from_world.row(0) = right.transpose();
  camera.camera_from_world.row(1) = gaze.cross(right).transpose();
  camera.camera_from_world.row(2) = gaze.transpose();
  return camera;
}

WallPhotographer::WallPhotographer(const Wall& wall)
    : scene_(wall_scene(wall, kDpi / kMetresOfInch)),
      settings_(unlit_on_grey()),
      renderer_(scene_, settings_.transfer) {}

Image<Rgba8> WallPhotographer::photograph(const PinholeCamera& camera, int width, int height) {
  const auto view = view_of(camera, width, height, box_of(scene_));
  if (!view) return Image<Rgba8>(width, height, settings_.background);
  return renderer_.render(*view, settings_).buffers.color;
}

std::vector<SweepRow> sweep_glyphs(SweepVariable what, const FindSettings& settings,
                                   const std::function<void(const std::string&)>& report_progress) {
  if (what == SweepVariable::kRules) return without_rules(settings);
  constexpr int kWidth = 800;
  std::vector<SweepRow> rows;
  const auto add = [&](const std::string& level, const Wall& wall, const std::vector<Photo>& photos,
                       const FindSettings& asked, double least_across = 0) {
    if (report_progress) report_progress(level);
    SweepRow row{level, {}, 0, 0};
    for (const Photo& photo : photos) add_result(row, wall, photo, asked, least_across);
    rows.push_back(row);
  };
  const Wall corner = wall_of_panels(2);
  WallPhotographer photographer(what == SweepVariable::kTilt ? wall_of_panels(1) : corner);
  if (what == SweepVariable::kSize) {
    // The glyphs in a picture have at most the diameter `size`; those of less than 0.8 of it are
    // not counted.
    for (const int size : {10, 12, 15, 20, 25, 30, 40}) {
      const int width = size * 24 / 4 * 4;
      add(fmt::format("{} px", size), corner,
          {take_photo(photographer, -5, width), take_photo(photographer, 5, width)}, settings,
          0.8 * size);
    }
    return rows;
  }
  if (what == SweepVariable::kTilt) {
    const Wall flat = wall_of_panels(1);
    for (const int tilt : {0, 30, 45, 60, 70, 75})
      add(fmt::format("{} degrees", tilt), flat,
          {take_photo(photographer, tilt, kWidth), take_photo(photographer, -tilt, kWidth)},
          settings);
    return rows;
  }
  const std::vector<Photo> photos{take_photo(photographer, -5, kWidth),
                                  take_photo(photographer, 5, kWidth)};
  const auto changed = [&](auto change) {
    std::vector<Photo> result = photos;
    for (Photo& photo : result) change(photo);
    return result;
  };
  if (what == SweepVariable::kBlur || what == SweepVariable::kThreshold) {
    for (const double blur : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0}) {
      const auto blurry =
          changed([&](Photo& photo) { photo.picture = blurred(photo.picture, blur); });
      if (what == SweepVariable::kBlur) {
        add(fmt::format("{} px", blur), corner, blurry, settings);
        continue;
      }
      if (blur != 0 && blur != 1 && blur != 2) continue;
      for (const float threshold : {0.15f, 0.25f, 0.3f, 0.4f, 0.5f, 0.7f, INFINITY}) {
        FindSettings asked = settings;
        asked.threshold = threshold;
        add(fmt::format("T {:.2f}, blur {} px", threshold, blur), corner, blurry, asked);
      }
    }
  }
  if (what == SweepVariable::kOcclusion) {
    for (const double share : {0.0, 0.1, 0.2, 0.3, 0.5}) {
      const auto hidden = changed([&](Photo& photo) {
        OccludedPicture made = occluded(photo.picture, share, 7);
        photo.picture = std::move(made.picture);
        photo.covered = std::move(made.covered);
      });
      add(fmt::format("{:.0f} %", 100 * share), corner, hidden, settings);
    }
  }
  if (what == SweepVariable::kJpeg) {
    for (const int quality : {95, 75, 50, 30, 20, 10}) {
      add(fmt::format("quality {}", quality), corner,
          changed([&](Photo& photo) { photo.picture = apply_jpeg(photo.picture, quality); }),
          settings);
    }
  }
  if (what == SweepVariable::kCamera) {
    for (const auto& [level, sensor] : sensors()) {
      add(level, corner, changed([&, &by = sensor](Photo& photo) {
            photo.picture = apply_sensor(photo.picture, by, 11);
          }),
          settings);
    }
    add("soft, all but bent, JPEG 90", corner, changed([](Photo& photo) {
          const Sensor usual{.falloff = 0.3, .has_mosaic = true, .electrons = 1000};
          photo.picture = apply_jpeg(apply_sensor(blurred(photo.picture, 0.5), usual, 11), 90);
        }),
        settings);
  }
  if (what == SweepVariable::kBalance) {
    for (const double gain : {1.0, 0.8, 0.6, 0.4}) {
      for (const std::array<double, 3> gains :
           {std::array{1.0, gain, gain * gain}, std::array{gain * gain, gain, 1.0}}) {
        const auto tinted =
            changed([&](Photo& photo) { photo.picture = with_gains(photo.picture, gains); });
        for (const bool balances : {true, false}) {
          FindSettings asked = settings;
          asked.balances = balances;
          add(fmt::format("{:.2f}, {:.2f}, {:.2f}{}", gains[0], gains[1], gains[2],
                          balances ? "" : ", as they are"),
              corner, tinted, asked);
        }
        if (gain == 1) break;
      }
    }
  }
  return rows;
}

}  // namespace glassbox::views
