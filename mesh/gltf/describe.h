// Converts parts of a scene to the JSON of a glTF file.
#pragma once

#include <nlohmann/json.hpp>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

nlohmann::json describe(const Sampler& sampler);

// The reflection model has no exact counterpart in glTF: other programs see a rough dielectric, and
// the numbers in the extras allow Glassbox to restore it.
nlohmann::json describe(const Material& material);

// An error for a FrustumLens, which glTF does not have.
Result<nlohmann::json> describe(const Camera& camera);

nlohmann::json describe(const Light& light);

// A node at the light's position whose -z axis is exactly the light's direction; the other two axes
// are arbitrary.
glm::dmat4 pose_of(const Light& light);

// JSON would change numbers that are not finite to null, so they are an error that names the place.
Result<void> check_finite(const Scene& scene);

}  // namespace glassbox::gltf
