// The plain sizes of the differences: the largest, and the root of the mean square.
#pragma once

#include <cstdint>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// Over all samples, alpha too, of the pixels that are compared. Bytes count 1/255, 16-bit samples 1/65535, so that both
// lie in [0, 1]; floats are as they are. Where exactly one sample is NaN, or infinities differ, both numbers are
// infinite; so they are for NaN in both, unless the pair's nan_equals_nan.
struct SampleErrors {
  std::uint64_t samples = 0;
  double absmax = 0;
  double rmse = 0;
  double peak = 0;  // 1, or for floats the largest finite magnitude of the reference
};

// Sums are taken row by row in double and the rows added in order: the result does not depend on threads. The relative
// error of the rmse is below (samples in a row + rows) 2^-53.
SampleErrors sample_errors(const PicturePair& pair);

// 20 log10(peak / rmse) in dB: infinite where nothing differs, minus infinite where the rmse is infinite.
double psnr(const SampleErrors& errors);

}  // namespace glassbox
