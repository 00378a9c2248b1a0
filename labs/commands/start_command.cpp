// glassbox lab start: makes a folder to do a lab in. glassbox lab export: writes the same files as
// an archive, for a class.
#include <filesystem>
#include <span>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/options/add_command.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/scratch_directory.h"
#include "cli/report/shell_line.h"
#include "labs/commands/commands.h"
#include "labs/commands/find_lab.h"
#include "labs/commands/starter.h"
#include "labs/framework/zip.h"
#include "labs/grading/vpl.h"

#include <glassbox/images/atomic_file.h>

namespace glassbox::labs {

class LabStartCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string lab_, folder_, lab_dir_;
};

class LabExportCommand {
public:
  void add_to(CLI::App& lab, int& exit_code);

private:
  int run() const;

  std::string lab_, output_, for_ = "students";
};

namespace {

namespace fs = std::filesystem;

struct Starter {
  const labs::Lab* lab;
  std::vector<labs::SourceFile> files;
};

// The starter (the files that a student starts with) of the lab with this name; if `lab_dir` is not
// empty, of the lab in that folder.
Result<Starter> starter_of(const std::string& name, const std::string& lab_dir = {}) {
  const auto sources = with_lab_dir(labs::find_sources(), lab_dir);
  if (!sources) return tl::unexpected(sources.error());
  const ScratchDirectory scratch;
  Result<const labs::Lab*> lab = nullptr;
  if (lab_dir.empty()) {
    lab = find_lab(name);
  } else {
    const auto place = scratch.make_private_directory("judge");
    lab = place ? labs::grading::load_outside_lab(*sources, *place) : tl::unexpected(place.error());
  }
  if (!lab) return tl::unexpected(lab.error());
  auto files = make_starter(*sources, **lab);
  if (!files) return tl::unexpected(files.error());
  return Starter{*lab, std::move(*files)};
}

// Refuses a folder that is not new or empty, so that nobody's work is overwritten.
Result<void> check_empty(const std::string& folder) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return {};
  if (!fs::is_directory(status))
    return fail(folder, "exists already, and is not a folder", "name a new folder");
  if (fs::is_empty(folder, error) && !error) return {};
  return fail(folder, "exists already, and is not empty",
              "name a new folder, so that none of your work is overwritten");
}

std::string suggestion(std::vector<std::string> words, const std::string& lab_dir) {
  if (!lab_dir.empty()) words.insert(words.end(), {"--lab-dir", lab_dir});
  const std::string line = shell_line({words});
  return line.empty() ? program_name() + " " + words[0] + " " + words[1] + " FOLDER" : line;
}

}  // namespace

void LabStartCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand("start", "makes a folder with the files to start a lab");
  command.footer(
      "Examples:\n"
      "  glassbox lab start 5 ~/lab5\n"
      "  glassbox lab start --lab-dir ~/labs/40-fog ~/lab40");
  command.add_option("LAB", lab_, "the lab's number or name; leave it out with --lab-dir")
      ->required();
  command.add_option("FOLDER", folder_, "a new or empty folder");
  add_lab_dir(command, lab_dir_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabStartCommand::run() const {
  // With --lab-dir, the only name given is that of the new folder.
  const bool one_name = folder_.empty();
  if (one_name && lab_dir_.empty())
    return refuse({"FOLDER", "", "is missing", "name a new folder after the lab"});
  if (!one_name && !lab_dir_.empty())
    return refuse(
        {"LAB", "", "names a lab, and --lab-dir names another", "give only one of the two"});
  const std::string& folder = one_name ? lab_ : folder_;
  const auto starter = starter_of(lab_, lab_dir_);
  if (!starter) return refuse(starter.error());
  if (const auto empty = check_empty(folder); !empty) return refuse(empty.error());
  for (const labs::SourceFile& file : starter->files) {
    if (const auto written = labs::write_if_changed(fs::path(folder) / file.path, file.text);
        !written)
      return refuse(written.error());
  }
  fmt::print(
      "Lab {}, {}, is in {}.\n\n"
      "  handout.md    the idea and the tasks: begin here\n"
      "  student.h     what each function must do\n"
      "  student.cpp   the functions that you write\n\n"
      "{}    what is right so far\n"
      "{}    the same after every save\n",
      starter->lab->number, starter->lab->title, folder,
      suggestion({"lab", "check", folder}, lab_dir_),
      suggestion({"lab", "watch", folder}, lab_dir_));
  return kSuccess;
}

void LabExportCommand::add_to(CLI::App& lab, int& exit_code) {
  CLI::App& command = *lab.add_subcommand(
      "export", "packs the files that students start a lab with into an archive, to hand out");
  command.footer(
      "Examples:\n"
      "  glassbox lab export 5 -o starter.zip\n"
      "  glassbox lab export 5 --for vpl -o lab5-vpl.zip\n\n"
      "Solutions and hidden checks are left out. For Moodle's Virtual Programming Lab, the "
      "archive\n"
      "also has two scripts, and a README.txt that says where they go.");
  command.add_option("LAB", lab_, "the lab's number or name")->required();
  command.add_option("-o,--output", output_, "the archive: a .zip file")
      ->type_name("FILE")
      ->required();
  command
      .add_option("--for", for_,
                  "who gets the archive: students (a folder to begin in), or vpl (Moodle)")
      ->check(CLI::IsMember({"students", "vpl"}))
      ->capture_default_str();
  command.callback([this, &exit_code] { exit_code = run(); });
}

int LabExportCommand::run() const {
  if (const auto good = check_extension(output_, ".zip"); !good) return refuse(good.error());
  const auto starter = starter_of(lab_);
  if (!starter) return refuse(starter.error());
  std::vector<labs::ZipEntry> entries;
  if (for_ == "vpl") {
    entries = labs::grading::vpl_files(*starter->lab, starter->files);
  } else {
    for (const labs::SourceFile& file : starter->files)
      entries.push_back({starter->lab->folder + "/" + file.path, file.text});
  }
  const auto bytes = labs::make_zip(entries);
  if (!bytes) return refuse(bytes.error());
  if (const auto written = write_file(output_, std::span(*bytes)); !written)
    return refuse(written.error());
  fmt::print("{}: {} files of lab {}, {}\n", output_, entries.size(), starter->lab->number,
             starter->lab->title);
  return kSuccess;
}

void add_start_command(CLI::App& lab, int& exit_code) {
  add_command<LabStartCommand>(lab, exit_code);
}

void add_export_command(CLI::App& lab, int& exit_code) {
  add_command<LabExportCommand>(lab, exit_code);
}

}  // namespace glassbox::labs
