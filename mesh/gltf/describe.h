// Converts parts of a scene to the JSON of a glTF file.
#pragma once

#include <nlohmann/json.hpp>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

nlohmann::json describe(const Sampler& sampler);

// Describes a material. Its reflection model has no exact counterpart in glTF: other programs see a
// rough dielectric, and the numbers in the extras allow Glassbox to restore the material.
nlohmann::json describe(const Material& material);

// Describes a camera. A FrustumLens is an error, because glTF does not have it.
Result<nlohmann::json> describe(const Camera& camera);

nlohmann::json describe(const Light& light);

// The pose of a node at the light's position whose -z axis is exactly the light's direction; the
// other two axes are arbitrary.
glm::dmat4 pose_of(const Light& light);

// Refuses a scene with numbers that are not finite, which JSON would change to null; the error
// names the place.
Result<void> check_finite(const Scene& scene);

}  // namespace glassbox::gltf
