// The convention slips: mistakes after which every number is right except for a sign, an order or a
// unit.
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

// All slips, in the order in which they are tried.
const std::vector<Slip>& known_slips();

// The sentence for an id; empty if there is no such slip.
std::string slip_text(const std::string& id);

// The slip that explains the answers: if it is made, the answers to all cases are as expected, and
// without it they are not. Empty if another slip explains them too. A slip is named only on
// evidence: every case must have been answered, the slip must change at least one answer, and it
// must not make wrong any answer that is right.
std::vector<std::string> find_slips(const std::vector<Case>& cases,
                                    const std::vector<CaseAnswer>& answers);

}  // namespace glassbox::labs
