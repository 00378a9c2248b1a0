// The convention slips: mistakes that leave every number right but for a sign, an order or a unit.
#pragma once

#include <string>
#include <vector>

#include "labs/framework/lab.h"
#include "labs/framework/protocol.h"

namespace glassbox::labs {

struct Slip {
  std::string id;    // "z-sign"
  std::string text;  // "your z has the opposite sign: the eye looks down -z"
};

// In the order in which they are tried.
const std::vector<Slip>& known_slips();

// The sentence for an id; empty if there is no such slip.
std::string slip_text(const std::string& id);

// The slip under which the answers to all cases are as expected, where without it they are not; none if another slip explains
// them too. It is named on evidence only: every case must have been answered, at least one answer must be one that the slip
// changes, and none that is right may be one that it would have made wrong.
std::vector<std::string> find_slips(const std::vector<Case>& cases,
                                    const std::vector<CaseAnswer>& answers);

}  // namespace glassbox::labs
