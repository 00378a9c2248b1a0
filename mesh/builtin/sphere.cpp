#include <glassbox/mesh/builtin/sphere.h>

#include <glassbox/base/trig.h>
#include <glassbox/mesh/builtin/placement.h>
#include <glassbox/mesh/builtin/shapes.h>

namespace glassbox {
namespace {

// A point has the same index in the tables of positions and normals: the poles come first, then the
// circles of latitude from north to south. Texture coordinates form a separate grid, because the
// first and the last meridian coincide but have u = 0 and u = 1.
class Ball {
public:
  explicit Ball(int level) : stacks_(level), slices_(2 * level) {
    mesh_.name = "sphere";
    add_point(0, 1, 0);
    add_point(0, -1, 0);
    for (int stack = 1; stack < stacks_; ++stack) {
      const SinCos polar = sin_cos_degrees(180.0 * stack / stacks_);
      for (int slice = 0; slice < slices_; ++slice) {
        const SinCos turn = sin_cos_degrees(360.0 * slice / slices_);
        add_point(polar.sin * -turn.sin, polar.cos, polar.sin * -turn.cos);
      }
    }
    for (int stack = 0; stack <= stacks_; ++stack) {
      for (int slice = 0; slice <= 2 * slices_; ++slice) {
        add_texcoord(mesh_, slice / (2.0 * slices_), double(stack) / stacks_);
      }
    }
  }

  Mesh run() {
    for (int slice = 0; slice < slices_; ++slice) {
      const std::array<Corner, 3> north = {pole(0, slice), corner(1, slice), corner(1, slice + 1)};
      add_face(mesh_, north);
    }
    for (int stack = 1; stack < stacks_ - 1; ++stack) {
      for (int slice = 0; slice < slices_; ++slice) {
        const std::array<Corner, 4> quad = {corner(stack, slice), corner(stack + 1, slice),
                                            corner(stack + 1, slice + 1), corner(stack, slice + 1)};
        add_face(mesh_, quad);
      }
    }
    for (int slice = 0; slice < slices_; ++slice) {
      const std::array<Corner, 3> south = {pole(stacks_, slice), corner(stacks_ - 1, slice + 1),
                                           corner(stacks_ - 1, slice)};
      add_face(mesh_, south);
    }
    return std::move(mesh_);
  }

private:
  void add_point(double x, double y, double z) {
    add_position(mesh_, x, y, z);
    add_normal(mesh_, {x, y, z});
  }

  Corner corner(int stack, int slice) const {
    const auto point = std::uint32_t(2 + (stack - 1) * slices_ + slice % slices_);
    return {point, point, texcoord(stack, 2 * slice), kNone};
  }
  // The corner at a pole; its u is that of the middle of the slice.
  Corner pole(int stack, int slice) const {
    const std::uint32_t point = stack == 0 ? 0 : 1;
    return {point, point, texcoord(stack, 2 * slice + 1), kNone};
  }
  std::uint32_t texcoord(int stack, int half_slice) const {
    return std::uint32_t(stack * (2 * slices_ + 1) + half_slice);
  }

  int stacks_, slices_;
  Mesh mesh_;
};

}  // namespace

Scene make_sphere(int level) {
  Scene scene;
  scene.name = "sphere";
  const std::uint32_t material = add_material(scene, "plastic", {0.08f, 0.25f, 0.55f, 1});
  scene.materials[material].specular = {0.35f, 0.35f, 0.35f};
  scene.materials[material].shininess = 48;
  Mesh mesh = Ball(level).run();
  mesh.material = material;
  add_object(scene, std::move(mesh));
  add_directional(scene, "key", {-1, -1, -1}, 2.8);
  return scene;
}

}  // namespace glassbox
