// The methods to transform a vertex from object space to the screen (D-1).
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include <glassbox/pipeline/divide.h>

#include "study/experiments/d01_scenes.h"

namespace glassbox::study {

// Each method takes vertices in its own number format, Input, and returns x, y, z and 1/w in that
// format. pixels() returns x and y as doubles, depth() returns z.
using Pixels = std::array<double, 2>;

// ---- float: the pipeline's own stages ----

class FloatMethod {
public:
  using Input = Point<Object>;
  static Input input(const Point<Object, double>& p) {
    return {float(p.x), float(p.y), float(p.z)};
  }
  static Pixels pixels(const ScreenVertex& v) { return {v.position.x, v.position.y}; }
  static double depth(const ScreenVertex& v) { return double(v.position.z); }
};

class ThreeMatrices : public FloatMethod {
public:
  ThreeMatrices(const Transform<World, Object>& world_from_object,
                const Transform<Eye, World>& eye_from_world,
                const Transform<Clip, Eye>& clip_from_eye)
      : world_from_object_(round_to_float(world_from_object)),
        eye_from_world_(round_to_float(eye_from_world)),
        clip_from_eye_(round_to_float(clip_from_eye)) {}
  ScreenVertex operator()(const Point<Object>& p) const {
    return to_screen(divide(clip_from_eye_ * (eye_from_world_ * (world_from_object_ * p))),
                     vertex_scene_viewport());
  }

private:
  Transform<World, Object, float> world_from_object_;
  Transform<Eye, World, float> eye_from_world_;
  Transform<Clip, Eye, float> clip_from_eye_;
};

// Applies the three matrices (model, view, projection) one after the other; each is rounded to
// float.
class FloatStages : public ThreeMatrices {
public:
  explicit FloatStages(const VertexScene& scene)
      : ThreeMatrices(placed<World, Object>(scene.world_from_object, scene.object), view_of(scene),
                      projection_of(scene)) {}
};

// Moves the origin of the world to the eye before the matrices are rounded to float: the eye is
// subtracted in double, where the difference of two near numbers is exact.
class CameraRelative : public ThreeMatrices {
public:
  explicit CameraRelative(const VertexScene& scene)
      : ThreeMatrices(placed<World, Object>(scene.world_from_object, scene.object - scene.eye),
                      placed<Eye, World>(scene.eye_from_world, {0, 0, 0}), projection_of(scene)) {}
};

inline Transform<Clip, Object> composed(const VertexScene& scene) {
  return projection_of(scene) * view_of(scene) *
         placed<World, Object>(scene.world_from_object, scene.object);
}

// Multiplies the three matrices in double and rounds the product to float once, as the command
// `render` does.
class ComposedOnce : public FloatMethod {
public:
  explicit ComposedOnce(const VertexScene& scene)
      : clip_from_object_(round_to_float(composed(scene))) {}
  ScreenVertex operator()(const Point<Object>& p) const {
    return to_screen(divide(clip_from_object_ * p), vertex_scene_viewport());
  }

private:
  Transform<Clip, Object, float> clip_from_object_;
};

// ---- double ----

class DoubleStages {
public:
  using Input = Point<Object, double>;
  struct Output {
    double x, y, z, inverse_w;
  };

  explicit DoubleStages(const VertexScene& scene) : clip_from_object_(composed(scene)) {}
  static Input input(const Point<Object, double>& p) { return p; }
  static Pixels pixels(const Output& v) { return {v.x, v.y}; }
  static double depth(const Output& v) { return v.z; }
  Output operator()(const Input& p) const {
    const Point<Clip, double> clip = clip_from_object_ * p;
    return {clip.x / clip.w * (kVertexSceneWidth / 2.0) + kVertexSceneWidth / 2.0,
            clip.y / clip.w * (-kVertexSceneHeight / 2.0) + kVertexSceneHeight / 2.0,
            clip.z / clip.w, 1 / clip.w};
  }

private:
  Transform<Clip, Object> clip_from_object_;
};

// ---- fixed point ----

// Uses 64-bit integers in units of 2^-32, with products and quotients in 128 bits. World positions
// are stored in this form, and the eye is subtracted before the camera's rotation. This method
// returns no depth z, only 1/w in steps of 2^-32.
class Fixed32 {
public:
  using Input = std::array<std::int64_t, 3>;
  struct Output {
    std::int64_t x, y, inverse_w;
  };

  explicit Fixed32(const VertexScene& scene)
      : world_from_object_(fixed(rounded(scene.world_from_object))),
        eye_from_world_(fixed(rounded(scene.eye_from_world))),
        object_(fixed(to_glm(scene.object))),
        eye_(fixed(to_glm(scene.eye))) {}

  static Input input(const Point<Object, double>& p) { return fixed(glm::dvec3(to_glm(p))); }
  static Pixels pixels(const Output& v) { return {double(v.x) / kOne, double(v.y) / kOne}; }

  Output operator()(const Input& p) const {
    Input world = times(world_from_object_, p);
    for (std::size_t i = 0; i < 3; ++i) world[i] = (world[i] + object_[i]) - eye_[i];
    const Input eye = times(eye_from_world_, world);
    // The focal length and the middle of the picture are whole numbers of pixels, so they are not
    // rounded.
    const auto pixels_from_middle = [&](std::int64_t across) {
      return std::int64_t(Wide(across) * Wide(kVertexSceneFocal) * kOne / -eye[2]);
    };
    return {pixels_from_middle(eye[0]) + kVertexSceneWidth / 2 * kOne,
            pixels_from_middle(-eye[1]) + kVertexSceneHeight / 2 * kOne,
            std::int64_t(Wide(kOne) * kOne / -eye[2])};
  }

private:
  __extension__ using Wide = __int128;
  using Rows = std::array<Input, 3>;
  static constexpr std::int64_t kOne = std::int64_t(1) << 32;

  static Input fixed(const glm::dvec3& v) {
    const auto one = [](double x) { return std::int64_t(std::floor(x * double(kOne) + 0.5)); };
    return {one(v.x), one(v.y), one(v.z)};
  }
  static Rows fixed(const glm::dmat3& m) {
    const glm::dmat3 rows = glm::transpose(m);
    return {fixed(rows[0]), fixed(rows[1]), fixed(rows[2])};
  }
  static Input times(const Rows& m, const Input& v) {
    Input product;
    for (std::size_t i = 0; i < 3; ++i) {
      const Wide sum = Wide(m[i][0]) * v[0] + Wide(m[i][1]) * v[1] + Wide(m[i][2]) * v[2];
      product[i] = std::int64_t((sum + kOne / 2) >> 32);
    }
    return product;
  }

  Rows world_from_object_, eye_from_world_;
  Input object_, eye_;
};

}  // namespace glassbox::study
