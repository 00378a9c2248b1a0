#include "labs/framework/slips.h"

#include <algorithm>
#include <set>

#include "labs/framework/compare.h"
#include "labs/framework/slip_variants.h"

namespace glassbox::labs {

namespace {

using Values = std::vector<double>;

// The answers to a check's cases, and the fields that need no explanation because they are right.
struct Evidence {
  const std::vector<Case>& cases;
  const std::vector<CaseAnswer>& answers;
  std::set<std::string> right_fields;  // fields that are right in every case
};

Evidence collect(const std::vector<Case>& cases, const std::vector<CaseAnswer>& answers) {
  std::set<std::string> wrong, all;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].judge) continue;
    for (const Expected& expected : cases[i].expected) {
      all.insert(expected.field);
      if (compare(expected, answers[i].answer).first) wrong.insert(expected.field);
    }
  }
  Evidence evidence{cases, answers, {}};
  std::set_difference(all.begin(), all.end(), wrong.begin(), wrong.end(),
                      std::inserter(evidence.right_fields, evidence.right_fields.end()));
  return evidence;
}

void note_changes(const Values& before, const Values& after, std::set<double>& changed) {
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    if (distance_between(before[i], after[i]) > 0) changed.insert(before[i]);
  }
}

// The shape of an answer's field; it is guessed from the size if the case, which has its own judge,
// does not describe the field.
Expected shape_of(const Case& input, const Answer::Field& field) {
  for (const Expected& expected : input.expected) {
    if (expected.field == field.name) return expected;
  }
  Expected guess;
  guess.field = field.name;
  const std::size_t size = field.values.size();
  if (size == 16 || size == 9) guess.shape = Shape::kMatrix;
  if (size == 3 || size == 4) guess.shape = Shape::kPoint;
  guess.values = field.values;
  return guess;
}

// Whether the mistake can be undone, in one of its forms, in all fields of the answer so that the
// case's own judge accepts the result. If the answer is right as it is, it must stay right, or have
// no field in which the mistake can be made.
bool undone_satisfies_judge(const Case& input, const Answer& answer, const AnswerVariant& variant,
                            std::set<double>& changed) {
  const bool right = !input.judge(answer);
  std::vector<std::vector<Values>> ways;
  std::size_t most = 0;
  for (const Answer::Field& field : answer.fields()) {
    ways.push_back(variant.undo(shape_of(input, field), field.values));
    most = std::max(most, ways.back().size());
  }
  for (std::size_t way = 0; way < most; ++way) {
    Answer undone;
    for (std::size_t f = 0; f < ways.size(); ++f) {
      const Answer::Field& field = answer.fields()[f];
      undone.emit(field.name, way < ways[f].size() ? ways[f][way] : field.values);
    }
    if (input.judge(undone)) continue;
    for (std::size_t f = 0; f < ways.size() && !right; ++f)
      note_changes(answer.fields()[f].values, undone.fields()[f].values, changed);
    return true;
  }
  return right && most == 0;
}

bool undone_is_right(const Expected& expected, const Values& actual, const AnswerVariant& variant,
                     std::set<double>& changed) {
  const bool right = !compare(expected, actual).first;
  const std::vector<Values> ways = variant.undo(expected, actual);
  for (const Values& undone : ways) {
    if (compare(expected, undone).first) continue;
    if (!right) note_changes(actual, undone, changed);
    return true;
  }
  return right && ways.empty();
}

bool explains(const Evidence& evidence, const AnswerVariant& variant) {
  std::set<double> changed;
  for (std::size_t i = 0; i < evidence.cases.size(); ++i) {
    const Case& input = evidence.cases[i];
    const Answer& answer = evidence.answers[i].answer;
    if (input.judge) {
      if (!undone_satisfies_judge(input, answer, variant, changed)) return false;
      continue;
    }
    for (const Expected& expected : input.expected) {
      if (evidence.right_fields.count(expected.field) != 0) continue;
      const Values* actual = find_field(answer, expected.field);
      if (actual == nullptr || !undone_is_right(expected, *actual, variant, changed)) return false;
    }
  }
  return changed.size() >= variant.evidence;
}

// Whether the answer's field is what a mistake leads to. A clipped polygon may begin with any
// vertex.
bool is_slipped(const Expected& slipped, const Answer& answer) {
  if (!compare(slipped, answer).first) return true;
  const Values* actual = find_field(answer, slipped.field);
  if (slipped.shape != Shape::kPolygon || actual == nullptr ||
      actual->size() != slipped.values.size())
    return false;
  const auto columns = std::ptrdiff_t(columns_of(slipped));
  Values turned = *actual;
  for (std::size_t i = 0; i < turned.size(); i += std::size_t(columns)) {
    std::rotate(turned.begin(), turned.begin() + columns, turned.end());
    if (!compare(slipped, turned).first) return true;
  }
  return false;
}

