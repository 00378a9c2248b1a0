// The files that `glassbox diff` writes.
#pragma once

#include <span>

#include "app/diff/diff_request.h"

#include <glassbox/base/error.h>
#include <glassbox/compare/pictures/comparison.h>
#include <glassbox/compare/pictures/pairing.h>

namespace glassbox::app {

// Checks the paths of the reports before a long run: none may be one of the files to read, and two
// may not go to standard output. `directories`: two directories are compared.
Result<void> check_diff_reports(const DiffRequest& request, const Pairing& pairing,
                                bool directories);

// Writes the reports. Notes about heat maps that there cannot be go to standard error.
Result<void> write_diff_reports(const DiffRequest& request, std::span<const Comparison> comparisons,
                                bool directories);

}  // namespace glassbox::app
