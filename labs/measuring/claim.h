// What a student hands in of a measurement: a small JSON, and whether another measurement bears it out.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "study/experiment/results.h"

#include <glassbox/base/error.h>

namespace glassbox::labs {

struct ClaimedPoint {
  std::string series;
  std::string measure, scene;
  double parameter = 0;
  double error = 0;
  study::Quartiles ns;  // for an item
  // The experiment's own ways at that place that take longer for certain, or less long: whose quartiles do not overlap.
  std::vector<std::string> faster_than, slower_than;
};

struct Claim {
  std::string lab;         // "06-rasterisation"
  std::string code;        // a digest of student.cpp
  std::string experiment;  // "D-3"
  std::string machine, version;
  std::vector<ClaimedPoint> points;
};

// Of an experiment that has the student's series among its own: those are points.
Claim claim_of(const std::string& lab, const std::string& code, const study::Origin& origin,
               const study::ExperimentResult& result, const std::vector<std::string>& series);

nlohmann::ordered_json claim_json(const Claim& claim);
// Of the file's contents. An error says what is missing in it.
Result<Claim> read_claim(const std::string& path, const std::string& text);

// Where a claim is not what was measured, a line each: another code, points that are missing, too many or there twice, an error that is
// another number, a way that is faster in the one and slower in the other. Times themselves are another machine's, and are not compared.
std::vector<std::string> contradictions(const Claim& claimed, const Claim& measured);

}  // namespace glassbox::labs