bool explains(const Evidence& evidence, const ExpectedVariant& variant) {
  bool used = false;
  for (std::size_t i = 0; i < evidence.cases.size(); ++i) {
    const Case& input = evidence.cases[i];
    const Answer& answer = evidence.answers[i].answer;
    if (input.judge) {
      if (input.judge(answer)) return false;
      continue;
    }
    for (const Expected& expected : input.expected) {
      if (evidence.right_fields.count(expected.field) != 0) continue;
      const bool wrong = compare(expected, answer).first.has_value();
      const std::vector<Expected> slipped = variant.make(expected);
      bool matched = !wrong && slipped.empty();  // then the mistake changes nothing here
      for (const Expected& each : slipped) matched = matched || !compare(each, answer).first;
      if (!matched) return false;
      used = used || wrong;
    }
  }
  return used;
}

// Whether a mistake explains the answers, by the lab's own entries (Case::slipped). It does not if
// it would have made an answer wrong that is right.
bool explains(const Evidence& evidence, const std::string& slip) {
  bool used = false;
  for (std::size_t i = 0; i < evidence.cases.size(); ++i) {
    const Case& input = evidence.cases[i];
    const Answer& answer = evidence.answers[i].answer;
    const bool wrong = judge_case(input, answer).has_value();
    bool has_entry = false, matched = false;
    for (const ExpectedWithSlip& each : input.slipped) {
      if (each.slip != slip || each.expected.empty()) continue;
      has_entry = true;
      matched =
          matched || std::all_of(each.expected.begin(), each.expected.end(),
                                 [&](const Expected& field) { return is_slipped(field, answer); });
    }
    if (wrong ? !matched : has_entry && !matched) return false;
    used = used || wrong;
  }
  return used;
}

// The heights with which y = height - y' would explain the first wrong point.
std::vector<double> heights_of(const Evidence& evidence) {
  for (std::size_t i = 0; i < evidence.cases.size(); ++i) {
    for (const Expected& expected : evidence.cases[i].expected) {
      const bool has_y = expected.shape == Shape::kPoint || expected.shape == Shape::kPolygon ||
                         (expected.shape == Shape::kNumbers && expected.values.size() >= 2 &&
                          expected.values.size() <= 4);
      const Values* actual = find_field(evidence.answers[i].answer, expected.field);
      if (!has_y || actual == nullptr || actual->size() < 2 || expected.values.size() < 2) continue;
      if (!compare(expected, *actual).first) continue;
      return {expected.values[1] + (*actual)[1]};
    }
  }
  return {};
}

// Whether an expected matrix of the check is an affine map that moves the origin. When it is
// transposed, its translation is in the last row.
bool has_translation(const std::vector<Case>& cases) {
  for (const Case& input : cases) {
    for (const Expected& field : input.expected) {
      const auto side = std::size_t(std::max(0, columns_of(field)));
      if (field.shape != Shape::kMatrix || side < 3 || side * side != field.values.size()) continue;
      bool affine = true, moves = false;
      for (std::size_t i = 0; i < side; ++i) {
        affine = affine && field.values[(side - 1) * side + i] == (i + 1 == side ? 1 : 0);
        moves = moves || (i + 1 < side && field.values[i * side + side - 1] != 0);
      }
      if (affine && moves) return true;
    }
  }
  return false;
}

}  // namespace

