// The types that watch a run of the staged stages: one does nothing, one counts, and one counts and
// calls an observer. Methods that do nothing cost nothing. They are Observer's methods, in the
// order of the stages.
#pragma once

#include <span>
#include <vector>

#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/statistics.h>

namespace glassbox {

struct Nobody {
  void draw(const Draw&) const {}
  void projected(const Draw&, std::uint32_t, Point<Clip>&) const {}
  void culled_early() const {}
  void clipped(const PrimitiveStage&, const Triangle&, const std::array<ClipVertex, 3>&,
               ClipVerdict, ClipPolygon&) const {}
  void divided(const ClipVertex&, NdcVertex&) const {}
  void placed(const NdcVertex&, ScreenVertex&) const {}
  void fanned(std::span<SnappedVertex>, int&) const {}
  void set_up(std::uint32_t, const std::array<ScreenVertex, 3>&,
              std::optional<TriangleSetup>&) const {}
  void faced(const TriangleSetup&, bool, bool&) const {}
  void prepared(const Triangle&) const {}
  void ready(const ReadyTriangle&) const {}
  static constexpr const std::vector<Coverage>* covered(const FragmentSource&) { return nullptr; }
  void interpolated(const FragmentSource&, const Coverage&, Fragment&) const {}
  void compared(const FragmentSource&, const Fragment&, std::uint32_t, std::uint32_t, bool&) const {
  }
  void varied(const Fragment&, Varyings&) const {}
  void textured(const Varyings&, Rgba&) const {}
  void emitted(const Varyings&, std::array<float, 3>&) const {}
  void lit(const Varyings&, const Rgba&, Rgba&) const {}
  void encoded(const Fragment&, const Rgba8&, Rgba8&) const {}
  void ended(const FragmentSource&, const Fragment&, Fate) const {}
};

// Counts the results of the stages.
struct Counting : Nobody {
  Statistics& statistics;

  explicit Counting(Statistics& counts) : statistics(counts) {}

  void culled_early() const { ++statistics.culled_early; }
  void clipped(const PrimitiveStage&, const Triangle&, const std::array<ClipVertex, 3>&,
               ClipVerdict verdict, ClipPolygon& polygon) const {
    switch (verdict) {
      case ClipVerdict::kAccept:
        break;
      case ClipVerdict::kReject:
        ++statistics.rejected;
        break;
      case ClipVerdict::kClip:
        ++(polygon.count == 0 ? statistics.clipped_away : statistics.clipped);
        break;
    }
  }
  void set_up(std::uint32_t, const std::array<ScreenVertex, 3>&,
              std::optional<TriangleSetup>& setup) const {
    ++statistics.after_clipping;
    if (!setup) ++statistics.zero_area;
  }
  void faced(const TriangleSetup&, bool, bool& culled) const {
    ++(culled ? statistics.culled : statistics.set_up);
  }
  void ended(const FragmentSource&, const Fragment&, Fate fate) const {
    ++statistics.covered;
    switch (fate) {
      case Fate::kHidden:
        ++statistics.depth_failed;
        break;
      case Fate::kDiscarded:
        ++statistics.discarded;
        break;
      case Fate::kBlended:
        ++statistics.blended;
        [[fallthrough]];
      case Fate::kWritten:
        ++statistics.written;
        break;
    }
  }
};

// Counts, and calls an observer, which may change what a stage has made; the changed value is
// counted.
struct Observed : Counting {
  Observer& observer;

  Observed(Statistics& counts, Observer& told) : Counting(counts), observer(told) {}

  void draw(const Draw& drawn) const { observer.draw(drawn); }
  void projected(const Draw& draw, std::uint32_t index, Point<Clip>& clip) const {
    observer.projected(draw, index, clip);
  }
  void clipped(const PrimitiveStage& stage, const Triangle& triangle,
               const std::array<ClipVertex, 3>& corners, ClipVerdict verdict,
               ClipPolygon& polygon) const {
    Counting::clipped(stage, triangle, corners, verdict, polygon);
    observer.clipped(stage, triangle, corners, polygon);
  }
  void divided(const ClipVertex& clip, NdcVertex& ndc) const { observer.divided(clip, ndc); }
  void placed(const NdcVertex& ndc, ScreenVertex& screen) const { observer.placed(ndc, screen); }
  void fanned(std::span<SnappedVertex> polygon, int& apex) const { observer.fanned(polygon, apex); }
  void set_up(std::uint32_t piece, const std::array<ScreenVertex, 3>& vertices,
              std::optional<TriangleSetup>& setup) const {
    observer.set_up(piece, vertices, setup);
    Counting::set_up(piece, vertices, setup);
  }
  void faced(const TriangleSetup& setup, bool front, bool& culled) const {
    observer.faced(setup, front, culled);
    Counting::faced(setup, front, culled);
  }
  void prepared(const Triangle& triangle) const { observer.prepared(triangle); }
  void ready(const ReadyTriangle& triangle) const { observer.ready(triangle); }
  const std::vector<Coverage>* covered(const FragmentSource& source) const {
    return observer.covered(source);
  }
  void interpolated(const FragmentSource& source, const Coverage& coverage,
                    Fragment& fragment) const {
    observer.interpolated(source, coverage, fragment);
  }
  void compared(const FragmentSource& source, const Fragment& fragment, std::uint32_t code,
                std::uint32_t stored, bool& in_front) const {
    observer.compared(source, fragment, code, stored, in_front);
  }
  void varied(const Fragment& fragment, Varyings& at) const { observer.varied(fragment, at); }
  void textured(const Varyings& at, Rgba& surface) const { observer.textured(at, surface); }
  void emitted(const Varyings& at, std::array<float, 3>& emission) const {
    observer.emitted(at, emission);
  }
  void lit(const Varyings& at, const Rgba& surface, Rgba& color) const {
    observer.lit(at, surface, color);
  }
  void encoded(const Fragment& fragment, const Rgba8& before, Rgba8& after) const {
    observer.encoded(fragment, before, after);
  }
  void ended(const FragmentSource& source, const Fragment& fragment, Fate fate) const {
    Counting::ended(source, fragment, fate);
    observer.ended(source, fragment, fate);
  }
};

}  // namespace glassbox
