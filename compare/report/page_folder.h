// The folder beside a page that has the pictures which the page loads when they are looked at.
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/base/error.h>

namespace glassbox {

// The folder of a page: "out/report-files" for "out/report.html".
std::string page_folder(const std::string& page);

// Where the page finds a file, and what the file tells it.
struct PageFile {
  std::string address;  // relative to the page, percent-encoded
  std::string path;     // the same for people; not the file's name where that is not printable
  std::string stamp;    // a checksum: the page refuses the file of another page
};

// An error if write_page_file would refuse to replace one of the files 1 to `count`.
Result<void> check_page_files(const std::string& page, std::size_t count);

// Writes the file with this index, completely or not at all. It is a script that calls the page's
// function `glassboxPictures` with the stamp and `blobs`, which map names to texts in base64: a
// page that was opened without a server may load scripts, but not read other files. Makes the
// folder if there is none. An error if there is a file of this name that is not such a script.
Result<PageFile> write_page_file(const std::string& page, std::size_t index,
                                 const nlohmann::ordered_json& blobs);

// Removes the files of an earlier page of the same name with an index above `last`. Other files,
// and files that cannot be removed, stay.
void remove_later_page_files(const std::string& page, std::size_t last);

}  // namespace glassbox
