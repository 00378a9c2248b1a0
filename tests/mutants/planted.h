// Which of the faults of faults.cmake is switched on.
#pragma once

namespace glassbox {

inline int planted_fault = 0;  // its number; 0: none

inline bool planted(int number) {
  return planted_fault == number;
}

}  // namespace glassbox
