#include <glassbox/mesh/gltf/asset.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>

#include <glassbox/mesh/gltf/container.h>
#include <glassbox/mesh/gltf/schema.h>
#include <glassbox/mesh/gltf/text.h>

namespace glassbox::gltf {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 5> kSupported = {
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_unlit",
    "KHR_mesh_quantization", "KHR_texture_transform"};

// At most this many warnings and names of extensions are kept: hostile files would fill memory with
// them.
constexpr std::size_t kMaxWarnings = 100;

// Adds a warning such as "the extension 'KHR_x' is not supported and was ignored in 3 places".
void warn_of_extension(Asset& asset, const std::string& name, std::uint64_t places) {
  const std::string where = places == 0   ? ""
                            : places == 1 ? " in one place"
                                          : " in " + std::to_string(places) + " places";
  asset.warn("the extension " + in_quotes(name) + " is not supported and was ignored" + where);
}

Result<void> check_extensions(Asset& asset, const std::map<std::string, std::uint64_t>& found) {
  for (const char* list : {"extensionsRequired", "extensionsUsed"}) {
    for (const json& item : asset.document.value(list, json::array())) {
      const std::string& name = item.get_ref<const std::string&>();
      if (std::ranges::find(asset.extensions, name) != asset.extensions.end()) continue;
      if (!is_supported(name)) {
        if (list == std::string_view("extensionsRequired")) {
          return fail(
              "extensionsRequired",
              "the file needs the extension " + in_quotes(name) + ", which is not supported",
              "export it without this extension");
        }
        const auto places = found.find(name);
        warn_of_extension(asset, name, places == found.end() ? 0 : places->second);
      }
      if (asset.extensions.size() >= kMaxWarnings) {
        return fail("extensionsUsed",
                    "names more than " + std::to_string(kMaxWarnings) + " extensions",
                    "remove the extensions that are not used");
      }
      asset.extensions.push_back(printable(name));
    }
  }
  // Also warn of extensions that the file uses without listing them.
  for (const auto& [name, places] : found) {
    const bool listed =
        std::ranges::find(asset.extensions, printable(name)) != asset.extensions.end();
    if (!listed && !is_supported(name)) warn_of_extension(asset, name, places);
  }
  return {};
}

Result<std::shared_ptr<const Bytes>> read_buffer(Asset& asset, std::size_t index,
                                                 std::optional<std::span<const std::byte>> binary) {
  const json& buffer = asset.document["buffers"][index];
  if (buffer.contains("uri"))
    return asset.resources.read(buffer["uri"].get_ref<const std::string&>());
  if (index == 0 && binary) return std::make_shared<const Bytes>(binary->begin(), binary->end());
  return std::shared_ptr<const Bytes>();
}

Result<void> read_buffers(Asset& asset, std::optional<std::span<const std::byte>> binary) {
  const std::size_t count = asset.document.value("buffers", json::array()).size();
  for (std::size_t i = 0; i < count; ++i) {
    auto data = read_buffer(asset, i, binary);
    if (!data) return fail(entry("buffer", i), data.error().cause, data.error().remedy);
    const std::uint64_t length = asset.document["buffers"][i]["byteLength"];
    if (*data && (*data)->size() < length) {
      return fail(entry("buffer", i),
                  "says " + std::to_string(length) + " bytes (byteLength), but there are only " +
                      std::to_string((*data)->size()),
                  "the file is cut short or damaged: export it again");
    }
    // More data than the padding of a GLB chunk to a multiple of four bytes is worth a warning.
    if (*data && (*data)->size() > length + 3)
      asset.warn(entry("buffer", i) +
                 " has more bytes than its byteLength says; the rest is not used");
    asset.buffers.push_back(std::move(*data));
  }
  return {};
}

Result<void> check_buffer_views(const Asset& asset) {
  const std::vector<tinygltf::BufferView>& views = asset.model.bufferViews;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const std::uint64_t length =
        asset.document["buffers"][std::size_t(views[i].buffer)]["byteLength"];
    if (views[i].byteOffset > length || views[i].byteLength > length - views[i].byteOffset) {
      return fail(entry("bufferView", i),
                  "reaches beyond the " + std::to_string(length) + " bytes of " +
                      entry("buffer", std::size_t(views[i].buffer)),
                  "the file is damaged: export it again");
    }
  }
  return {};
}

// tinygltf reads only text made from the checked document, not the file itself: it would read
// buffers by its own rules, decode images without a limit, and keep animations and extensions that
// nothing here draws.
Result<void> parse_model(Asset& asset) {
  json document = asset.document;
  for (const char* kept_here : {"buffers", "images", "animations"}) document.erase(kept_here);
  // tinygltf refuses accessors without a buffer view, which glTF allows (their elements are 0, or
  // sparse). So these accessors get a view while tinygltf reads.
  json& views = document["bufferViews"];
  const int stand_in = int(views.size());
  views.push_back({{"buffer", 0}, {"byteLength", 1}});
  for (json& accessor : document["accessors"]) accessor.emplace("bufferView", stand_in);
  // Invalid UTF-8 has already been refused with its line (schema.h), so this cannot throw.
  const std::string text = document.dump();
  std::string error, warning;
  tinygltf::TinyGLTF reader;
  reader.SetFsCallbacks(tinygltf::FsCallbacks{});
  if (!reader.LoadASCIIFromString(&asset.model, &error, &warning, text.c_str(),
                                  unsigned(text.size()), "", 0)) {
    return fail("", "cannot be read as glTF: " + printable(error),
                "correct the file or export it again");
  }
  asset.model.bufferViews.pop_back();
  for (tinygltf::Accessor& accessor : asset.model.accessors) {
    if (accessor.bufferView == stand_in) accessor.bufferView = -1;
  }
  return {};
}

}  // namespace

