#include <glassbox/mesh/gltf/accessors.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>
#include <string>
#include <type_traits>

#include <glassbox/base/little_endian.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

constexpr const char* kExportAgain = "the file is damaged: export it again";

std::size_t component_bytes(int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    default:
      return 4;
  }
}

// The distance between the starts of two elements, if the buffer view does not give it. Every
// column of a matrix starts at a multiple of four bytes, and so does every matrix.
std::size_t element_bytes(const tinygltf::Accessor& accessor) {
  const std::size_t size = component_bytes(accessor.componentType);
  const auto padded = [](std::size_t bytes) { return (bytes + 3) / 4 * 4; };
  switch (accessor.type) {
    case TINYGLTF_TYPE_MAT2:
      return 2 * padded(2 * size);
    case TINYGLTF_TYPE_MAT3:
      return 3 * padded(3 * size);
    case TINYGLTF_TYPE_MAT4:
      return 4 * padded(4 * size);
    default:
      return components(accessor) * size;
  }
}

// The size of the last element; its last column is not padded (glTF 2.0, section 3.6.2.4).
std::size_t last_element_bytes(const tinygltf::Accessor& accessor) {
  const std::size_t size = component_bytes(accessor.componentType);
  const auto without_padding = [&](std::size_t rows) {
    return element_bytes(accessor) - (4 - rows * size % 4) % 4;
  };
  switch (accessor.type) {
    case TINYGLTF_TYPE_MAT2:
      return without_padding(2);
    case TINYGLTF_TYPE_MAT3:
      return without_padding(3);
    case TINYGLTF_TYPE_MAT4:
      return without_padding(4);
    default:
      return element_bytes(accessor);
  }
}

std::size_t stride_bytes(const Asset& asset, const tinygltf::Accessor& accessor) {
  const std::size_t stride = asset.model.bufferViews[std::size_t(accessor.bufferView)].byteStride;
  return stride == 0 ? element_bytes(accessor) : stride;
}

// Whether `count` elements fit after `offset`, if they start `stride` bytes apart and the last is
// `last` bytes long. Nothing here can overflow: `count` is below 2^32, `stride` below 2^8.
bool fits(std::uint64_t available, std::uint64_t offset, std::uint64_t count, std::uint64_t stride,
          std::uint64_t last) {
  if (count == 0) return true;
  return offset <= available && (count - 1) * stride + last <= available - offset;
}

tl::unexpected<Error> refuse(std::size_t index, std::string cause) {
  return fail(entry("accessor", index), std::move(cause), kExportAgain);
}

Result<void> check_elements(const Asset& asset, std::size_t index) {
  const tinygltf::Accessor& accessor = asset.model.accessors[index];
  if (accessor.bufferView < 0) {
    if (accessor.count > asset.bytes) {
      return refuse(index, "has " + std::to_string(accessor.count) +
                               " elements without data, too many for a file of " +
                               std::to_string(asset.bytes) + " bytes");
    }
    return {};
  }
  const tinygltf::BufferView& view = asset.model.bufferViews[std::size_t(accessor.bufferView)];
  const std::size_t stride = stride_bytes(asset, accessor);
  if (stride < element_bytes(accessor)) {
    return refuse(index, "has elements of " + std::to_string(element_bytes(accessor)) +
                             " bytes that begin only " + std::to_string(stride) + " bytes apart");
  }
  if (!fits(view.byteLength, accessor.byteOffset, accessor.count, stride,
            last_element_bytes(accessor))) {
    return refuse(index, std::to_string(accessor.count) + " elements reach beyond the " +
                             std::to_string(view.byteLength) + " bytes of " +
                             entry("bufferView", std::size_t(accessor.bufferView)));
  }
  return {};
}

Result<void> check_sparse(const Asset& asset, std::size_t index) {
  const tinygltf::Accessor& accessor = asset.model.accessors[index];
  const auto& sparse = accessor.sparse;
  if (!sparse.isSparse) return {};
  const int type = sparse.indices.componentType;
  if (type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT &&
      type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
    return refuse(index, "has sparse indices that are not unsigned integers");
  }
  const auto& views = asset.model.bufferViews;
  const std::uint64_t count = std::uint64_t(sparse.count);
  const std::uint64_t index_bytes = component_bytes(type);
  if (count > accessor.count) {
    return refuse(index, "its sparse part replaces " + std::to_string(count) +
                             " elements, but it has only " + std::to_string(accessor.count));
  }
  if (!fits(views[std::size_t(sparse.indices.bufferView)].byteLength,
            std::uint64_t(sparse.indices.byteOffset), count, index_bytes, index_bytes)) {
    return refuse(index, "its sparse indices reach beyond the end of " +
                             entry("bufferView", std::size_t(sparse.indices.bufferView)));
  }
  if (!fits(views[std::size_t(sparse.values.bufferView)].byteLength,
            std::uint64_t(sparse.values.byteOffset), count, element_bytes(accessor),
            last_element_bytes(accessor))) {
    return refuse(index, "its sparse values reach beyond the end of " +
                             entry("bufferView", std::size_t(sparse.values.bufferView)));
  }
  return {};
}

