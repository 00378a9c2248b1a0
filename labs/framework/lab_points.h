// How a lab's points are divided: points.json beside the lab, read at run time (docs/labs.md shows
// its entries).
//
// A task's points are divided among its checks according to their weights, and a check's points
// equally among its cases, unless the check is all or nothing. The file contains no name of a
// hidden check, because students have it too. Every entry may be left out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/lab.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct LabPoints {
  Lab lab;  // with the points and weights of the file
  // sums that differ from the file's "points"; tasks and checks that the lab does not have
  std::vector<std::string> warnings;
};

// The lab with the points and weights of the file; unchanged if there is no such file. It is an
// error if the file is not a valid points.json.
Result<LabPoints> read_lab_points(const Lab& lab, const std::filesystem::path& file);

// The points for one case of a check that has `cases` cases.
double points_of_case(const Lab& lab, const Check& check, std::size_t cases);

}  // namespace glassbox::labs
