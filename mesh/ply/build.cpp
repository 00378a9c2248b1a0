#include <glassbox/mesh/ply/build.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <span>
#include <utility>

#include <glassbox/base/counted.h>
#include <glassbox/mesh/ply/colors.h>
#include <glassbox/mesh/ply/property_indices.h>
#include <glassbox/mesh/ply/values.h>

namespace glassbox::ply {
namespace {

struct UnreadablePosition {
  std::uint32_t index;  // of the vertex
  char axis;
  const char* what;
  std::string place;  // in the file
};

class Builder {
public:
  Builder(std::string_view file, const Header& header, const LoadLimits& limits,
          obj::Warnings& warnings)
      : header_(header), limits_(limits), warnings_(warnings), values_(file, header) {}

  Result<PlyMesh> run() {
    if (auto done = check_elements(); !done) return tl::unexpected(done.error());
    for (const Element& element : header_.elements) {
      auto done = element.name == "vertex"      ? read_vertices(element)
                  : element.name == "face"      ? read_faces(element)
                  : element.name == "tristrips" ? read_strips(element)
                                                : read_over(element);
      if (!done) return tl::unexpected(done.error());
    }
    if (built_.mesh.faces.empty()) {
      return fail("data", "no face or strip has three corners or more", "export the file again");
    }
    if (auto done = settle_unreadable_positions(); !done) return tl::unexpected(done.error());
    complete_corners();
    report();
    return std::move(built_);
  }

private:
  Result<void> check_elements() const {
    const Element* vertices = header_.find("vertex");
    const auto has = [&](std::string_view name) {
      const Element* element = header_.find(name);
      return element != nullptr && element->count > 0;
    };
    if (vertices == nullptr || vertices->count == 0) {
      return fail("header", "there are no vertices", "choose a file with a mesh");
    }
    for (const PropertyIndex& index : VertexPropertyIndices(*vertices).position) {
      if (!index) {
        return fail("element 'vertex'", "has no numbers x, y and z", "export the file again");
      }
    }
    if (has("face") || has("tristrips")) return {};
    return fail("header",
                "has " + counted(vertices->count, "vertex", "vertices") +
                    " and no faces: a point cloud, which has no surface to draw",
                "make a surface from the points first, for example with MeshLab or CloudCompare");
  }

  // ---- rows ----

  tl::unexpected<Error> refuse(const char* of, std::uint64_t index, std::string cause,
                               std::string remedy) const {
    return fail(
        std::string(of) + " " + std::to_string(index) + " (" + values_.position_text() + ")",
        std::move(cause), std::move(remedy));
  }

  // Reads the numbers of one element. row_ gets one number for each property (for a list, its
  // length); lists_ gets the values of the lists.
  bool read_row(const Element& element) {
    row_.resize(element.properties.size());
    lists_.resize(element.properties.size());
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const Property& property = element.properties[i];
      if (!values_.next(property.count_type.value_or(property.type), row_[i])) {
        problem_ = values_.problem();
        return false;
      }
      if (property.count_type && !read_list(property, row_[i], lists_[i])) return false;
    }
    return true;
  }

  bool read_list(const Property& property, double count, std::vector<double>& list) {
    if (count < 0 || !values_.has_room_for(std::uint64_t(count), property.type)) {
      problem_ = "its list " + in_quotes(property.name) + " has " +
                 std::to_string(std::int64_t(count)) + " entries, which the file does not hold";
      return false;
    }
    list.resize(std::size_t(count));
    for (double& number : list) {
      if (!values_.next(property.type, number)) {
        problem_ = values_.problem();
        return false;
      }
    }
    return true;
  }

  Result<void> read_over(const Element& element) {
    if (element.count == 0) return {};
    not_drawn("elements", element.name + " (" + std::to_string(element.count) + ")");
    for (std::uint64_t i = 0; i < element.count && !element.properties.empty(); ++i) {
      if (!read_row(element)) {
        return refuse(printable(element.name).c_str(), i, problem_, "export the file again");
      }
    }
    return {};
  }

  // ---- vertices ----

