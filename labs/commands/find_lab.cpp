#include "labs/commands/find_lab.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace glassbox::labs {

namespace {

namespace fs = std::filesystem;

// The program's directory in the user's cache. Without a home directory it is in the system's
// temporary directory, where another user could have made it first; then it is refused.
Result<fs::path> cache() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* home = std::getenv("HOME");
  if (cache != nullptr && *cache == '/') return fs::path(cache) / "glassbox";
  if (home != nullptr && *home == '/') return fs::path(home) / ".cache/glassbox";
  const fs::path base = fs::temp_directory_path() / fmt::format("glassbox-{}", getuid());
  ::mkdir(base.c_str(), 0700);
  struct stat status = {};
  if (::lstat(base.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) ||
      status.st_uid != ::geteuid() || (status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
    return fail(base.string(), "is not a directory that only you can write to",
                "set HOME or XDG_CACHE_HOME to a directory of your own");
  return base / "glassbox";
}

// The directory for a folder in which a lab is checked. Each folder has its own.
fs::path cache_for(const fs::path& folder, const fs::path& cache) {
  const std::size_t place = std::hash<std::string>{}(folder.string());
  return cache / "labs" / fmt::format("{}-{:016x}", folder.filename().string(), place);
}

// The lab's name from lab.json. Empty if there is no such file; an error if the file names no lab.
Result<std::string> named_lab(const fs::path& folder) {
  std::error_code error;
  const fs::path file = folder / "lab.json";
  if (!fs::exists(file, error)) return std::string();
  const auto text = labs::read_text_file(file);
  if (!text) return tl::unexpected(text.error());
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  const auto name = json.is_object() ? json.find("lab") : json.end();
  if (!json.is_object() || name == json.end() || !name->is_string())
    return fail(file.string(), "does not name a lab",
                "write {\"lab\": \"05-clipping\"} into it, with the name of your lab");
  return name->get<std::string>();
}

// Whether no symbolic link is on the path of build/check in the folder, or among the files in
// build/check. A link in a submission could redirect what is written to another place.
bool has_no_symlinks(const fs::path& place) {
  std::error_code error;
  const fs::path build = place / "build", check = build / "check";
  if (fs::is_symlink(build, error) || fs::is_symlink(check, error)) return false;
  for (fs::recursive_directory_iterator at(check, error), end; !error && at != end;
       at.increment(error)) {
    if (at->is_symlink(error)) return false;
  }
  return true;
}

// Does what is needed for all kinds of labs: finds student.cpp and chooses where it is built: in
// the folder if it can be, unless `builds_in_cache`.
Result<LabFolder> make_lab_folder(const std::string& folder, const fs::path& place,
                                  bool builds_in_cache) {
  LabFolder found;
  found.student = place / "student.cpp";
  std::error_code error;
  if (!fs::is_regular_file(found.student, error))
    return fail((fs::path(folder) / "student.cpp").string(), "does not exist",
                "put your code into this file; glassbox lab start makes it");
  const bool writable = access(place.c_str(), W_OK) == 0;
  const auto own = cache();
  if (!own) return tl::unexpected(own.error());
  found.cache = cache_for(place, *own);
  found.kits = *own / "kits";
  const bool there = !builds_in_cache && writable && has_no_symlinks(place);
  found.build_dir = there ? place / "build" / "check" : found.cache;
  return found;
}

Result<fs::path> open_directory(const std::string& folder) {
  std::error_code error;
  fs::path place = fs::canonical(folder, error);
  if (error || !fs::is_directory(place, error))
    return fail(folder, "is not a folder",
                "name a folder that glassbox lab start has made, or make one with this command");
  return place;
}

Result<LabFolder> open_started_lab(const std::string& folder) {
  const auto place = open_directory(folder);
  if (!place) return tl::unexpected(place.error());
  const auto named = named_lab(*place);
  if (!named) return tl::unexpected(named.error());
  const bool own = named->empty();
  const auto lab =
      find_lab(own ? place->filename().string() : *named, (fs::path(folder) / "lab.json").string());
  if (!lab && own)
    return fail(folder, "is not the folder of a lab: it has no lab.json",
                "name a folder that glassbox lab start has made, or give the lab with --lab");
  if (!lab) return tl::unexpected(lab.error());
  auto found = make_lab_folder(folder, *place, own);
  if (found) found->lab = *lab;
  return found;
}

Result<LabFolder> open_external_lab(const std::string& folder, const std::string& lab_dir) {
  const auto place = open_directory(folder);
  if (!place) return tl::unexpected(place.error());
  const auto sources = with_lab_dir(labs::find_sources(), lab_dir);
  if (!sources) return tl::unexpected(sources.error());
  auto found = make_lab_folder(folder, *place, *place == sources->outside);
  if (!found) return found;
  const auto lab = labs::grading::load_outside_lab(*sources, found->cache / "judge");
  if (!lab) return tl::unexpected(lab.error());
  found->lab = *lab;
  found->outside = sources->outside;
  return found;
}

Result<LabFolder> open_submission(const std::string& folder, const std::string& name) {
  const auto place = open_directory(folder);
  if (!place) return tl::unexpected(place.error());
  const auto lab = find_lab(name, "--lab");
  if (!lab) return tl::unexpected(lab.error());
  // A lab.json that names no lab is ignored here: the submission may contain any files.
  if (const auto named = named_lab(*place); named && !named->empty()) {
    const auto other = find_lab(*named);
    if (!other || *other != *lab)
      return fail("--lab " + name,
                  fmt::format("{}/lab.json says that it is lab {}", folder, *named),
                  "leave --lab out, or name the folder of the other lab");
  }
  auto found = make_lab_folder(folder, *place, true);
  if (!found) return found;
  found->lab = *lab;
  return found;
}

}  // namespace

std::string lab_names() {
  const auto& all = labs::all_labs();
  if (all.empty()) return "none";
  std::string names;
  for (const labs::Lab& lab : all)
    names += (names.empty() ? "" : ", ") + fmt::format("{} ({})", lab.number, lab.folder);
  return names;
}

Result<const labs::Lab*> find_lab(const std::string& name, const std::string& asked_by) {
  for (const labs::Lab& lab : labs::all_labs()) {
    const std::string& folder = lab.folder;
    const std::size_t dash = folder.find('-');
    const std::string topic = dash == std::string::npos ? folder : folder.substr(dash + 1);
    if (name == std::to_string(lab.number) || name == fmt::format("{:02}", lab.number) ||
        name == folder || name == topic)
      return &lab;
  }
  return fail(asked_by, fmt::format("there is no lab \"{}\"", name),
              fmt::format("the labs are {}", lab_names()));
}

Result<LabFolder> open_lab_folder(const LabSelection& selection) {
  if (!selection.lab_dir.empty()) return open_external_lab(selection.folder, selection.lab_dir);
  if (!selection.lab.empty()) return open_submission(selection.folder, selection.lab);
  return open_started_lab(selection.folder);
}

}  // namespace glassbox::labs
