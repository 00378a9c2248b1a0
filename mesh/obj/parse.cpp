#include <glassbox/mesh/obj/parse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include <glassbox/images/srgb.h>

namespace glassbox::obj {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

std::string line_place(std::uint64_t line) {
  return "line " + std::to_string(line);
}

// Whether the statement belongs to free-form curves and surfaces, which draw no polygon, line or
// point.
bool is_free_form(std::string_view keyword) {
  constexpr std::string_view kKeywords[] = {
      "vp",   "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim",  "hole",
      "scrv", "sp",     "end", "con",  "bsp",  "bzp",  "cdc",   "cdp",  "res",  "ctech", "stech"};
  return std::find(std::begin(kKeywords), std::end(kKeywords), keyword) != std::end(kKeywords);
}

// Whether the statement controls rendering in a way that the scene does not use.
bool is_render_state(std::string_view keyword) {
  constexpr std::string_view kKeywords[] = {
      "mg", "bevel", "c_interp", "lod", "d_interp", "maplib", "usemap", "shadow_obj", "trace_obj"};
  return std::find(std::begin(kKeywords), std::end(kKeywords), keyword) != std::end(kKeywords);
}

// One of the tables that corners index. An index may refer to an entry that follows later in the
// file, so the largest index is kept and compared with the final size.
struct IndexedTable {
  const char* name;
  std::uint64_t size = 0;
  std::int64_t largest = -1;  // counted from 0
  std::uint64_t line_of_largest = 0;
};

class Parser {
public:
  Parser(std::string_view text, const LoadLimits& limits, Warnings& warnings)
      : lines_(text), limits_(limits), warnings_(warnings) {}

  Result<Tables> run() {
    while (lines_.next()) {
      Words words(lines_.text());
      const std::string_view keyword = words.next();
      if (auto status = statement(keyword, words); !status) return tl::unexpected(status.error());
    }
    drop_references_to(texcoords_, &Reference::texcoord);
    drop_references_to(normals_, &Reference::normal);
    if (auto status = check_forward_references(); !status) return tl::unexpected(status.error());
    if (auto status = check_unreadable_vertices(); !status) return tl::unexpected(status.error());
    report_oddities();
    if (tables_.elements.empty()) {
      return fail("", "has no faces, lines or points", "give an OBJ file with something to draw");
    }
    return std::move(tables_);
  }

private:
  using Status = Result<void>;

  tl::unexpected<Error> refuse(std::string cause, std::string remedy) const {
    return fail(line_place(lines_.number()), std::move(cause), std::move(remedy));
  }

  Status statement(std::string_view keyword, Words words) {
    if (keyword == "v") return vertex(words);
    if (keyword == "f" || keyword == "fo") return element(ElementKind::kFace, words);
    if (keyword == "l") return element(ElementKind::kPolyline, words);
    if (keyword == "p") return element(ElementKind::kPoints, words);
    if (keyword == "vt") {
      texcoord(words);
    } else if (keyword == "vn") {
      normal(words);
    } else if (keyword == "usemtl") {
      part_.material = tables_.names.number_of(words.rest());
    } else if (keyword == "g") {
      part_.group = tables_.names.number_of(without_comment(words.rest()));
    } else if (keyword == "o") {
      part_.object = tables_.names.number_of(without_comment(words.rest()));
    } else if (keyword == "s") {
      smoothing(words.next());
    } else if (keyword == "mtllib") {
      library(words.rest());
    } else if (is_free_form(keyword)) {
      free_form_.add(lines_.number());
    } else if (!is_render_state(keyword)) {
      if (first_unknown_.empty()) first_unknown_ = in_quotes(keyword);
      unknown_.add(lines_.number());
    }
    return {};
  }