bool is_supported(const std::string& extension) {
  return std::ranges::find(kSupported, extension) != kSupported.end();
}

bool Asset::uses(const std::string& extension) const {
  return std::ranges::find(extensions, extension) != extensions.end();
}

void Asset::warn(std::string text) {
  if (warnings.size() > kMaxWarnings || std::ranges::find(warnings, text) != warnings.end()) return;
  warnings.push_back(warnings.size() < kMaxWarnings ? std::move(text)
                                                    : "further warnings were left out");
}

void Asset::warn_at(const std::string& place, const std::string& text, std::uint64_t amount) {
  auto same = std::ranges::find(repeated, text, &RepeatedWarning::text);
  if (same == repeated.end()) {
    if (repeated.size() >= kMaxWarnings) return warn("further warnings were left out");
    same = repeated.insert(same, RepeatedWarning{text, place, 0, 0});
  }
  ++same->places;
  same->amount += amount;
}

std::vector<std::string> Asset::all_warnings() const {
  std::vector<std::string> all = warnings;
  for (const RepeatedWarning& one : repeated) {
    std::string text = one.text;
    if (const std::size_t at = text.find("{}"); at != std::string::npos) {
      text.replace(at, 2, std::to_string(one.amount));
    }
    const std::string more =
        one.places == 1 ? "" : " and " + std::to_string(one.places - 1) + " more";
    all.push_back(one.first_place + more + ": " + text);
  }
  return all;
}

Result<Asset> open_asset(std::span<const std::byte> bytes, const std::string& directory,
                         const LoadLimits& limits) {
  constexpr std::size_t kMaxJsonBytes = std::size_t(1) << 29;
  Result<Container> container = open_container(bytes);
  if (!container) return tl::unexpected(container.error());
  if (container->json.size() > kMaxJsonBytes) {
    return fail("JSON", "has more than 512 MB",
                "keep the data in a binary buffer, not in the text");
  }
  Result<Document> document = read_document(container->json);
  if (!document) return tl::unexpected(document.error());

  Asset asset{.document = std::move(document->checked),
              .resources = Resources(directory, limits),
              .limits = limits,
              .warnings = container->warnings};
  if (auto done = check_extensions(asset, document->extensions); !done)
    return tl::unexpected(done.error());
  if (auto done = parse_model(asset); !done) return tl::unexpected(done.error());
  if (auto done = read_buffers(asset, container->binary); !done)
    return tl::unexpected(done.error());
  if (auto done = check_buffer_views(asset); !done) return tl::unexpected(done.error());
  asset.bytes = bytes.size() + asset.resources.total_bytes();
  return asset;
}

Result<Asset> open_asset(const std::string& path, const LoadLimits& limits) {
  const auto bytes = read_whole_file(path, limits.max_file_bytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string directory = std::filesystem::path(path).parent_path().string();
  return open_asset(*bytes, directory.empty() ? "." : directory, limits);
}

const json* find(const json& value, std::initializer_list<const char*> path) {
  const json* at = &value;
  for (const char* name : path) {
    const auto found = at->find(name);
    if (found == at->end()) return nullptr;
    at = &*found;
  }
  return at;
}

Result<std::span<const std::byte>> view_bytes(const Asset& asset, std::size_t buffer_view) {
  const tinygltf::BufferView& view = asset.model.bufferViews[buffer_view];
  const auto& buffer = asset.buffers[std::size_t(view.buffer)];
  if (!buffer) {
    return fail(
        entry("buffer", std::size_t(view.buffer)), "has no data in this file",
        "put a file with the data beside the scene and name that file in the buffer's 'uri'");
  }
  return std::span<const std::byte>(*buffer).subspan(view.byteOffset, view.byteLength);
}

Result<ImageFile> image_file(Asset& asset, const json& image) {
  if (image.contains("uri")) {
    const auto bytes = asset.resources.read(image["uri"].get_ref<const std::string&>());
    if (!bytes) return tl::unexpected(bytes.error());
    return ImageFile{*bytes, **bytes};
  }
  if (image.contains("bufferView")) {
    const auto bytes = view_bytes(asset, image["bufferView"].get<std::size_t>());
    if (!bytes) return tl::unexpected(bytes.error());
    return ImageFile{nullptr, *bytes};
  }
  return fail("", "has neither a URI nor a buffer view", "embed the image or name its file");
}

}  // namespace glassbox::gltf
