#include "study/extremes/cases/cases.h"

namespace glassbox::study {

const std::vector<ExtremeCase>& extreme_cases() {
  static const std::vector<ExtremeCase> all{};
  return all;
}

const std::vector<LeftOut>& left_out_cases() {
  static const std::vector<LeftOut> all{};
  return all;
}

}  // namespace glassbox::study