  // Reads "v x y z [w] [r g b]".
  Status vertex(Words words) {
    std::array<Number, 7> numbers;
    std::size_t count = 0;
    bool readable = true;
    std::string_view not_finite;
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      if (count == numbers.size()) {
        more_numbers_.add(lines_.number());
        break;
      }
      numbers[count] = parse_number(word);
      if (count < 3 && not_finite.empty() && numbers[count].kind == Number::Kind::kNotFinite) {
        not_finite = word;
      }
      readable = readable && (count >= 3 || numbers[count].kind == Number::Kind::kFinite);
      ++count;
    }
    if (positions_.size == kNone) {
      return refuse("the file has more than 2^32 - 1 vertices", "split the file");
    }
    if (count < 3 || !readable) {
      constexpr std::size_t kMaxLength = 40;
      tables_.unreadable.push_back({std::uint32_t(positions_.size), lines_.number(),
                                    std::string(not_finite.substr(0, kMaxLength))});
      tables_.positions.emplace_back(kNaN, kNaN, kNaN);
    } else {
      tables_.positions.emplace_back(numbers[0].value, numbers[1].value, numbers[2].value);
    }
    const bool weighted = count == 4;
    if (weighted && numbers[3].value != 1.0f) weights_.add(lines_.number());
    if (count == 5) more_numbers_.add(lines_.number());
    if (count >= 6) vertex_color({numbers[3], numbers[4], numbers[5]});
    if (!tables_.colors.empty()) tables_.colors.resize(tables_.positions.size());
    ++positions_.size;
    return {};
  }

  // Sets the colour of the vertex that was read last.
  void vertex_color(const std::array<Number, 3>& channels) {
    VertexColor color;
    color.given = true;
    std::uint8_t* const codes[] = {&color.r, &color.g, &color.b};
    for (std::size_t i = 0; i < 3; ++i) {
      const float value = channels[i].value;
      if (channels[i].kind != Number::Kind::kFinite) {
        odd_colors_.add(lines_.number());
        return;
      }
      if (value < 0.0f || value > 1.0f) odd_colors_.add(lines_.number());
      *codes[i] = encode_unorm8(value);
    }
    tables_.colors.resize(tables_.positions.size());
    tables_.colors.back() = color;
  }

  // Reads "vt u [v] [w]".
  void texcoord(Words words) {
    const Number u = parse_number(words.next());
    const std::string_view second = words.next();
    const Number v = second.empty() ? Number{Number::Kind::kFinite, 0} : parse_number(second);
    const bool readable = u.kind == Number::Kind::kFinite && v.kind == Number::Kind::kFinite;
    if (!readable) odd_texcoords_.add(lines_.number());
    tables_.texcoords.push_back(readable ? TexCoord{u.value, v.value} : TexCoord{kNaN, kNaN});
    ++texcoords_.size;
  }

  // Reads "vn x y z".
  void normal(Words words) {
    std::array<float, 3> n{};
    bool readable = true;
    for (float& component : n) {
      const Number number = parse_number(words.next());
      readable = readable && number.kind == Number::Kind::kFinite;
      component = number.value;
    }
    const bool zero = n[0] == 0 && n[1] == 0 && n[2] == 0;
    if (!readable || zero) odd_normals_.add(lines_.number());
    tables_.normals.push_back(readable ? Normal<Object>(n[0], n[1], n[2]) : Normal<Object>());
    ++normals_.size;
  }

