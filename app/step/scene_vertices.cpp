#include "app/step/scene_vertices.h"

#include <charconv>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/arguments.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/rounding.h>

namespace glassbox::app {

namespace {

// Where a vertex of the scene is: which instance, and which position of its mesh.
struct VertexPlace {
  std::size_t instance = 0;
  std::size_t position = 0;
};

Result<VertexPlace> find_vertex(const Scene& scene, std::uint32_t number) {
  std::size_t before = 0;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const std::size_t count = scene.meshes[scene.instances[i].mesh].positions.size();
    if (number - before < count) return VertexPlace{i, number - before};
    before += count;
  }
  return fail(fmt::format("--vertices {}", number),
              "the scene has " + counted(before, "vertex", "vertices"),
              before == 0 ? "name a scene with a mesh"
                          : fmt::format("give numbers from 0 to {}", before - 1));
}

}  // namespace

Result<SceneVertices> vertices_of(const Scene& scene, const std::vector<std::uint32_t>& numbers) {
  SceneVertices found;
  std::optional<std::size_t> instance;
  for (const std::uint32_t number : numbers) {
    const auto place = find_vertex(scene, number);
    if (!place) return tl::unexpected(place.error());
    if (instance && *instance != place->instance) {
      return fail("--vertices",
                  fmt::format("vertex {} is of instance {}, and those before it are of instance {}",
                              number, place->instance, *instance),
                  "give vertices of one instance, because each has its own model matrix");
    }
    instance = place->instance;
    const Instance& of = scene.instances[place->instance];
    const auto& p = scene.meshes[of.mesh].positions[place->position];
    const glm::dvec4 position(p.x, p.y, p.z, 1);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      return fail(fmt::format("--vertices {}", number), "its position is not finite",
                  "choose another vertex");
    }
    found.vertices.push_back({position, double(unit_roundoff<float>) * glm::abs(position), 0});
    found.world_from_object = scene.nodes[of.node].world_from_node.columns;
    found.node = scene.nodes[of.node].name;
  }
  return found;
}

std::vector<std::uint32_t> parse_vertex_numbers(const std::string& option,
                                                const std::string& text) {
  std::vector<std::uint32_t> numbers;
  for (const std::string& word : split(text, ',')) {
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc{} || end != word.data() + word.size()) {
      throw CLI::ValidationError(option, "needs numbers such as 0,5,7, not '" + text + "'");
    }
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace glassbox::app
