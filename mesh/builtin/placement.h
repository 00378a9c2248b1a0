// The positions of objects in the built-in scenes.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <glassbox/mesh/scene.h>

namespace glassbox {

// The rigid pose of an eye that looks at `target` with y up. The gaze must not be vertical.
Transform<World, Eye> look_at_pose(const Point<World, double>& eye,
                                   const Point<World, double>& target);

// A transform that scales, then rotates about y (degrees, counter-clockwise seen from above), then
// translates.
Transform<World, Object> placement_transform(const std::array<double, 3>& translation,
                                             double turn_degrees = 0,
                                             const std::array<double, 3>& scale = {1, 1, 1});

// The vector scaled to unit length.
Vector<World, double> unit(const Vector<World, double>& v);

// Adds a mesh that is drawn once, at its own node with the same name; returns the mesh's index.
std::uint32_t add_object(Scene& scene, Mesh mesh,
                         const Transform<World, Object>& world_from_object = {});

// Draws a mesh of the scene once more, at a new node.
void add_instance(Scene& scene, std::uint32_t mesh, std::string name,
                  const Transform<World, Object>& world_from_object);

// Adds an opaque matte material; returns its index.
std::uint32_t add_material(Scene& scene, std::string name, const Rgba& color);

// Appends an image and a texture that repeats it; returns the texture's index.
std::uint32_t add_texture(Scene& scene, Image<Rgba8> image);

// Adds a camera with a full vertical angle in degrees and no far plane.
void add_perspective(Scene& scene, std::string name, double fovy_degrees, double near,
                     const Transform<World, Eye>& world_from_eye);

// Adds light that travels along `direction`. pi lux on a white matte surface that faces the light
// give exactly white.
void add_directional(Scene& scene, std::string name, const Vector<World, double>& direction,
                     double lux, const std::array<float, 3>& color = {1, 1, 1});

}  // namespace glassbox
