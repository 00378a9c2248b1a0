// Chooses a camera for a scene that has none, and near and far planes for a pose that has none.
#pragma once

#include <glassbox/base/box.h>
#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox {

struct FramingOptions {
  // The direction of the eye seen from the box, as an angle from the +z axis towards +x.
  double azimuth_degrees = 30;
  // The angle above the plane that `up` is perpendicular to; strictly between -90 and 90.
  double elevation_degrees = 20;
  // The direction that is up in the picture, of any length. The axes of azimuth and elevation are
  // rotated with it, by the shortest rotation from y: with z up the azimuth is from -y towards +x.
  // For `up` = -y the rotation is a half turn about x.
  Vector<World, double> up{0, 1, 0};
  double fovy_degrees = 45;  // full vertical angle
  double margin = 1.1;       // size of the picture divided by the size of the box in it; >= 1
};

// A perspective camera that sees all of the box, or all that the scene draws, from as near as the
// margin allows, in an image of `aspect` = width / height. The box is in the middle of the picture.
// A box without extent is framed as a cube of side 1 (or of 2^-19 of its distance from the origin
// if that is more). Errors: nothing to see, bounds that are not finite, an aspect that is not
// positive, an `up` that has no direction.
Result<Camera> framing_camera(const Box<World>& bounds, double aspect,
                              const FramingOptions& options = {});
Result<Camera> framing_camera(const Scene& scene, double aspect,
                              const FramingOptions& options = {});

struct NearFar {
  double near = 0.1, far = 100;  // world units along the gaze
};

// Planes that enclose the box seen from a pose, with 1 % to spare on either side. The near plane is
// at least far/kMaxDepthRatio, so anything nearer to the eye than that is cut off: an eye inside
// the box still gets a usable depth buffer. For a box wholly behind the eye, the planes have the
// scale of the box (there is nothing to see). Errors: an empty or non-finite box or pose.
inline constexpr double kMaxDepthRatio = 10000;
Result<NearFar> near_far_for(const Transform<World, Eye>& world_from_eye, const Box<World>& bounds);

// Near and far planes for a parallel projection, whose near plane may be behind the eye: the range
// of the box's depths and 1 % of its extent on either side.
Result<NearFar> parallel_near_far_for(const Transform<World, Eye>& world_from_eye,
                                      const Box<World>& bounds);

}  // namespace glassbox
