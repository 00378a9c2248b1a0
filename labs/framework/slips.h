// Slips: typical mistakes with a convention, after which every number is right except for a sign,
// an order or a unit.
#pragma once

#include <string>
#include <vector>

#include "labs/framework/lab.h"
#include "labs/framework/protocol.h"

namespace glassbox::labs {

struct Slip {
  std::string id;    // "z-sign"
  std::string text;  // "your z has the opposite sign: the eye looks down -z"
  // The slip of another function that leads to the same answers. Where a report names that one, it
  // does not name this one.
  std::string cause = {};
};

// All slips (typical mistakes), in the order in which they are tried.
const std::vector<Slip>& known_slips();

// The sentence with which a report explains the slip (typical mistake) `id`; empty if it is
// unknown.
std::string slip_text(const std::string& id);

// The slip (typical mistake) that explains the wrong answers of a check; empty if none or more than
// one does. It is named only on evidence: every case must have been answered, the slip must have
// changed at least one answer, every wrong answer must be what the slip leads to, and the slip must
// not make any right answer wrong.
std::vector<std::string> find_slips(const std::vector<Case>& cases,
                                    const std::vector<CaseAnswer>& answers);

}  // namespace glassbox::labs
