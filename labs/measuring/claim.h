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
  study::Quartiles ns;  // the time per item
  // The experiment's own methods, at the same parameter, that are certainly slower, or certainly
  // faster, than the student's: the quartiles of their times do not overlap with those of `ns`.
  std::vector<std::string> faster_than, slower_than;
};

struct Claim {
  std::string lab;         // "06-rasterisation"
  std::string submission;  // whose times they are: the name of the measured folder
  std::string code;        // the digest of student.cpp
  std::string experiment;  // "D-3"
  std::string machine, version;
  std::vector<ClaimedPoint> points;
};

// Makes a claim from the result of an experiment. Its points are those of the student's `series` in
// the result.
Claim claim_of(const std::string& lab, const std::string& submission, const std::string& code,
               const study::Origin& origin, const study::ExperimentResult& result,
               const std::vector<std::string>& series);

// Whose times a claim has: the submission, the digest of its student.cpp, and the machine.
std::string owner_text(const Claim& claim);

nlohmann::ordered_json claim_json(const Claim& claim);
// Reads a claim from the file's contents. An error says what is missing in it.
Result<Claim> read_claim(const std::string& path, const std::string& text);

// The differences between a claim and a measurement, one line each: different code; points that are
// missing, superfluous or there twice; a different error; a method that is faster than the
// student's in the claim and slower in the measurement, or the reverse. The times themselves are
// not compared, because they may come from another machine.
std::vector<std::string> contradictions(const Claim& claimed, const Claim& measured);

}  // namespace glassbox::labs
