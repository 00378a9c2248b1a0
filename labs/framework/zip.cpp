#include "labs/framework/zip.h"

#include <zip.h>

#include <memory>

namespace glassbox::labs {

namespace {

tl::unexpected<Error> zip_failure(const char* what) {
  return fail("zip", what, "free some memory and try again");
}

struct CloseSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Source = std::unique_ptr<zip_source_t, CloseSource>;

// The date of every file: 1980-01-01, in the format of the archive, which has no time zone.
constexpr zip_uint16_t kDosTime = 0, kDosDate = (1 << 5) | 1;

bool add_entry(zip_t* archive, const ZipEntry& entry) {
  // No copy is needed: `entry.text` lives longer than the archive, which reads it only when it is
  // closed.
  zip_source_t* data = zip_source_buffer(archive, entry.text.data(), entry.text.size(), 0);
  if (data == nullptr) return false;
  const zip_int64_t at = zip_file_add(archive, entry.path.c_str(), data, ZIP_FL_ENC_UTF_8);
  if (at < 0) {
    zip_source_free(data);
    return false;
  }
  const auto index = static_cast<zip_uint64_t>(at);
  const zip_uint32_t mode = entry.executable ? 0100755 : 0100644;
  return zip_file_set_dostime(archive, index, kDosTime, kDosDate, 0) == 0 &&
         zip_file_set_external_attributes(archive, index, 0, ZIP_OPSYS_UNIX, mode << 16) == 0;
}

}  // namespace

Result<std::vector<std::byte>> make_zip(const std::vector<ZipEntry>& entries) {
  zip_error_t error;
  zip_error_init(&error);
  const Source buffer(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!buffer) return zip_failure("there is not enough memory for the archive");
  zip_t* archive = zip_open_from_source(buffer.get(), ZIP_TRUNCATE, &error);
  if (archive == nullptr) return zip_failure("the archive cannot be begun");
  zip_source_keep(buffer.get());
  for (const ZipEntry& entry : entries) {
    if (add_entry(archive, entry)) continue;
    zip_discard(archive);
    return zip_failure("a file cannot be added to the archive");
  }
  if (zip_close(archive) != 0) {
    zip_discard(archive);
    return zip_failure("the archive cannot be finished");
  }
  zip_stat_t stat;
  if (zip_source_stat(buffer.get(), &stat) != 0 || zip_source_open(buffer.get()) != 0)
    return zip_failure("the archive cannot be read back");
  std::vector<std::byte> bytes(stat.size);
  const zip_int64_t got = zip_source_read(buffer.get(), bytes.data(), bytes.size());
  zip_source_close(buffer.get());
  if (got != zip_int64_t(bytes.size())) return zip_failure("the archive cannot be read back");
  return bytes;
}

Result<std::vector<ZipEntry>> read_zip(const std::vector<std::byte>& bytes) {
  const auto refused = [] {
    return fail("zip", "is not a zip archive, or is damaged", "make the archive again");
  };
  if (bytes.empty()) return refused();  // libzip would take no bytes for an empty archive
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source == nullptr) return zip_failure("there is not enough memory for the archive");
  zip_t* archive = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (archive == nullptr) {
    zip_source_free(source);
    return refused();
  }
  std::vector<ZipEntry> entries;
  bool good = true;
  for (zip_int64_t i = 0; good && i < zip_get_num_entries(archive, 0); ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    zip_stat_t stat;
    zip_file_t* file = zip_fopen_index(archive, index, 0);
    good = file != nullptr && zip_stat_index(archive, index, 0, &stat) == 0 &&
           stat.size <= bytes.size() * 1100;  // deflate makes data at most 1032 times smaller
    if (good) {
      zip_uint8_t system = 0;
      zip_uint32_t attributes = 0;
      zip_file_get_external_attributes(archive, index, 0, &system, &attributes);
      ZipEntry entry{stat.name, std::string(stat.size, '\0'), ((attributes >> 16) & 0111) != 0};
      good =
          zip_fread(file, entry.text.data(), entry.text.size()) == zip_int64_t(entry.text.size());
      entries.push_back(std::move(entry));
    }
    if (file != nullptr) zip_fclose(file);
  }
  zip_discard(archive);
  if (!good) return refused();
  return entries;
}

}  // namespace glassbox::labs