// Calls `use` with a value of the C++ type that belongs to glTF's code `component_type`.
template <class Use>
void with_component(int component_type, Use use) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return use(std::int8_t());
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return use(std::uint8_t());
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return use(std::int16_t());
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return use(std::uint16_t());
    case TINYGLTF_COMPONENT_TYPE_INT:
      return use(std::int32_t());
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return use(std::uint32_t());
    default:
      return use(float());
  }
}

// Buffers are little-endian, and so is memory (base/little_endian.h); the values need not be
// aligned.
template <class T>
T load(std::span<const std::byte> bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  return value;
}

// Copies `count` elements that start `stride` bytes apart from `bytes` to the places `target(i)`.
template <class Number, class Target>
void copy_elements(const tinygltf::Accessor& accessor, std::span<const std::byte> bytes,
                   std::size_t offset, std::size_t stride, std::size_t count, Target target) {
  const std::size_t width = components(accessor);
  with_component(accessor.componentType, [&](auto component) {
    using Component = decltype(component);
    for (std::size_t i = 0; i < count; ++i) {
      Number* const out = target(i);
      for (std::size_t c = 0; c < width; ++c) {
        const Component raw = load<Component>(bytes, offset + i * stride + c * sizeof(Component));
        // Indices are read only from unsigned components, so a signed char cannot get here as an
        // index.
        // NOLINTNEXTLINE(bugprone-signed-char-misuse)
        out[c] = static_cast<Number>(raw);
        if constexpr (std::is_integral_v<Component> && std::is_floating_point_v<Number>) {
          if (accessor.normalized)
            out[c] = std::max(out[c] / Number(std::numeric_limits<Component>::max()), Number(-1));
        }
      }
    }
  });
}

// The indices of the elements that a sparse accessor replaces. They must be strictly ascending and
// below the accessor's count.
Result<std::vector<std::uint32_t>> sparse_indices(const Asset& asset, std::size_t index) {
  const tinygltf::Accessor& accessor = asset.model.accessors[index];
  const auto bytes = view_bytes(asset, std::size_t(accessor.sparse.indices.bufferView));
  if (!bytes) return tl::unexpected(bytes.error());
  std::vector<std::uint32_t> indices;
  with_component(accessor.sparse.indices.componentType, [&](auto component) {
    const std::size_t offset = std::size_t(accessor.sparse.indices.byteOffset);
    for (std::size_t i = 0; i < std::size_t(accessor.sparse.count); ++i) {
      indices.push_back(static_cast<std::uint32_t>(
          load<decltype(component)>(*bytes, offset + i * sizeof(component))));
    }
  });
  for (std::size_t i = 0; i < indices.size(); ++i) {
    if (indices[i] >= accessor.count) {
      return refuse(index, "sparse index " + std::to_string(i) + " is " +
                               std::to_string(indices[i]) + ", but the accessor has only " +
                               std::to_string(accessor.count) + " elements");
    }
    if (i > 0 && indices[i] <= indices[i - 1]) {
      return refuse(index,
                    "sparse index " + std::to_string(i) + " is not greater than the one before");
    }
  }
  return indices;
}

template <class Number>
Result<std::vector<Number>> read_elements(const Asset& asset, std::size_t index) {
  const tinygltf::Accessor& accessor = asset.model.accessors[index];
  const std::size_t width = components(accessor);
  std::vector<Number> elements(accessor.count * width);
  if (accessor.bufferView >= 0 && accessor.count > 0) {
    const auto bytes = view_bytes(asset, std::size_t(accessor.bufferView));
    if (!bytes) return tl::unexpected(bytes.error());
    copy_elements<Number>(accessor, *bytes, accessor.byteOffset, stride_bytes(asset, accessor),
                          accessor.count,
                          [&](std::size_t i) { return elements.data() + i * width; });
  }
  if (accessor.sparse.isSparse) {
    const auto indices = sparse_indices(asset, index);
    if (!indices) return tl::unexpected(indices.error());
    const auto bytes = view_bytes(asset, std::size_t(accessor.sparse.values.bufferView));
    if (!bytes) return tl::unexpected(bytes.error());
    copy_elements<Number>(accessor, *bytes, std::size_t(accessor.sparse.values.byteOffset),
                          element_bytes(accessor), indices->size(),
                          [&](std::size_t i) { return elements.data() + (*indices)[i] * width; });
  }
  return elements;
}

}  // namespace

std::size_t components(const tinygltf::Accessor& accessor) {
  return std::size_t(tinygltf::GetNumComponentsInType(std::uint32_t(accessor.type)));
}

Result<void> check_accessors(const Asset& asset) {
  for (std::size_t i = 0; i < asset.model.accessors.size(); ++i) {
    if (auto done = check_elements(asset, i); !done) return done;
    if (auto done = check_sparse(asset, i); !done) return done;
  }
  return {};
}

Result<std::vector<double>> read_numbers(const Asset& asset, std::size_t accessor) {
  return read_elements<double>(asset, accessor);
}

Result<std::vector<std::uint32_t>> read_indices(const Asset& asset, std::size_t accessor) {
  return read_elements<std::uint32_t>(asset, accessor);
}

}  // namespace glassbox::gltf
