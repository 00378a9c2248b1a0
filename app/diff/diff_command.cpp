// glassbox diff REFERENCE TEST: checks whether two pictures, or the pictures in two directories,
// are the same.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/diff/diff_reports.h"
#include "app/diff/diff_request.h"
#include "app/pixel/pixel_command.h"
#include "cli/options/add_command.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/progress.h"

#include <glassbox/base/error.h>
#include <glassbox/base/printable.h>
#include <glassbox/compare/pictures/approval.h>
#include <glassbox/compare/pictures/approve.h>
#include <glassbox/compare/pictures/compare_all.h>
#include <glassbox/compare/pictures/pairing.h>
#include <glassbox/compare/report/github.h>
#include <glassbox/compare/report/text.h>
#include <glassbox/images/read.h>

namespace glassbox::app {

class DiffCommand {
public:
  void add_to(CLI::App& app, int& exit_code);

private:
  int run();
  Result<void> check_directories();
  Result<Pairing> pair_up() const;
  Result<ApprovalRequest> approval_request() const;
  std::vector<Comparison> compare(const Pairing& pairing) const;
  void print(const std::vector<Comparison>& comparisons, const Pairing& pairing) const;
  int approve(const std::vector<Comparison>& comparisons, const ApprovalRequest& approval) const;

