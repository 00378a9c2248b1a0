// The channels in which light is computed: all three, or the two that an eye of an anaglyph keeps.

#if defined(GLASSBOX_CHANNELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_CHANNELS_INL_H_
#undef GLASSBOX_CHANNELS_INL_H_
#else
#define GLASSBOX_CHANNELS_INL_H_
#endif

#include <array>

#include <glassbox/raster/lanes/formulas-inl.h>
#include <glassbox/raster/lanes/tables.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

// Each channel is computed independently, so leaving one out does not change the others. Texels are
// four integers of 16 bits: two neighbouring channels fit in one vector, all four in two.
struct AllChannels {
  static constexpr std::size_t kCount = 3;
  static constexpr bool kHasAlpha = true;
  using Texels = Int16x4;

  AllChannels() = default;
  HWY_INLINE explicit AllChannels(const ResolveJob&) {}
  static constexpr std::size_t first() { return 0; }
  template <class T>
  HWY_INLINE const std::array<T, 3>& pick(const std::array<T, 3>& three) const {
    return three;
  }
  HWY_INLINE Texels texels(const std::int64_t* table, Ints at) const {
    return gather_int16x4(table, at);
  }
};

// Red and green, or green and blue.
class TwoChannels {
public:
  static constexpr std::size_t kCount = 2;
  static constexpr bool kHasAlpha = false;
  using Texels = Int16x2;

  static bool are_enough_for(const ResolveJob& job) { return !(job.channels.r && job.channels.b); }
  HWY_INLINE explicit TwoChannels(const ResolveJob& job) : first_(job.channels.r ? 0 : 1) {}
  std::size_t first() const { return first_; }
  template <class T>
  HWY_INLINE std::array<T, 2> pick(const std::array<T, 3>& three) const {
    return {three[first_], three[first_ + 1]};
  }
  HWY_INLINE Texels texels(const std::int64_t* table, Ints at) const {
    return gather_int16x2(table, at, first_);
  }

private:
  std::size_t first_;
};

template <class Channels>
using ColorOf = std::array<Floats, Channels::kCount>;
template <class Channels>
using LightOf = ReflectionOf<Floats, Channels::kCount>;
template <class Channels>
using SurfaceOf = SurfaceColorOf<Floats, Channels::kCount>;

template <class Channels>
HWY_INLINE LightOf<Channels> light_of(const Channels& channels,
                                      const ReflectionOf<Floats>& reflection) {
  return {channels.pick(reflection.diffuse), channels.pick(reflection.specular)};
}

HWY_INLINE std::array<Floats, 2> sum(const std::array<Floats, 2>& a,
                                     const std::array<Floats, 2>& b) {
  return {a[0] + b[0], a[1] + b[1]};
}
HWY_INLINE std::array<Floats, 2> product(const std::array<Floats, 2>& a,
                                         const std::array<Floats, 2>& b) {
  return {a[0] * b[0], a[1] * b[1]};
}

// The light and alpha of texels.
HWY_INLINE std::array<Floats, 3> color_of(const Int16x4& texels) {
  return {light_of_texel(int16_at<0>(texels)), light_of_texel(int16_at<1>(texels)),
          light_of_texel(int16_at<2>(texels))};
}
HWY_INLINE Floats alpha_of(const Int16x4& texels) {
  return alpha_of_texel(int16_at<3>(texels));
}
HWY_INLINE std::array<Floats, 2> color_of(const Int16x2& texels) {
  return {light_of_texel(first_of(texels)), light_of_texel(second_of(texels))};
}
HWY_INLINE Floats alpha_of(const Int16x2&) {
  return 1.0f;  // two channels have no alpha; the value is not used
}

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
