// How a lab's points are shared: points.json beside the lab, read at run time.
//
//   {"points": 100,                    the sum that the tasks' points should have
//    "tasks": {"5.1": 15, "5.2": 20},  points of each task
//    "checks": {"triangles around a point": 2},
//                                      weights of visible checks in their task; 1 where not given
//    "hidden": {"5.1": 3},             weight of a task's hidden checks together; 1 for each of
//                                      them where it is not given
//    "whole": ["triangles around a point"]}
//                                      visible checks that give points only if every case is right
//
// A task's points are shared among its checks according to their weights. A check's points are
// shared equally among its cases, unless the check counts as a whole. The file contains no name of
// a hidden check, because students have it too. Every entry may be left out.
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
  // sums that are not what the file says; tasks and checks that the lab does not have
  std::vector<std::string> warnings;
};

// The lab with the points and weights of the file; unchanged if there is no such file. It is an
// error if the file is not a valid points.json.
Result<LabPoints> read_lab_points(const Lab& lab, const std::filesystem::path& file);

// The points of one of the check's `cases`.
double points_of_case(const Lab& lab, const Check& check, std::size_t cases);

}  // namespace glassbox::labs