  Result<void> read_vertices(const Element& element) {
    const VertexPropertyIndices indices(element);
    warn_about_unread(
        element, "vertex properties",
        {indices.position[0], indices.position[1], indices.position[2], indices.normal[0],
         indices.normal[1], indices.normal[2], indices.texcoord[0], indices.texcoord[1],
         indices.color.red, indices.color.green, indices.color.blue, indices.color.alpha});
    built_.mesh.positions.reserve(element.count);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_row(element)) return refuse("vertex", i, problem_, "export the file again");
      add_position(indices, i);
      if (indices.has_normals()) add_normal(indices, i);
      if (indices.has_texcoords())
        add_texcoord(row_[*indices.texcoord[0]], row_[*indices.texcoord[1]], i);
      if (indices.color.complete()) vertex_colors_.add(element, indices.color, row_);
    }
    return {};
  }

  // Takes a position that is not finite as the origin until it is known whether a face uses it.
  void add_position(const VertexPropertyIndices& indices, std::uint64_t index) {
    std::array<float, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double number = row_[*indices.position[k]];
      p[k] = float(number);
      if (std::isfinite(p[k])) continue;
      const char* what = std::isnan(number)   ? "not a number (NaN)"
                         : std::isinf(number) ? "infinite"
                                              : "beyond what a float can hold";
      unreadable_.push_back({std::uint32_t(index), "xyz"[k], what, values_.position_text()});
      p = {};
      break;
    }
    built_.mesh.positions.push_back({p[0], p[1], p[2]});
  }

  // A position that is not finite is an error only if something is drawn with it.
  Result<void> settle_unreadable_positions() {
    if (unreadable_.empty()) return {};
    std::vector<bool> used(built_.mesh.positions.size(), false);
    for (const Corner& corner : built_.mesh.corners) used[corner.position] = true;
    obj::OccurrenceCount unused;
    for (const UnreadablePosition& vertex : unreadable_) {
      if (used[vertex.index]) {
        return fail("vertex " + std::to_string(vertex.index) + " (" + vertex.place + ")",
                    std::string("its ") + vertex.axis + " is " + vertex.what,
                    "repair the vertex and export the file again");
      }
      unused.add(vertex.index);
    }
    unused.report("unused vertex does not have three finite numbers",
                  "unused vertices do not have three finite numbers", warnings_, ": vertex");
    return {};
  }

  void add_normal(const VertexPropertyIndices& indices, std::uint64_t index) {
    const double x = row_[*indices.normal[0]], y = row_[*indices.normal[1]],
                 z = row_[*indices.normal[2]];
    const double squared = x * x + y * y + z * z;
    const bool good = squared > 0x1p-1000 && std::isfinite(squared);
    const double length = std::sqrt(squared);
    if (!good) odd_normals_.add(index);
    has_normal_.push_back(good);
    built_.mesh.normals.push_back(
        good ? Normal<Object>(float(x / length), float(y / length), float(z / length))
             : Normal<Object>(0, 0, 1));
  }

  // Returns the index of the added entry.
  std::uint32_t add_texcoord(double u, double v, std::uint64_t index) {
    TexCoord t{float(u), float(1.0 - v)};
    if (!std::isfinite(t.u) || !std::isfinite(t.v)) {
      odd_texcoords_.add(index);
      t = {0, 0};
    }
    built_.mesh.texcoords.push_back(t);
    return std::uint32_t(built_.mesh.texcoords.size() - 1);
  }

  // ---- faces ----

  // The list of vertices of a face or of a strip.
  static Result<std::size_t> list_of_vertices(const Element& element) {
    const PropertyIndex indices = element.find({"vertex_indices", "vertex_index"});
    if (!indices || !element.properties[*indices].count_type ||
        !is_integer(element.properties[*indices].type)) {
      return fail("element " + in_quotes(element.name), "has no list 'vertex_indices' of integers",
                  "export the file again");
    }
    return *indices;
  }

  Result<void> read_faces(const Element& element) {
    const auto indices = list_of_vertices(element);
    if (!indices) return tl::unexpected(indices.error());
    const PropertyIndex texcoords = element.find({"texcoord"});
    const ColorPropertyIndices color(element);
    warn_about_unread(element, "face properties",
                      {*indices, texcoords, color.red, color.green, color.blue, color.alpha});
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_row(element)) return refuse("face", i, problem_, "export the file again");
      const std::vector<double>& corners = lists_[*indices];
      if (corners.size() < 3) {
        short_faces_.add(i);
        continue;
      }
      if (auto done = add_face(corners, "face", i); !done) return done;
      if (texcoords) add_wedges(element.properties[*texcoords], lists_[*texcoords], i);
      if (color.complete()) add_face_color(element, color);
    }
    return {};
  }

  Result<void> add_face(std::span<const double> corners, const char* element, std::uint64_t index) {
    Mesh& mesh = built_.mesh;
    const auto max_corners = std::min(limits_.max_corners, std::uint64_t(kNone));
    if (corners.size() > max_corners - mesh.corners.size()) {
      return refuse(element, index,
                    "up to here the faces have more than " + std::to_string(max_corners) +
                        " corners, the most that are read",
                    "use a smaller mesh (in the library: LoadLimits::max_corners)");
    }
    mesh.faces.push_back({std::uint32_t(mesh.corners.size()), std::uint32_t(corners.size())});
    const std::uint64_t count = header_.find("vertex")->count;
    for (const double vertex : corners) {
      if (!(vertex >= 0 && vertex < double(count))) {
        return refuse(element, index,
                      "names vertex " + std::to_string(std::int64_t(vertex)) +
                          ", but the file has only " + std::to_string(count) +
                          " (numbers start at 0)",
                      "export the file again");
      }
      mesh.corners.push_back({std::uint32_t(vertex), kNone, kNone, kNone});
    }
    return {};
  }

  // The triangle strips of Stanford's scans: each row has many strips, and -1 ends one. Every
  // second triangle of a strip is turned, so that all triangles have the same winding. A triangle
  // that names a vertex twice only leads on to the next one, and is not a face.
  Result<void> read_strips(const Element& element) {
    const auto indices = list_of_vertices(element);
    if (!indices) return tl::unexpected(indices.error());
    warn_about_unread(element, "strip properties", {*indices});
    for (std::uint64_t i = 0; i < element.count; ++i) {
      if (!read_row(element)) return refuse("strip", i, problem_, "export the file again");
      const std::vector<double>& vertices = lists_[*indices];
      std::size_t begin = 0;  // of the current strip
      for (std::size_t k = 0; k < vertices.size(); ++k) {
        if (vertices[k] == -1) begin = k + 1;
        if (k < begin + 2 || vertices[k] == -1) continue;
        const double a = vertices[k - 2], b = vertices[k - 1], c = vertices[k];
        if (a == b || b == c || c == a) continue;
        const bool turned = (k - begin) % 2 == 1;
        const std::array<double, 3> triangle = {turned ? b : a, turned ? a : b, c};
        if (auto done = add_face(triangle, "strip", i); !done) return done;
      }
    }
    return {};
  }

  // Adds the texture coordinates of the corners of the last face.
  void add_wedges(const Property& property, const std::vector<double>& list, std::uint64_t face) {
    Mesh& mesh = built_.mesh;
    const Face& last = mesh.faces.back();
    if (!property.count_type || list.size() != 2 * std::size_t(last.count)) {
      if (!list.empty()) odd_wedges_.add(face);
      return;
    }
    bool all_finite = true;
    for (std::uint32_t k = 0; k < last.count; ++k) {
      wedges_.push_back({float(list[2 * k]), float(1.0 - list[2 * k + 1])});
      TexCoord& t = wedges_.back();
      if (!std::isfinite(t.u) || !std::isfinite(t.v)) {
        all_finite = false;
        t = {0, 0};
      }
      mesh.corners[last.first + k].texcoord = std::uint32_t(wedges_.size() - 1);
    }
    if (!all_finite) odd_wedges_.add(face);
  }

  void add_face_color(const Element& element, const ColorPropertyIndices& indices) {
    const auto color = std::uint32_t(face_colors_.size());
    face_colors_.add(element, indices, row_);
    const Face& last = built_.mesh.faces.back();
    for (std::uint32_t k = 0; k < last.count; ++k) {
      built_.mesh.corners[last.first + k].color = color;
    }
  }

  // ---- after all data have been read, because faces may come before the vertices ----

  // A corner has one index into each table. The indices of its normal, colour and texture
  // coordinates equal that of its position, unless faces have their own values.
  void complete_corners() {
    Mesh& mesh = built_.mesh;
    const bool by_corner = !wedges_.empty();
    const bool by_face = vertex_colors_.empty() && !face_colors_.empty();
    if (by_corner) mesh.texcoords = std::move(wedges_);
    mesh.colors =
        by_face ? face_colors_.take("face", warnings_) : vertex_colors_.take("vertex", warnings_);
    for (Corner& corner : mesh.corners) {
      if (!mesh.normals.empty() && has_normal_[corner.position]) corner.normal = corner.position;
      if (!by_corner) corner.texcoord = mesh.texcoords.empty() ? kNone : corner.position;
      if (!by_face) corner.color = mesh.colors.empty() ? kNone : corner.position;
    }
    settle_alpha();
  }

  void settle_alpha() {
    std::vector<Rgba>& colors = built_.mesh.colors;
    const bool all_clear = std::ranges::all_of(colors, [](const Rgba& c) { return c.a == 0; });
    if (!colors.empty() && all_clear) {
      warnings_.add("the alpha of all colours is 0; it was ignored, and the mesh is drawn opaque");
      for (Rgba& color : colors) color.a = 1;
    }
    built_.translucent = std::ranges::any_of(colors, [](const Rgba& c) { return c.a < 1; });
  }

  // ---- what is not drawn ----

  void not_drawn(const std::string& kind, const std::string& name) {
    auto known = std::ranges::find(unread_, kind, &std::pair<std::string, std::string>::first);
    if (known == unread_.end()) {
      unread_.emplace_back(kind, "");
      known = unread_.end() - 1;
    }
    constexpr std::size_t kMaxLength = 400;
    if (known->second.size() > kMaxLength) return;
    known->second += (known->second.empty() ? "" : ", ") + printable(name);
  }

  void warn_about_unread(const Element& element, const char* kind,
                         std::initializer_list<PropertyIndex> read) {
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (std::ranges::find(read, PropertyIndex(i)) == read.end()) {
        not_drawn(kind, element.properties[i].name);
      }
    }
  }

  void report() {
    constexpr const char *kFace = ": face", *kVertex = ": vertex";
    short_faces_.report("face of fewer than three corners was left out",
                        "faces of fewer than three corners were left out", warnings_, kFace);
    odd_normals_.report("normal is zero or not finite and was left out",
                        "normals are zero or not finite and were left out", warnings_, kVertex);
    odd_texcoords_.report("pair of texture coordinates is not finite and was taken as (0, 0)",
                          "pairs of texture coordinates are not finite and were taken as (0, 0)",
                          warnings_, kVertex);
    odd_wedges_.report(
        "face has texture coordinates that are not finite or do not fit its corners",
        "faces have texture coordinates that are not finite or do not fit their corners", warnings_,
        kFace);
    for (const auto& [kind, names] : unread_) warnings_.add(kind + " are not drawn: " + names);
  }

  const Header& header_;
  const LoadLimits& limits_;
  obj::Warnings& warnings_;
  Values values_;
  PlyMesh built_;

  std::vector<double> row_;
  std::vector<std::vector<double>> lists_;
  std::string problem_;
  std::vector<bool> has_normal_;
  std::vector<TexCoord> wedges_;
  ColorTable vertex_colors_, face_colors_;
  std::vector<UnreadablePosition> unreadable_;  // ascending
  obj::OccurrenceCount short_faces_, odd_normals_, odd_texcoords_, odd_wedges_;
  std::vector<std::pair<std::string, std::string>> unread_;
};

}  // namespace

Result<PlyMesh> build_mesh(std::string_view file, const Header& header, const LoadLimits& limits,
                           obj::Warnings& warnings) {
  return Builder(file, header, limits, warnings).run();
}

}  // namespace glassbox::ply