  Status element(ElementKind kind, Words words) {
    const std::size_t first = tables_.references.size();
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
      auto corner = reference(word);
      if (!corner) return tl::unexpected(corner.error());
      tables_.references.push_back(*corner);
      if (tables_.references.size() == kNone) {
        return refuse("the file has more than 2^32 - 2 corners", "split the file");
      }
    }
    const std::size_t count = tables_.references.size() - first;
    const std::size_t needed = kind == ElementKind::kFace       ? 3
                               : kind == ElementKind::kPolyline ? 2
                                                                : 1;
    if (count < needed) {
      (kind == ElementKind::kFace ? short_faces_ : short_lines_).add(lines_.number());
      tables_.references.resize(first);
      return {};
    }
    corners_ += kind == ElementKind::kPolyline ? 2 * (count - 1) : count;
    if (corners_ > limits_.max_corners) {
      return refuse("the file has more than " + std::to_string(limits_.max_corners) +
                        " corners, the most that are read",
                    "use a smaller mesh (in the library: LoadLimits::max_corners)");
    }
    const auto [known, is_first] =
        part_numbers_.try_emplace(part_, std::uint32_t(tables_.parts.size()));
    if (is_first) tables_.parts.push_back(part_);
    tables_.elements.push_back(
        {std::uint32_t(first), std::uint32_t(count), known->second, smoothing_group_, kind});
    return {};
  }

  // Reads the word after "s": the number of a group from 1, or "off" or 0 for none. Some programs
  // write "on".
  void smoothing(std::string_view word) {
    const auto group = parse_integer(word);
    const bool known =
        group ? *group >= 0 && *group < std::int64_t(kNone) : word == "off" || word == "on";
    if (!known) odd_groups_.add(lines_.number());
    smoothing_group_ = !known ? 0 : group ? std::uint32_t(*group) : word == "on" ? 1 : 0;
  }

  // Parses i, i/j, i//k or i/j/k; an index that is left out after a slash is missing.
  Result<Reference> reference(std::string_view word) {
    std::array<std::string_view, 3> fields;
    std::size_t count = 0;
    std::string_view rest = word;
    for (bool more = true; more; ++count) {
      if (count == fields.size()) {
        return refuse("the corner " + in_quotes(word) + " has more than three indices",
                      "write vertex/texture/normal");
      }
      const std::size_t slash = rest.find('/');
      fields[count] = rest.substr(0, slash);
      more = slash != std::string_view::npos;
      if (more) rest.remove_prefix(slash + 1);
    }
    Reference corner;
    const auto position = index(fields[0], positions_);
    if (!position) return tl::unexpected(position.error());
    corner.position = *position;
    if (!fields[1].empty()) {
      const auto texcoord = index(fields[1], texcoords_);
      if (!texcoord) return tl::unexpected(texcoord.error());
      corner.texcoord = *texcoord;
    }
    if (!fields[2].empty()) {
      const auto normal = index(fields[2], normals_);
      if (!normal) return tl::unexpected(normal.error());
      corner.normal = *normal;
    }
    return corner;
  }

  Result<std::uint32_t> index(std::string_view digits, IndexedTable& table) {
    const std::string remedy = "export the file again or correct the line";
    const auto written = parse_integer(digits);
    if (!written) return refuse(in_quotes(digits) + " is not an index of a " + table.name, remedy);
    if (*written == 0) {
      return refuse(std::string("names ") + table.name + " 0, but numbers start at 1", remedy);
    }
    // Negative numbers count back from the latest entry, which is -1.
    const std::int64_t from_zero =
        *written > 0 ? *written - 1 : std::int64_t(table.size) + *written;
    if (from_zero < 0 || from_zero >= std::int64_t(kNone)) {
      return refuse(std::string("names ") + table.name + " " + std::to_string(*written) +
                        ", but only " + std::to_string(table.size) + " are defined",
                    remedy);
    }
    if (from_zero >= std::int64_t(table.size) && from_zero > table.largest) {
      table.largest = from_zero;
      table.line_of_largest = lines_.number();
    }
    return std::uint32_t(from_zero);
  }

  void library(std::string_view text) {
    constexpr std::size_t kMaxLibraries = 256;
    if (text.empty() || libraries_seen_.contains(text)) return;
    if (tables_.libraries.size() == kMaxLibraries) {
      many_libraries_.add(lines_.number());
      return;
    }
    libraries_seen_.emplace(text);
    tables_.libraries.emplace_back(text);
  }

  Status check_forward_references() const {
    for (const IndexedTable* table : {&positions_, &texcoords_, &normals_}) {
      if (table->largest >= std::int64_t(table->size)) {
        return fail(line_place(table->line_of_largest),
                    std::string("names ") + table->name + " " + std::to_string(table->largest + 1) +
                        ", but the file has only " + std::to_string(table->size),
                    "export the file again or correct the line");
      }
    }
    return {};
  }

  Status check_unreadable_vertices() {
    if (tables_.unreadable.empty()) return {};
    for (const Reference& corner : tables_.references) {
      if (std::isfinite(tables_.positions[corner.position].x)) continue;
      const auto vertex =
          std::lower_bound(tables_.unreadable.begin(), tables_.unreadable.end(), corner.position,
                           [](const UnreadableVertex& v, std::uint32_t i) { return v.index < i; });
      const std::string name = "vertex " + std::to_string(vertex->index + 1);
      return fail(line_place(vertex->line),
                  vertex->not_finite.empty()
                      ? name + " does not have three numbers"
                      : name + " has the coordinate " + in_quotes(vertex->not_finite) +
                            ", which is not a finite number",
                  "export the file again or correct the line");
    }
    OccurrenceCount unreadable;
    for (const UnreadableVertex& vertex : tables_.unreadable) unreadable.add(vertex.line);
    unreadable.report("unused vertex does not have three finite numbers",
                      "unused vertices do not have three finite numbers", warnings_);
    return {};
  }

  // Some exporters write indices of normals or texture coordinates without writing the entries. If
  // the whole file has no entries of this kind, their indices can safely be ignored.
  using IndexOf = std::uint32_t Reference::*;
  void drop_references_to(IndexedTable& absent, IndexOf index) {
    if (absent.size > 0 || absent.largest < 0) return;
    for (Reference& corner : tables_.references) corner.*index = kNone;
    warnings_.add(std::string("corners name ") + absent.name +
                  "s, but the file has none, so they were left out (the last in line " +
                  std::to_string(absent.line_of_largest) + ")");
    absent.largest = -1;
  }

  void report_oddities() {
    short_faces_.report("face of fewer than three corners was left out",
                        "faces of fewer than three corners were left out", warnings_);
    short_lines_.report("line or point without enough vertices was left out",
                        "lines or points without enough vertices were left out", warnings_);
    free_form_.report("statement of a free-form curve or surface was ignored",
                      "statements of free-form curves and surfaces were ignored", warnings_);
    weights_.report("vertex weight other than 1 was ignored: polygons do not use it",
                    "vertex weights other than 1 were ignored: polygons do not use them",
                    warnings_);
    more_numbers_.report(
        "vertex has more numbers than x y z w or x y z r g b; the rest was ignored",
        "vertices have more numbers than x y z w or x y z r g b; the rest was ignored", warnings_);
    odd_colors_.report(
        "vertex colour does not consist of numbers in [0, 1] and was clamped or left out",
        "vertex colours do not consist of numbers in [0, 1] and were clamped or left out",
        warnings_);
    odd_texcoords_.report("pair of texture coordinates is not finite and was left out",
                          "pairs of texture coordinates are not finite and were left out",
                          warnings_);
    odd_normals_.report("normal is zero or not finite and was left out",
                        "normals are zero or not finite and were left out", warnings_);
    odd_groups_.report("smoothing group is neither a number nor off, and was taken as off",
                       "smoothing groups are neither numbers nor off, and were taken as off",
                       warnings_);
    many_libraries_.report("material library beyond the first 256 was ignored",
                           "material libraries beyond the first 256 were ignored", warnings_);
    if (!first_unknown_.empty()) {
      unknown_.report("unknown statement was ignored: " + first_unknown_,
                      "unknown statements were ignored, " + first_unknown_ + " among them",
                      warnings_);
    }
  }

  Lines lines_;
  const LoadLimits& limits_;
  Warnings& warnings_;
  Tables tables_;
  std::map<Part, std::uint32_t> part_numbers_;
  std::set<std::string, std::less<>> libraries_seen_;
  Part part_;
  // The number of corners in the meshes, where inner vertices of a polyline count twice.
  std::uint64_t corners_ = 0;

  IndexedTable positions_{"vertex"};
  IndexedTable texcoords_{"texture coordinate"};
  IndexedTable normals_{"normal"};

  std::uint32_t smoothing_group_ = 0;
  OccurrenceCount short_faces_, short_lines_, free_form_, unknown_, odd_texcoords_, odd_normals_,
      weights_, odd_colors_, more_numbers_, many_libraries_, odd_groups_;
  std::string first_unknown_;
};

}  // namespace

std::uint32_t Names::number_of(std::string_view name) {
  if (const auto known = numbers_.find(name); known != numbers_.end()) return known->second;
  const auto number = std::uint32_t(names_.size());
  names_.push_back(&numbers_.emplace(name, number).first->first);
  return number;
}

Result<Tables> parse_obj(std::string_view text, const LoadLimits& limits, Warnings& warnings) {
  return Parser(text, limits, warnings).run();
}

}  // namespace glassbox::obj
