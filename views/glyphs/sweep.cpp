#include "views/glyphs/sweep.h"

#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <glassbox/base/trig.h>

#include "views/glyphs/decoys.h"
#include "views/glyphs/photograph.h"
#include "views/glyphs/sensor.h"
#include "views/rings/ring.h"

namespace glassbox::views {

namespace {

struct Shot {
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

Shot shot_in(Studio& studio, double azimuth, int width) {
  const int height = width * 3 / 4;
  Shot shot{camera_before(kDistance, azimuth, 5, width, height), {}, {}};
  shot.picture = studio.photograph(shot.camera, width, height);
  return shot;
}

constexpr double kDpi = 50;

RenderSettings unlit_on_grey() {
  RenderSettings settings;
  settings.shading = Shading::kUnlit;
  settings.samples = 4;
  settings.background = {128, 128, 128, 255};
  return settings;
}

// Each sensor changes one thing; one combines two.
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
    all.emplace_back(fmt::format("bent by {}", bend), Sensor{.bend = bend});
  return all;
}

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

void judge(SweepRow& row, const Wall& wall, const Shot& shot, const FindSettings& settings,
           double least_across) {
  const int width = shot.picture.width, height = shot.picture.height;
  const FoundGlyphs found = find_glyphs(shot.picture, settings, wall.identities());
  auto visible = visible_glyphs(wall, shot.camera, width, height, shot.covered);
  std::erase_if(visible, [&](const VisibleGlyph& glyph) { return glyph.shorter < least_across; });
  const GlyphScore score = score_of(found, wall, shot.camera, visible);
  row.score.visible += score.visible;
  row.score.right += score.right;
  row.score.wrong += score.wrong;
  row.score.partly += score.partly;
  PoseQuestion question;
  question.known = LensKnown::kAll;
  question.intrinsic = shot.camera.intrinsic;
  const auto pose = find_pose(points_of(found, wall).points, question);
  const PoseError error = pose ? pose_error(pose->camera, shot.camera) : PoseError{kNan, kNan};
  // If one shot has no pose (nan), the worst error stays nan.
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
    rows.push_back({level, {score.glyphs, score.found, score.all_taken(), 0}, kNan, kNan});
  };
  add("all", settings);
  for (int rule = 0; rule < kGlyphRules; ++rule) {
    FindSettings some = settings;
    some.asks[std::size_t(rule)] = false;
    add("without " + std::string(name_of(GlyphRule(rule))), some);
  }
  return rows;
}

}  // namespace

std::string_view name_of(SweepOf what) {
  switch (what) {
    case SweepOf::kSize:
      return "size";
    case SweepOf::kBlur:
      return "blur";
    case SweepOf::kOcclusion:
      return "occlusion";
    case SweepOf::kTilt:
      return "tilt";
    case SweepOf::kJpeg:
      return "jpeg";
    case SweepOf::kBalance:
      return "balance";
    case SweepOf::kCamera:
      return "camera";
    case SweepOf::kThreshold:
      return "threshold";
    case SweepOf::kRules:
      return "rules";
  }
  return "";
}

PinholeCamera camera_before(double distance, double azimuth_degrees, double elevation_degrees,
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

Studio::Studio(const Wall& wall)
    : scene_(wall_scene(wall, kDpi / kMetresOfInch)),
      settings_(unlit_on_grey()),
      renderer_(scene_, settings_.transfer) {}

Image<Rgba8> Studio::photograph(const PinholeCamera& camera, int width, int height) {
  const auto view = view_of(camera, width, height, box_of(scene_));
  if (!view) return Image<Rgba8>(width, height, settings_.background);
  return renderer_.render(*view, settings_).buffers.color;
}

std::vector<SweepRow> sweep_glyphs(SweepOf what, const FindSettings& settings,
                                   const std::function<void(const std::string&)>& tell) {
  if (what == SweepOf::kRules) return without_rules(settings);
  constexpr int kWidth = 800;
  std::vector<SweepRow> rows;
  const auto add = [&](const std::string& level, const Wall& wall, const std::vector<Shot>& shots,
                       const FindSettings& asked, double least_across = 0) {
    if (tell) tell(level);
    SweepRow row{level, {}, 0, 0};
    for (const Shot& shot : shots) judge(row, wall, shot, asked, least_across);
    rows.push_back(row);
  };
  const Wall corner = wall_of_panels(2);
  Studio studio(what == SweepOf::kTilt ? wall_of_panels(1) : corner);
  if (what == SweepOf::kSize) {
    // Glyphs have at most this diameter; those from 0.8 of it on are counted.
    for (const int size : {10, 12, 15, 20, 25, 30, 40}) {
      const int width = size * 24 / 4 * 4;
      add(fmt::format("{} px", size), corner,
          {shot_in(studio, -5, width), shot_in(studio, 5, width)}, settings, 0.8 * size);
    }
    return rows;
  }
  if (what == SweepOf::kTilt) {
    const Wall flat = wall_of_panels(1);
    for (const int tilt : {0, 30, 45, 60, 70, 75})
      add(fmt::format("{} degrees", tilt), flat,
          {shot_in(studio, tilt, kWidth), shot_in(studio, -tilt, kWidth)}, settings);
    return rows;
  }
  const std::vector<Shot> shots{shot_in(studio, -5, kWidth), shot_in(studio, 5, kWidth)};
  const auto changed = [&](auto change) {
    std::vector<Shot> result = shots;
    for (Shot& shot : result) change(shot);
    return result;
  };
  if (what == SweepOf::kBlur || what == SweepOf::kThreshold) {
    for (const double blur : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0}) {
      const auto blurry = changed([&](Shot& shot) { shot.picture = blurred(shot.picture, blur); });
      if (what == SweepOf::kBlur) {
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
  if (what == SweepOf::kOcclusion) {
    for (const double share : {0.0, 0.1, 0.2, 0.3, 0.5}) {
      const auto hidden = changed([&](Shot& shot) {
        OccludedPicture made = occluded(shot.picture, share, 7);
        shot.picture = std::move(made.picture);
        shot.covered = std::move(made.covered);
      });
      add(fmt::format("{:.0f} %", 100 * share), corner, hidden, settings);
    }
  }
  if (what == SweepOf::kJpeg) {
    for (const int quality : {95, 75, 50, 30, 20, 10}) {
      add(fmt::format("quality {}", quality), corner,
          changed([&](Shot& shot) { shot.picture = through_jpeg(shot.picture, quality); }),
          settings);
    }
  }
  if (what == SweepOf::kCamera) {
    for (const auto& [level, sensor] : sensors()) {
      add(level, corner, changed([&, &by = sensor](Shot& shot) {
            shot.picture = through_sensor(shot.picture, by, 11);
          }),
          settings);
    }
    add("soft, all but bent, JPEG 90", corner, changed([](Shot& shot) {
          const Sensor usual{.falloff = 0.3, .has_mosaic = true, .electrons = 1000};
          shot.picture = through_jpeg(through_sensor(blurred(shot.picture, 0.5), usual, 11), 90);
        }),
        settings);
  }
  if (what == SweepOf::kBalance) {
    for (const double gain : {1.0, 0.8, 0.6, 0.4}) {
      for (const std::array<double, 3> gains :
           {std::array{1.0, gain, gain * gain}, std::array{gain * gain, gain, 1.0}}) {
        const auto tinted =
            changed([&](Shot& shot) { shot.picture = with_gains(shot.picture, gains); });
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
