// The answers to the inputs of a generated class, which a runner writes in one line.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "labs/framework/lab.h"

namespace glassbox::labs {

// The sizes of a batch's field are in another field, whose name is this one behind its own.
inline constexpr const char* kSizes = "/sizes";

// How many fields all split answers may have together. Each takes some 100 bytes, and a student's
// process says how many there are. The labs' largest class is of 50,000 inputs, with fewer than 10
// fields each.
inline constexpr std::size_t kMaxSplitFields = 1'000'000;

// Splits the answers to `inputs` inputs. Nothing if a field has too few or too many numbers, or if
// there are too many fields.
std::optional<std::vector<Answer>> split_batch(const Answer& batch, std::size_t inputs);

// The choices that make input number `index` of the class with the seed of inputs_seed().
std::vector<std::uint64_t> choices_of(const GeneratedInputs& inputs, std::size_t index);

// The numbers of those inputs whose answers are wrong.
std::vector<std::size_t> wrong_inputs(const GeneratedInputs& inputs,
                                      const std::vector<Answer>& answers);

}  // namespace glassbox::labs
