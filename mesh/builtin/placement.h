// Where things stand in the built-in scenes.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <glassbox/mesh/scene.h>

namespace glassbox {

// The rigid pose of an eye that looks at `target` with y up. The gaze must not be vertical.
Transform<World, Eye> look_at_pose(const Point<World, double>& eye,
                                   const Point<World, double>& target);

// Translation after rotation about y (degrees, counter-clockwise seen from above) after scaling.
Transform<World, Object> place(const std::array<double, 3>& translation, double turn_degrees = 0,
                               const std::array<double, 3>& scale = {1, 1, 1});

// Unit length.
Vector<World, double> unit(const Vector<World, double>& v);

// Adds a mesh that is drawn once, at a node of its own with the same name; returns the mesh's index.
std::uint32_t add_object(Scene& scene, Mesh mesh,
                         const Transform<World, Object>& world_from_object = {});

// Draws a mesh of the scene once more.
void add_instance(Scene& scene, std::uint32_t mesh, std::string name,
                  const Transform<World, Object>& world_from_object);

// An opaque matte material; returns its index.
std::uint32_t add_material(Scene& scene, std::string name, const Rgba& color);

// Appends an image and a texture that repeats it; returns the texture's index.
std::uint32_t add_texture(Scene& scene, Image<Rgba8> image);

// Full vertical angle in degrees; no far plane.
void add_perspective(Scene& scene, std::string name, double fovy_degrees, double near,
                     const Transform<World, Eye>& world_from_eye);

// Light that travels along `direction`. pi lux on a white matte surface that faces it are exactly white.
void add_directional(Scene& scene, std::string name, const Vector<World, double>& direction,
                     double lux, const std::array<float, 3>& color = {1, 1, 1});

}  // namespace glassbox