const std::vector<Slip>& known_slips() {
  static const std::vector<Slip> all{
      {"z-sign", "your z has the opposite sign: the eye looks down -z"},
      {"y-direction",
       "your y axis has the opposite direction: y points up in world space, eye space and NDC, and "
       "down on the screen"},
      {"row-column-order",
       "your rows and columns are exchanged (the matrix is transposed): write at(row, column)"},
      {"row-vectors",
       "your matrix is made for row vectors: here vectors are columns, and a translation is in the "
       "last column"},
      {"handedness", "your axes are mirrored: the world is right-handed, x cross y is z"},
      {"winding",
       "your winding is reversed: seen from outside, a front face runs counter-clockwise"},
      {"half-angle",
       "one of your angles is half or twice what it should be: the tangent is that of half the "
       "field of view"},
      {"degrees-radians",
       "one of your angles is in degrees and should be in radians, or the reverse"},
      {"multiplication-order",
       "your matrices are multiplied in the other order: the matrix that acts first is the "
       "rightmost one"},
      {"cross-order",
       "the factors of a cross product are exchanged: a x b is -(b x a), and U is up x N, not N x "
       "up"},
      {"translation-sign",
       "a translation has the wrong sign: to move a point p to the origin, translate by -p"},
      {"not-normalised", "a vector that must have length 1 is not normalised"},
      {"normal-as-vector",
       "your normals are multiplied by the model matrix: multiply them by its inverse transpose"},
      {"tan-cot", "you use the tangent where its reciprocal, the cotangent, is needed"},
      {"inverted-aspect",
       "your aspect ratio is inverted: it is width / height, and x is divided by it"},
      {"opengl-depth",
       "your depth range is that of OpenGL, -w <= z <= w: here the near plane is z = 0"},
      {"affine",
       "you interpolate an attribute u linearly on the screen: in perspective only u/w and 1/w are "
       "linear there, and u is their quotient"},
      {"half-pixel", "you are half a pixel off: the centre of pixel (i, j) is (i + 1/2, j + 1/2)"},
      {"all-edges",
       "your triangles own all their edges (>=): a pixel centre on an edge belongs to the triangle "
       "whose top or left edge it is"},
      {"ownership",
       "your triangles own their bottom and right edges: a clockwise triangle owns a left edge, "
       "which goes up (by < ay), and a top edge, which goes right; look at owns_edge, and at the "
       "order of its two points where you call it",
       "edge-sign"},
      {"edge-sign",
       "your edge function has the opposite sign: with y down it is positive to the right of the "
       "direction from a to b, so a, b, p clockwise give a positive number"},
      {"edge-in-float",
       "your edge function computes in float, which keeps 24 bits: its products need 50, so "
       "compute "
       "it in std::int64_t"},
      {"edge-in-32-bits",
       "your edge function computes in integers of 32 bits or fewer: its products need 50, so make "
       "a factor "
       "of each product a std::int64_t"},
      {"no-near-plane",
       "you leave out the near plane, z >= 0: what is before it or behind the eye must be cut off, "
       "too, although the planes of the four sides cut off most of it"},
      {"depth-or-equal",
       "your depth test is <=: if fragments are equally near, the one drawn first stays"},
      {"shift-for-centre",
       "your T is the translation t of other textbooks, where P_r = R P_l + t; here T is the place "
       "of the right camera, -R^T t"},
      {"not-denormalised",
       "your matrix is that of the normalised points: transform it back to the original points"},
      {"rank-first",
       "you make the singular values equal before you transform the matrix back, which makes them "
       "unequal again"},
      {"left-right",
       "your pictures are exchanged: search in the right picture for each pixel of the left one"},
      {"disparity-sign",
       "your disparities have the opposite sign: pixel x of the left picture matches pixel x - d "
       "of the right one"},
  };
  return all;
}

std::string slip_text(const std::string& id) {
  for (const Slip& slip : known_slips()) {
    if (slip.id == id) return slip.text;
  }
  return {};
}

std::vector<std::string> find_slips(const std::vector<Case>& cases,
                                    const std::vector<CaseAnswer>& answers) {
  if (cases.empty() || cases.size() != answers.size()) return {};
  for (const CaseAnswer& each : answers) {
    if (each.state != CaseAnswer::State::kAnswered) return {};
  }
  const Evidence evidence = collect(cases, answers);
  std::vector<std::string> found;
  const auto note = [&](const std::string& slip) {
    if (std::find(found.begin(), found.end(), slip) == found.end()) found.push_back(slip);
  };
  std::set<std::string> candidates;
  for (const Case& input : cases) {
    for (const ExpectedWithSlip& each : input.slipped) candidates.insert(each.slip);
  }
  for (const std::string& slip : candidates) {
    if (explains(evidence, slip)) note(slip);
  }
  std::vector<AnswerVariant> variants = answer_variants();
  for (const double height : heights_of(evidence)) variants.push_back(flipped_y_variant(height));
  const bool translated = has_translation(cases);
  for (const AnswerVariant& variant : variants) {
    if (!explains(evidence, variant)) continue;
    note(translated && variant.slip == "row-column-order" ? "row-vectors" : variant.slip);
  }
  for (const ExpectedVariant& variant : expected_variants()) {
    if (explains(evidence, variant)) note(variant.slip);
  }
  if (found.size() != 1) found.clear();
  return found;
}

}  // namespace glassbox::labs
