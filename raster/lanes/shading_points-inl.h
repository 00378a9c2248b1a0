// Classes that say where in its pixel a fragment is shaded: at the centre with one sample per
// pixel; with several samples, at a point that the triangle covers.

#if defined(GLASSBOX_SHADING_POINTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLASSBOX_SHADING_POINTS_INL_H_
#undef GLASSBOX_SHADING_POINTS_INL_H_
#else
#define GLASSBOX_SHADING_POINTS_INL_H_
#endif

#include <array>
#include <span>

#include <glassbox/raster/lanes/blocks-inl.h>
#include <glassbox/raster/lanes/setup-inl.h>

HWY_BEFORE_NAMESPACE();
namespace glassbox {
namespace HWY_NAMESPACE {

struct AtCentre {
  HWY_INLINE void move_edges(const std::array<EdgeSlopes<Ints>, 3>&, Ints, Ints&, Ints&) const {}
  HWY_INLINE void move_edges(const TriangleSetup&, std::array<Doubles, 3>&) const {}
};

// With several samples, a fragment is shaded at the centre if the triangle covers it, otherwise at
// the first sample that the triangle covers (shading_point() of samples.h).
struct AtSamples {
  std::span<const SampleOffset> points;
  IntMask lanes;  // the lanes that show the triangle; other lanes need not be moved

  // For small triangles: moves the edge functions from the centre to the shading point. (Edge
  // function 0 is the area minus edge functions 1 and 2.)
  HWY_INLINE void move_edges(const std::array<EdgeSlopes<Ints>, 3>& edges, Ints area, Ints& e1,
                             Ints& e2) const {
    const Ints above0 = outside_up_to(edges[0]), above1 = outside_up_to(edges[1]),
               above2 = outside_up_to(edges[2]);
    const auto covered = [&](Ints at1, Ints at2) HWY_ATTR {
      return at1 > above1 && at2 > above2 && area - at1 - at2 > above0;
    };
    const Ints centre1 = e1, centre2 = e2;
    IntMask searching = lanes && !covered(e1, e2);
    for (const SampleOffset& point : points) {
      if (none(searching)) return;
      const Ints at1 = centre1 + edges[1].a * point.x + edges[1].b * point.y;
      const Ints at2 = centre2 + edges[2].a * point.x + edges[2].b * point.y;
      const IntMask here = searching && covered(at1, at2);
      e1 = select(here, at1, e1);
      e2 = select(here, at2, e2);
      searching = searching && !here;
    }
  }

  // For a large triangle: moves the edge functions from the centre to the shading point.
  HWY_INLINE void move_edges(const TriangleSetup& setup, std::array<Doubles, 3>& e) const {
    const auto covered = [&](const SampleOffset& point) HWY_ATTR {
      IntMask all = first_lanes(kLanes);
      for (std::size_t k = 0; k < 3; ++k) {
        const EdgeFunction& edge = setup.edges[k];
        const Doubles at_point = e[k] + double(edge.a * point.x + edge.b * point.y);
        all = all && covers(at_point, least_inside(edge));
      }
      return all;
    };
    IntMask searching = lanes && !covered({});
    if (none(searching)) return;
    Floats x = 0.0f, y = 0.0f;
    for (const SampleOffset& point : points) {
      const IntMask here = searching && covered(point);
      x = select(float_mask(here), float(point.x), x);
      y = select(float_mask(here), float(point.y), y);
      searching = searching && !here;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const EdgeFunction& edge = setup.edges[k];
      e[k] = e[k] + widened(x) * double(edge.a) + widened(y) * double(edge.b);
    }
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace glassbox
HWY_AFTER_NAMESPACE();

#endif
