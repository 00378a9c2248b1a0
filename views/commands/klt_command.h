// glassbox views klt: finds the directions in which the bands of pictures vary.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/options/cli_fwd.h"
#include "views/commands/klt_report.h"
#include "views/klt/band_files.h"

namespace glassbox::views {

class ViewsKltCommand {
public:
  void add_to(CLI::App& views, int& exit_code);

private:
  int run();
  Result<void> check_outputs() const;
  // Checks the files in the output folder too: none may be an input or occur twice.
  Result<void> check_files(int kept) const;
  // Reads the sizes of the bands into files_.
  Result<void> open();
  Result<void> check_memory(int kept) const;
  Result<KltInput> read() const;
  Result<void> write_outputs(const KltInput& input, const KltReport& report) const;
  Result<void> write_folder(const KltInput& input, const KltReport& report) const;

  std::uint64_t most_bytes() const { return std::uint64_t(max_megabytes_) << 20; }

  std::vector<std::string> bands_;
  views::BandFiles files_;  // set for the generated planet too, which has no files
  bool is_planet_ = false;
  std::optional<int> kept_;
  std::uint32_t max_megabytes_ = 2048;
  std::optional<std::string> output_, globe_, json_output_, page_;
  std::vector<const CLI::Option*> options_;
};

}  // namespace glassbox::views
