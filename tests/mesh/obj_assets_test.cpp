// Real OBJ files, whose contents are compared with what tinyobjloader reads from them.
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <glassbox/mesh/obj/load.h>

#include "tests/support/catch.h"
#include "tests/support/skip.h"

namespace glassbox {
namespace {

namespace fs = std::filesystem;

struct Listed {
  std::string path, counts, verdict;
};

const std::string kManifest = GLASSBOX_ASSETS_DIR "/MANIFEST.tsv";

// The OBJ files of the manifest whose paths begin with a prefix.
std::vector<Listed> listed(const std::string& prefix) {
  std::vector<Listed> files;
  std::ifstream manifest(kManifest);
  for (std::string line; std::getline(manifest, line);) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
    if (fields.size() >= 7 && fields[0].starts_with(prefix) && fields[0].ends_with(".obj")) {
      files.push_back({fields[0], fields[2], fields[6]});
    }
  }
  REQUIRE_FALSE(files.empty());
  return files;
}

std::string full_path(const Listed& file) {
  return (fs::path(GLASSBOX_ASSETS_DIR) / file.path).string();
}

// The number of triangles after triangulation if no face is degenerate.
std::size_t triangles(const Scene& scene) {
  std::size_t count = 0;
  for (const Mesh& mesh : scene.meshes) {
    for (const Face& face : mesh.faces) count += face.count - 2;
  }
  return count;
}

// A corner as numbers, so that scenes that are arranged differently can be compared as sorted
// lists.
using CornerValues = std::array<float, 8>;
using FaceValues = std::vector<CornerValues>;

// `with_normals` is false for files that have none: smoothing groups then make some.
std::vector<FaceValues> faces_of(const Scene& scene, bool with_normals) {
  std::vector<FaceValues> faces;
  for (const Mesh& mesh : scene.meshes) {
    for (const Face& face : mesh.faces) {
      FaceValues& values = faces.emplace_back();
      for (std::uint32_t i = face.first; i < face.first + face.count; ++i) {
        const Corner& c = mesh.corners[i];
        const auto& p = mesh.positions[c.position];
        const bool has_normal = with_normals && c.normal != kNone;
        const Normal<Object> n = has_normal ? mesh.normals[c.normal] : Normal<Object>();
        const TexCoord t = c.texcoord == kNone ? TexCoord{0, 1} : mesh.texcoords[c.texcoord];
        values.push_back({p.x, p.y, p.z, n.x, n.y, n.z, t.u, 1 - t.v});
      }
    }
  }
  return faces;
}

std::vector<FaceValues> faces_of(const tinyobj::attrib_t& attributes,
                                 const std::vector<tinyobj::shape_t>& shapes) {
  std::vector<FaceValues> faces;
  for (const tinyobj::shape_t& shape : shapes) {
    std::size_t next = 0;
    for (const std::size_t count : shape.mesh.num_face_vertices) {
      FaceValues& values = faces.emplace_back();
      for (std::size_t i = 0; i < count; ++i) {
        const tinyobj::index_t index = shape.mesh.indices[next++];
        const float* const p = &attributes.vertices[3 * std::size_t(index.vertex_index)];
        CornerValues corner{p[0], p[1], p[2], 0, 0, 0, 0, 0};
        // tinyobjloader does not check indices against the tables.
        const auto in = [](int i, const std::vector<float>& table, std::size_t width) {
          return i >= 0 && std::size_t(i) < table.size() / width;
        };
        if (in(index.normal_index, attributes.normals, 3)) {
          const float* const n = &attributes.normals[3 * std::size_t(index.normal_index)];
          const double x = n[0], y = n[1], z = n[2];
          const double length = std::sqrt(x * x + y * y + z * z);
          if (length > 0) {
            corner[3] = float(x / length);
            corner[4] = float(y / length);
            corner[5] = float(z / length);
          }
        }
        if (in(index.texcoord_index, attributes.texcoords, 2)) {
          const float* const t = &attributes.texcoords[2 * std::size_t(index.texcoord_index)];
          corner[6] = t[0];
          corner[7] = t[1];
        }
        values.push_back(corner);
      }
    }
  }
  return faces;
}

// tinyobjloader sums decimal digits in double, with an error of about 2^-50 of the number, so a
// position or texture coordinate may be rounded to the float next to the nearest: one ulp, 2^-23 of
// the number (2^-149 near zero). The components of a normal may each move by that and are then
// divided by the rounded length: 4 ulps of a number up to 1. Flipping v and flipping it back rounds
// it by at most 2^-23 of max(1, |v|).
bool same(const CornerValues& a, const CornerValues& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double size =
        i < 3 || i == 6 ? std::abs(double(a[i])) : std::max(1.0, std::abs(double(a[i])));
    const double ulps = i < 3 || i == 6 ? 1 : 4;
    if (std::abs(double(a[i]) - double(b[i])) > ulps * 0x1p-23 * size + 0x1p-149) return false;
  }
  return true;
}

