// glTF's numbers for filters and wrap modes, for reading and writing.
#pragma once

#include <glassbox/mesh/scene.h>

namespace glassbox::gltf {

inline constexpr int kNearestCode = 9728, kLinearCode = 9729;  // for magnification

struct WrapCode {
  int code;
  Wrap wrap;
};
inline constexpr WrapCode kWrapCodes[] = {
    {10497, Wrap::kRepeat}, {33071, Wrap::kClampToEdge}, {33648, Wrap::kMirroredRepeat}};

struct MinifyCode {
  int code;
  Filter filter;
  MipFilter mip;
};
inline constexpr MinifyCode kMinifyCodes[] = {{kNearestCode, Filter::kNearest, MipFilter::kNone},
                                              {kLinearCode, Filter::kLinear, MipFilter::kNone},
                                              {9984, Filter::kNearest, MipFilter::kNearest},
                                              {9985, Filter::kLinear, MipFilter::kNearest},
                                              {9986, Filter::kNearest, MipFilter::kLinear},
                                              {9987, Filter::kLinear, MipFilter::kLinear}};

}  // namespace glassbox::gltf
