// The inputs of both sides.
#pragma once

inline constexpr double kInputs[] = {1, -3, 0.5, 8};
