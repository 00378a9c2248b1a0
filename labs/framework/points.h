// How a lab's points are shared: points.json beside the lab, read at run time.
//
//   {"points": 100,                            what the tasks should sum to
//    "tasks": {"5.1": 15, "5.2": 20},          points of each task
//    "checks": {"triangles around a point": 2},  weights of visible checks in their task; of others: 1
//    "hidden": {"5.1": 3},                     weight of a task's hidden checks together; else 1 for each of them
//    "whole": ["triangles around a point"]}    visible checks that give their points only where every case is right
//
// A task's points are shared by its checks according to their weights, and a check's points, unless it counts as a whole, equally by
// its cases. There is no name
// of a hidden check in the file: students have it too. All of it may be left out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "labs/framework/lab.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct Shares {
  Lab lab;  // with the points and weights of the file
  std::vector<std::string>
      warnings;  // sums that are not what the file says; tasks and checks that the lab does not have
};

// The lab as it is where there is no such file; an error where it is none.
Result<Shares> read_shares(const Lab& lab, const std::filesystem::path& file);

// The points of one of the check's `cases`.
double points_of_case(const Lab& lab, const Check& check, std::size_t cases);

}  // namespace glassbox::labs
