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

// The slips under which the answers to all cases are as expected, where without one they are not. One is named only on
// evidence: every case must have been answered, and at least one answer must be one that the slip changes.
std::vector<std::string> find_slips(const std::vector<Case>& cases,
                                    const std::vector<CaseAnswer>& answers);

}  // namespace glassbox::labs