bool same_faces(const std::vector<FaceValues>& a, const std::vector<FaceValues>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return std::equal(x.begin(), x.end(), y.begin(), y.end(), same);
  });
}

}  // namespace

TEST_CASE("OBJ real files: each loads with the triangles that the manifest lists") {
  if (!fs::exists(kManifest)) SKIP_TEST("no assets at " << kManifest);
  for (const Listed& file : listed("meshes/obj/")) {
    const auto scene = load_obj(full_path(file));
    INFO(file.path << " (" << file.verdict
                   << "): " << (scene ? std::string("loaded") : scene.error().message()));
    if (!file.verdict.starts_with("render")) continue;
    REQUIRE(scene);
    // The manifest counted words in this file's comments as corners.
    const bool commented = file.path.ends_with("cube_with_materials_comments.obj");
    const std::string counts = commented ? "12" : file.counts;
    CHECK(triangles(*scene) == std::size_t(std::atoll(counts.c_str())));
    for (const std::string& warning : scene->warnings) {
      CHECK(warning.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("OBJ hostile files: each gets the manifest's verdict") {
  if (!fs::exists(kManifest)) SKIP_TEST("no assets at " << kManifest);
  for (const Listed& file : listed("malformed/")) {
    const auto scene = load_obj(full_path(file));
    INFO(file.path << " (" << file.verdict
                   << "): " << (scene ? std::string("loaded") : scene.error().message()));
    if (file.verdict == "accept") {
      REQUIRE(scene);
      CHECK(triangles(*scene) == std::size_t(std::atoll(file.counts.c_str())));
    }
    if (file.verdict == "reject") CHECK_FALSE(scene);
  }
}

TEST_CASE("OBJ real files: faces are those that tinyobjloader finds") {
  if (!fs::exists(kManifest)) SKIP_TEST("no assets at " << kManifest);
  const std::vector<Listed> files = listed("meshes/obj/");
  std::size_t compared = 0;
  for (const Listed& file : files) {
    const auto scene = load_obj(full_path(file));
    if (!scene) continue;
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    const std::string directory = fs::path(full_path(file)).parent_path().string();
    // Read without triangulation and without colours. tinyobjloader does not read comments after a
    // statement: it refuses such files, or gives corners of index 0.
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error,
                          full_path(file).c_str(), directory.c_str(), false, false)) {
      continue;
    }
    auto ours = faces_of(*scene, !attributes.normals.empty());
    auto theirs = faces_of(attributes, shapes);
    std::sort(ours.begin(), ours.end());
    std::sort(theirs.begin(), theirs.end());
    INFO(file.path << ": " << ours.size() << " and " << theirs.size() << " faces");
    CHECK(same_faces(ours, theirs));
    ++compared;
  }
  // All but the few files that one of the two loaders refuses.
  CHECK(compared >= files.size() - files.size() / 10);
}

TEST_CASE("OBJ real files: textures and materials arrive") {
  const fs::path folder = fs::path(GLASSBOX_ASSETS_DIR) / "meshes/obj";
  if (!fs::exists(folder)) SKIP_TEST("no assets at " << folder.string());
  const auto spider = load_obj((folder / "assimp/spider.obj").string());
  REQUIRE(spider);
  // The file defines five materials and uses four.
  CHECK(spider->materials.size() == 4);
  CHECK(spider->images.size() == 4);
  CHECK(spider->materials[0].texture);
  const auto blanks = load_obj((folder / "o3dv/cube with white spaces.obj").string());
  REQUIRE(blanks);
  CHECK(blanks->materials.size() == 5);
  CHECK(blanks->images.size() == 1);
  CHECK(blanks->warnings.empty());
  const auto colors = load_obj((folder / "assimp/cube_with_vertexcolors.obj").string());
  REQUIRE(colors);
  CHECK(colors->meshes[0].colors.size() == 8);
}

}  // namespace glassbox
