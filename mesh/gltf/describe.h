// Parts of a scene as the JSON of a glTF file.
#pragma once

#include <nlohmann/json.hpp>

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

nlohmann::json describe(const Sampler& sampler);

// The reflection model has no exact counterpart in glTF: other programs see a rough dielectric, and the extras bring the
// numbers back.
nlohmann::json describe(const Material& material);

// An error for a FrustumLens, which glTF does not have.
Result<nlohmann::json> describe(const Camera& camera);

nlohmann::json describe(const Light& light);

// A node at the light's position whose -z axis is its direction, bit by bit; the other axes are any that complete it.
glm::dmat4 pose_of(const Light& light);

// JSON would turn numbers that are not finite into null: an error names where they stand.
Result<void> check_finite(const Scene& scene);

}  // namespace glassbox::gltf
