#include <glassbox/mesh/gltf/attributes.h>

#include <cmath>

#include <glassbox/mesh/gltf/accessors.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

// The component type of an accessor, and whether its values are normalised.
struct Form {
  bool is_byte, is_ubyte, is_short, is_ushort, is_uint, is_float, normalized;

  explicit Form(const tinygltf::Accessor& a)
      : is_byte(a.componentType == TINYGLTF_COMPONENT_TYPE_BYTE),
        is_ubyte(a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE),
        is_short(a.componentType == TINYGLTF_COMPONENT_TYPE_SHORT),
        is_ushort(a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT),
        is_uint(a.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT),
        is_float(a.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT),
        normalized(a.normalized) {}
};

// Whether the accessor's form is allowed for this use (glTF 2.0, section 3.7.2.1, and the tables of
// KHR_mesh_quantization).
bool is_allowed(const tinygltf::Accessor& accessor, Semantic semantic, bool quantized) {
  const Form f(accessor);
  const bool small = f.is_byte || f.is_ubyte || f.is_short || f.is_ushort;
  const bool small_signed = f.is_byte || f.is_short;
  const bool small_unsigned = f.is_ubyte || f.is_ushort;
  switch (semantic) {
    case Semantic::kPosition:
      return accessor.type == TINYGLTF_TYPE_VEC3 && (f.is_float || (quantized && small));
    case Semantic::kNormal:
      return accessor.type == TINYGLTF_TYPE_VEC3 &&
             (f.is_float || (quantized && small_signed && f.normalized));
    case Semantic::kTexCoord:
      return accessor.type == TINYGLTF_TYPE_VEC2 &&
             (f.is_float || (small_unsigned && f.normalized) || (quantized && small));
    case Semantic::kColor:
      return (accessor.type == TINYGLTF_TYPE_VEC3 || accessor.type == TINYGLTF_TYPE_VEC4) &&
             (f.is_float || (small_unsigned && f.normalized));
    case Semantic::kJoints:
      return accessor.type == TINYGLTF_TYPE_VEC4 && small_unsigned && !f.normalized;
    case Semantic::kWeights:
      return accessor.type == TINYGLTF_TYPE_VEC4 &&
             (f.is_float || (small_unsigned && f.normalized));
    case Semantic::kPositionDelta:
    case Semantic::kNormalDelta:
      return accessor.type == TINYGLTF_TYPE_VEC3 && (f.is_float || (quantized && small_signed));
    case Semantic::kIndices:
      return accessor.type == TINYGLTF_TYPE_SCALAR && (small_unsigned || f.is_uint) &&
             !f.normalized;
  }
  return false;
}

}  // namespace

Result<void> check_form(const Asset& asset, std::size_t accessor, Semantic semantic) {
  if (is_allowed(asset.model.accessors[accessor], semantic, asset.uses("KHR_mesh_quantization")))
    return {};
  return fail(entry("accessor", accessor),
              "has a type or component type that glTF does not allow for this attribute",
              "export the file again");
}

bool has_data(const Asset& asset, std::size_t index) {
  const tinygltf::Accessor& accessor = asset.model.accessors[index];
  const auto view_has = [&](int view) {
    return view < 0 ||
           asset.buffers[std::size_t(asset.model.bufferViews[std::size_t(view)].buffer)] != nullptr;
  };
  if (!view_has(accessor.bufferView)) return false;
  return !accessor.sparse.isSparse || (view_has(accessor.sparse.indices.bufferView) &&
                                       view_has(accessor.sparse.values.bufferView));
}

Result<std::optional<Attribute>> Attributes::read(const std::string& name,
                                                  Semantic semantic) const {
  const auto found = accessors_.find(name);
  if (found == accessors_.end()) return std::optional<Attribute>();
  const std::size_t index = std::size_t(found->second);
  const std::string place = place_ + ", " + name;
  if (auto form = check_form(asset_, index, semantic); !form)
    return fail_inside(place, form.error());
  const tinygltf::Accessor& accessor = asset_.model.accessors[index];
  if (accessor.count != count_) {
    return fail(place + ", " + entry("accessor", index),
                "has " + std::to_string(accessor.count) + " elements where the primitive has " +
                    std::to_string(count_) + " vertices",
                "export the file again");
  }
  auto numbers = read_numbers(asset_, index);
  if (!numbers) return fail_inside(place, numbers.error());
  Attribute attribute{index, components(accessor), std::move(*numbers)};
  std::uint64_t unused = 0;
  for (std::size_t i = 0; i < attribute.numbers.size(); ++i) {
    if (std::isfinite(attribute.numbers[i])) continue;
    if (!used_.empty() && !used_[i / attribute.width]) {
      attribute.numbers[i] = 0;
      ++unused;
    } else {
      return fail(place + ", " + entry("accessor", index) + ", element " +
                      std::to_string(i / attribute.width),
                  std::string("is ") +
                      (std::isnan(attribute.numbers[i]) ? "not a number (NaN)" : "infinite"),
                  "repair the vertex and export the file again");
    }
  }
  if (unused > 0) {
    asset_.warn_at(place_, "{} numbers of unused vertices are not finite and were taken as 0",
                   unused);
  }
  return attribute;
}

}  // namespace glassbox::gltf