  DiffRequest request_;
  bool directories_ = false;
};

namespace {

namespace fs = std::filesystem;

bool is_directory(const std::string& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

int exit_code_of(Verdict verdict) {
  if (passes(verdict)) return kSuccess;
  return verdict == Verdict::kDifferent ? kFailure : kBadInput;
}

int exit_code_of(const std::vector<Comparison>& comparisons) {
  int worst = kSuccess;
  for (const Comparison& one : comparisons) worst = std::max(worst, exit_code_of(one.verdict));
  return worst;
}

// The names in the list of --approve-list; "-" is standard input.
Result<std::vector<std::string>> read_list(const std::string& path) {
  constexpr std::uint64_t kMaxBytes = std::uint64_t(1) << 26;
  const std::string file = path == "-" ? "standard input" : path;
  const auto bytes = path == "-" ? read_standard_input(kMaxBytes) : read_file(path, kMaxBytes);
  if (!bytes) {
    return tl::unexpected(Error{file, "", bytes.error().cause,
                                "give --approve-list the names of pictures, one a line"});
  }
  auto names = parse_approval_list({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
  if (!names) names.error().file = file;
  return names;
}

}  // namespace

void DiffCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("diff", "compare pictures, exactly or with a tolerance");
  add_diff_options(command, request_);
  command.callback([this, &exit_code] { exit_code = run(); });
}

// Finds out whether two directories are compared. A reference directory that does not exist yet
// has no pictures.
Result<void> DiffCommand::check_directories() {
  const bool is_first_run = is_directory(request_.test) && !may_exist(request_.reference);
  directories_ = is_directory(request_.reference) || is_directory(request_.test);
  if (directories_ && !is_first_run &&
      !(is_directory(request_.reference) && is_directory(request_.test))) {
    return tl::unexpected(
        Error{is_directory(request_.reference) ? request_.test : request_.reference, "",
              "is not a directory, but the other one is", "name two pictures or two directories"});
  }
  if (!directories_ && (!request_.approve_patterns.empty() || request_.approve_list)) {
    return fail("--approve-matching, --approve-list",
                "these choose among the pictures of a directory",
                "use --approve for a single picture");
  }
  return {};
}

Result<Pairing> DiffCommand::pair_up() const {
  if (directories_) return pair_directories(request_.reference, request_.test);
  return Pairing{{{request_.test, request_.reference, request_.test, may_exist(request_.reference),
                   may_exist(request_.test)}},
                 {}};
}

Result<ApprovalRequest> DiffCommand::approval_request() const {
  ApprovalRequest approval{request_.approve_patterns, {}};
  if (request_.approve_all) approval.patterns = {"*"};
  if (!request_.approve_list) return approval;
  auto names = read_list(*request_.approve_list);
  if (!names) return tl::unexpected(names.error());
  approval.names = *std::move(names);
  return approval;
}

std::vector<Comparison> DiffCommand::compare(const Pairing& pairing) const {
  Progress progress;
  auto comparisons = compare_all(pairing.pictures, request_.options, [&](std::size_t i) {
    progress.phase(fmt::format("comparing {} ({} of {})", printable(pairing.pictures[i].name),
                               i + 1, pairing.pictures.size()));
  });
  progress.done();
  return comparisons;
}

void DiffCommand::print(const std::vector<Comparison>& comparisons, const Pairing& pairing) const {
  if (request_.github) {
    fmt::print(request_.is_silent() ? stderr : stdout, "{}", github_annotations(comparisons));
  }
  const bool is_approved = request_.approve_all && comparisons.front().verdict == Verdict::kNew;
  if (!directories_ && comparisons.front().error && !is_approved) {
    refuse(*comparisons.front().error);
    return;
  }
  if (request_.is_silent()) return;
  for (const Comparison& one : comparisons) {
    const std::string more = comparison_details(one);
    if (directories_ && one.verdict == Verdict::kSame && more.empty()) continue;
    fmt::print("{}\n{}", comparison_line(one), more);
  }
  const std::string alpha = opaque_alpha_text(comparisons);
  if (!alpha.empty()) fmt::print("note: {}\n", alpha);
  for (const std::string& orphan : pairing.orphans) {
    fmt::print("note: {} belongs to no picture\n", printable(orphan, 400));
  }
  if (directories_ && !may_exist(request_.reference) && !request_.approves()) {
    fmt::print(
        "note: the reference folder {} does not exist yet: look at the pictures; --approve "
        "creates it and makes them the references\n",
        printable(request_.reference, 400));
  }
  if (directories_) fmt::print("{}\n", summary_line(comparisons));
}

// Approves what was chosen, and goes on where a picture cannot be approved. The exit code is that
// of the pictures that are not approved.
int DiffCommand::approve(const std::vector<Comparison>& comparisons,
                         const ApprovalRequest& approval) const {
  const ApprovalChoice choice = choose_for_approval(comparisons, approval);
  int exit_code = kSuccess;
  for (const std::string& sentence : choice.unknown) {
    exit_code = refuse({"", "", sentence, "the names are those that glassbox diff prints"});
  }
  std::vector<bool> is_approved(comparisons.size());
  for (const std::size_t i : choice.chosen) {
    const Comparison& one = comparisons[i];
    if (one.verdict != Verdict::kDifferent && one.verdict != Verdict::kNew &&
        one.verdict != Verdict::kWithinTolerance) {
      continue;
    }
    if (const auto done = approve_picture(one.reference.path, one.test.path); !done) {
      exit_code = refuse(done.error());
      continue;
    }
    is_approved[i] = true;
    if (!request_.is_silent()) fmt::print("approved: {}\n", printable(one.reference.path, 400));
  }
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    if (!is_approved[i]) exit_code = std::max(exit_code, exit_code_of(comparisons[i].verdict));
  }
  return exit_code;
}

int DiffCommand::run() {
  if (request_.approves() && on_ci_server()) {
    return refuse({"", "--approve",
                   "the environment variable CI is set, so nobody looks at the pictures",
                   "approve the pictures on your own machine"});
  }
  if (const auto legal = check_directories(); !legal) return refuse(legal.error());
  const auto approval = approval_request();
  if (!approval) return refuse(approval.error());
  const auto pairing = pair_up();
  if (!pairing) return refuse(pairing.error());
  if (const auto legal = check_diff_reports(request_, *pairing, directories_); !legal) {
    return refuse(legal.error());
  }
  request_.options.inspect_command = pixel_command_line;
  request_.options.keep_pixels = !directories_ && (request_.heat || request_.page);
  const std::vector<Comparison> comparisons = compare(*pairing);
  if (const auto written = write_diff_reports(request_, comparisons, directories_); !written) {
    return refuse(written.error());
  }
  print(comparisons, *pairing);
  return request_.approves() ? approve(comparisons, *approval) : exit_code_of(comparisons);
}

void add_diff_command(CLI::App& app, int& exit_code) {
  add_command<DiffCommand>(app, exit_code);
}

}  // namespace glassbox::app
