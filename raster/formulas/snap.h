// Rounds positions to integers in units of 1/256 pixel, halves rounded up.
//
// `pixels` times 256 is exact (a power of two), and so is the comparison of the remainder with one
// half. floor(pixels * 256 + 0.5f) would round wrongly just below a half, and beyond 2^15 pixels.
template <Number F>
inline auto snap(F pixels) {
  const F subpixels = pixels * float(kSubpixels);
  const F below = floor(subpixels);
  return to_integer(below) + one_where(subpixels - below >= 0.5f);
}
