// Watching a run, and taking part in it: one method for each stage, called with what went in and what came out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glassbox/mesh/triangulate.h>
#include <glassbox/pipeline/clip.h>
#include <glassbox/pipeline/stages.h>
#include <glassbox/raster/stages.h>
#include <glassbox/raster/texture.h>

namespace glassbox {

struct Draw;
struct PrimitiveStage;
struct FragmentStage;
struct ReadyTriangle;

// What became of a fragment.
enum class Fate : std::uint8_t {
  kHidden,     // something nearer was there already
  kDiscarded,  // its alpha lies below the material's cutoff
  kWritten,    // it is what the pixel shows, for the time being
  kBlended,    // it was laid over what was there
};

// What a fragment comes from that is no triangle's: an edge is that of a triangle, drawn as a line.
enum class LineKind : std::uint8_t { kEdge, kLine, kPoint };

// Where a fragment comes from.
struct FragmentSource {
  // Of the triangle, in the whole scene, and so of edges; of lines and points an index into those of their mesh.
  std::uint32_t number = 0;
  std::uint32_t piece = 0;  // of the fan that clipping left of the triangle; 0 of all else
  bool is_triangle = true;
  LineKind line = LineKind::kEdge;  // where it is no triangle
  std::uint8_t edge = 0;            // of edges: from this corner of the triangle to the next
};

// Derive from it and override the stages of interest. What a stage has made comes by reference: whoever changes it has
// replaced the stage, and the run goes on with what it finds. The defaults change nothing, so a run that is watched only
// gives the same bytes as one that is not; a run without an observer is compiled without it (staged/watch.h).
//
// Calls come draw by draw; within a draw all vertices first, then triangles in batches, each followed by the fragments of the
// batch. For one triangle they come in the order in which they stand here.
class Observer {
public:
  virtual ~Observer() = default;

  // ---- once for each draw ----

  virtual void draw(const Draw& /*draw*/) {}

  // ---- vertices ----

  // Object to clip space, for entry `index` of the mesh's positions.
  virtual void projected(const Draw& /*draw*/, std::uint32_t /*index*/, Point<Clip>& /*clip*/) {}

  // ---- triangles ----

  // The triangle as it comes to the clipper, and what the clipper left of it.
  virtual void clipped(const PrimitiveStage& /*stage*/, const Triangle& /*triangle*/,
                       const std::array<ClipVertex, 3>& /*corners*/, ClipPolygon& /*polygon*/) {}

  // A vertex of that polygon, divided by w.
  virtual void divided(const ClipVertex& /*clip*/, NdcVertex& /*ndc*/) {}

  // The same on the screen.
  virtual void placed(const NdcVertex& /*ndc*/, ScreenVertex& /*screen*/) {}

  // The polygon's vertices on the grid, and which of them its fan begins at.
  virtual void fanned(std::span<SnappedVertex> /*polygon*/, int& /*apex*/) {}

  // A piece of the polygon, set up; nothing where its area is zero.
  virtual void set_up(std::uint32_t /*piece*/, const std::array<ScreenVertex, 3>& /*vertices*/,
                      std::optional<TriangleSetup>& /*setup*/) {}

  // Whether the piece shows its front, and is thrown away.
  virtual void faced(const TriangleSetup& /*setup*/, bool /*front*/, bool& /*culled*/) {}

  // The end of every triangle for which clipped() was called.
  virtual void prepared(const Triangle& /*triangle*/) {}

  // ---- fragments ----

  // A piece before its fragments, with what its vertices carry.
  virtual void ready(const ReadyTriangle& /*triangle*/) {}

  // The pixel centres that it covers, in the order in which they are drawn, and its edge functions there; null: as the stage finds
  // them. Pixels lie in the picture. Not asked where several samples are drawn.
  virtual const std::vector<Coverage>* covered(const FragmentSource& /*source*/) { return nullptr; }

  // A covered pixel centre: depth and weights there.
  virtual void interpolated(const FragmentSource& /*source*/, const Coverage& /*coverage*/,
                            Fragment& /*fragment*/) {}

  // The depth test: the incoming code against the stored one.
  virtual void compared(const FragmentSource& /*source*/, const Fragment& /*fragment*/,
                        std::uint32_t /*code*/, std::uint32_t /*stored*/, bool& /*in_front*/) {}

  // The attributes there, of a fragment that passed.
  virtual void varied(const Fragment& /*fragment*/, Varyings& /*at*/) {}

  // The surface's own colour: material times vertex colour times texture.
  virtual void textured(const Varyings& /*at*/, Rgba& /*surface*/) {}

  // The light that the surface shines with by itself; not called where the material has none.
  virtual void emitted(const Varyings& /*at*/, std::array<float, 3>& /*emission*/) {}

  // The colour in the light, and with what was emitted, still linear.
  virtual void lit(const Varyings& /*at*/, const Rgba& /*surface*/, Rgba& /*color*/) {}

  // What is stored, before the colour mask; `before` is what the pixel held.
  virtual void encoded(const Fragment& /*fragment*/, const Rgba8& /*before*/, Rgba8& /*after*/) {}

  // The end of every fragment for which compared() was called.
  virtual void ended(const FragmentSource& /*source*/, const Fragment& /*fragment*/,
                     Fate /*fate*/) {}
};

// Those who watch a run, in the order in which they are told: the first may take part in it, the
// next ones see what it has made of it. Pixels are asked of the first alone.
class Observers {
public:
  Observers() = default;
  Observers(Observer* one) { add(one); }  // null: nobody
  Observers(Observer* first, Observer* second) : Observers(first) { add(second); }

  bool empty() const { return told_.empty(); }
  Observer& first() const { return *told_.front(); }
  auto begin() const { return told_.begin(); }
  auto end() const { return told_.end(); }

private:
  void add(Observer* observer) {
    if (observer != nullptr) told_.push_back(observer);
  }
  std::vector<Observer*> told_;
};

}  // namespace glassbox
