// Two observers of one run: the first may take part in it, the second sees the results after the
// first has changed them.
#pragma once

#include <glassbox/render/engine/observer.h>

namespace glassbox {

class ObserverPair : public Observer {
public:
  ObserverPair(Observer& first, Observer& second) : first_(first), second_(second) {}

  void draw(const Draw& draw) override { tell(&Observer::draw, draw); }
  void projected(const Draw& draw, std::uint32_t index, Point<Clip>& clip) override {
    tell(&Observer::projected, draw, index, clip);
  }
  void clipped(const PrimitiveStage& stage, const Triangle& triangle,
               const std::array<ClipVertex, 3>& corners, ClipPolygon& polygon) override {
    tell(&Observer::clipped, stage, triangle, corners, polygon);
  }
  void divided(const ClipVertex& clip, NdcVertex& ndc) override {
    tell(&Observer::divided, clip, ndc);
  }
  void placed(const NdcVertex& ndc, ScreenVertex& screen) override {
    tell(&Observer::placed, ndc, screen);
  }
  void fanned(std::span<SnappedVertex> polygon, int& apex) override {
    tell(&Observer::fanned, polygon, apex);
  }
  void set_up(std::uint32_t piece, const std::array<ScreenVertex, 3>& vertices,
              std::optional<TriangleSetup>& setup) override {
    tell(&Observer::set_up, piece, vertices, setup);
  }
  void faced(const TriangleSetup& setup, bool front, bool& culled) override {
    tell(&Observer::faced, setup, front, culled);
  }
  void prepared(const Triangle& triangle) override { tell(&Observer::prepared, triangle); }
  void ready(const ReadyTriangle& triangle) override { tell(&Observer::ready, triangle); }
  const std::vector<Coverage>* covered(const FragmentSource& source) override {
    return first_.covered(source);
  }
  void interpolated(const FragmentSource& source, const Coverage& coverage,
                    Fragment& fragment) override {
    tell(&Observer::interpolated, source, coverage, fragment);
  }
  void compared(const FragmentSource& source, const Fragment& fragment, std::uint32_t code,
                std::uint32_t stored, bool& in_front) override {
    tell(&Observer::compared, source, fragment, code, stored, in_front);
  }
  void varied(const Fragment& fragment, Varyings& at) override {
    tell(&Observer::varied, fragment, at);
  }
  void textured(const Varyings& at, Rgba& surface) override {
    tell(&Observer::textured, at, surface);
  }
  void emitted(const Varyings& at, std::array<float, 3>& emission) override {
    tell(&Observer::emitted, at, emission);
  }
  void lit(const Varyings& at, const Rgba& surface, Rgba& color) override {
    tell(&Observer::lit, at, surface, color);
  }
  void encoded(const Fragment& fragment, const Rgba8& before, Rgba8& after) override {
    tell(&Observer::encoded, fragment, before, after);
  }
  void ended(const FragmentSource& source, const Fragment& fragment, Fate fate) override {
    tell(&Observer::ended, source, fragment, fate);
  }

private:
  template <class... Parameters, class... Arguments>
  void tell(void (Observer::*what)(Parameters...), Arguments&&... arguments) {
    (first_.*what)(arguments...);
    (second_.*what)(arguments...);
  }

  Observer &first_, &second_;
};

}  // namespace glassbox
