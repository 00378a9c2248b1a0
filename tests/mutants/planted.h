// The number of the fault of faults.cmake that is switched on.
#pragma once

namespace glassbox {

inline int planted_fault = 0;  // 0: none

inline bool planted(int number) {
  return planted_fault == number;
}

}  // namespace glassbox
