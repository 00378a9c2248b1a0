// What a student hands in for a measurement: a small JSON file. Checks whether another measurement
// confirms it.
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
  study::Quartiles ns;  // per item
  // The experiment's own ways at that place that certainly take longer, or less long: their
  // quartiles do not overlap with these.
  std::vector<std::string> faster_than, slower_than;
};

struct Claim {
  std::string lab;         // "06-rasterisation"
  std::string code;        // the digest of student.cpp
  std::string experiment;  // "D-3"
  std::string machine, version;
  std::vector<ClaimedPoint> points;
};

// Makes a claim from an experiment that has the student's series among its own; the points of those
// series become the claim's points.
Claim claim_of(const std::string& lab, const std::string& code, const study::Origin& origin,
               const study::ExperimentResult& result, const std::vector<std::string>& series);

nlohmann::ordered_json claim_json(const Claim& claim);
// Reads a claim from the file's contents. An error says what is missing in it.
Result<Claim> read_claim(const std::string& path, const std::string& text);

// The differences between a claim and a measurement, one line each: different code; points that are
// missing, superfluous or there twice; a different error; a way that is faster in one and slower in
// the other. The times themselves are not compared, because they may come from another machine.
std::vector<std::string> contradictions(const Claim& claimed, const Claim& measured);

}  // namespace glassbox::labs
