// The plain size of the differences: the largest difference, and the root mean square.
#pragma once

#include <cstdint>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// Computed over all samples, alpha included, of the compared pixels. A step is 1/255 for bytes and
// 1/65535 for 16-bit samples, so that both errors are in [0, 1]; floats are not scaled. Both errors
// are infinite where exactly one of two samples is NaN or infinities differ, and also where both
// samples are NaN, unless the pair's nan_equals_nan is set.
struct SampleErrors {
  std::uint64_t samples = 0;
  double absmax = 0;
  double rmse = 0;
  double peak = 0;  // 1, or for floats the largest finite magnitude of the reference
};

// Sums are taken row by row in double and the rows are added in order: the result does not depend
// on threads. The relative error of the rmse is below (samples in a row + rows) 2^-53.
SampleErrors sample_errors(const PicturePair& pair);

// 20 log10(peak / rmse) in dB: infinite where nothing differs, minus infinite where the rmse is
// infinite.
double psnr(const SampleErrors& errors);

}  // namespace glassbox
