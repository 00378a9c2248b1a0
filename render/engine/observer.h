// The interface for watching a run and changing what it computes. It has one method for each stage,
// called with the stage's input and output.
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

// The result of a fragment.
enum class FragmentResult : std::uint8_t {
  kHidden,     // something nearer was there already
  kDiscarded,  // its alpha is below the material's cutoff
  kWritten,    // it is what the pixel shows, until something is drawn over it
  kBlended,    // it was blended over the colour that was there
};

// What a fragment comes from if not from the inside of a triangle: an edge of a triangle that is
// drawn as a line, a line of the mesh, or a point.
enum class LineKind : std::uint8_t { kEdge, kLine, kPoint };

// The primitive that a fragment comes from.
struct FragmentSource {
  // For a triangle or its edge, the triangle's number in the whole scene; for a line or a point, an
  // index into its mesh's lines or points.
  std::uint32_t number = 0;
  // Index in the fan of triangles that clipping left; 0 for edges, lines and points.
  std::uint32_t piece = 0;
  bool is_triangle = true;
  LineKind line = LineKind::kEdge;  // used only if it is not a triangle
  std::uint8_t edge = 0;            // for edges: from this corner of the triangle to the next
};

// To watch a run, derive from this class and override the stages of interest. A stage's output is
// passed by reference: a method that changes it replaces the stage, and the run continues with the
// changed value. The defaults change nothing, so a run that is only watched draws the same bytes as
// a run without observers, which is compiled without these calls (staged/watch.h).
//
// The methods are called draw by draw: first for all vertices of the draw, then for its triangles
// in batches, each followed by the fragments of the batch. For one triangle the calls come in the
// order of the methods below.
class Observer {
public:
  virtual ~Observer() = default;

  // ---- once for each draw ----

  virtual void draw(const Draw& /*draw*/) {}

  // ---- vertices ----

  // Called after entry `index` of the mesh's positions has been transformed to clip space.
  virtual void projected(const Draw& /*draw*/, std::uint32_t /*index*/, Point<Clip>& /*clip*/) {}

  // ---- triangles ----

  // Called after a triangle has been clipped, with its corners before and the polygon that is left.
  virtual void clipped(const PrimitiveStage& /*stage*/, const Triangle& /*triangle*/,
                       const std::array<ClipVertex, 3>& /*corners*/, ClipPolygon& /*polygon*/) {}

  // Called after a vertex of the clipped polygon has been divided by w.
  virtual void divided(const ClipVertex& /*clip*/, NdcVertex& /*ndc*/) {}

  // Called after a vertex of the clipped polygon has been mapped to the screen.
  virtual void mapped_to_screen(const NdcVertex& /*ndc*/, ScreenVertex& /*screen*/) {}

  // Called after the polygon's vertices have been snapped. `apex` is the vertex at which the fan of
  // triangles begins.
  virtual void fanned(std::span<SnappedVertex> /*polygon*/, int& /*apex*/) {}

  // Called after the setup of one triangle of the fan (`piece` is its index). `setup` is empty if
  // the triangle has no area.
  virtual void set_up(std::uint32_t /*piece*/, const std::array<ScreenVertex, 3>& /*vertices*/,
                      std::optional<TriangleSetup>& /*setup*/) {}

  // Called when it is known whether the viewer sees the front of a triangle of the fan. `culled`
  // says whether the triangle will be culled; the observer may change it.
  virtual void facing_tested(const TriangleSetup& /*setup*/, bool /*front*/, bool& /*culled*/) {}

  // Called at the end of every triangle for which clipped() was called.
  virtual void triangle_finished(const Triangle& /*triangle*/) {}

  // ---- fragments ----

  // Called before the fragments of a triangle of the fan are drawn, with the attributes of its
  // vertices.
  virtual void piece_ready(const ReadyTriangle& /*triangle*/) {}

  // Returns the pixels whose centres the triangle covers, in the order in which they are drawn,
  // with the values of its edge functions there. Null: the stage finds the pixels itself. They must
  // be in the picture. Not called if a pixel has several samples.
  virtual const std::vector<Coverage>* covered(const FragmentSource& /*source*/) { return nullptr; }

  // Called after depth and weights have been interpolated at a covered pixel centre (with several
  // samples per pixel, at the point where the fragment is shaded).
  virtual void interpolated(const FragmentSource& /*source*/, const Coverage& /*coverage*/,
                            Fragment& /*fragment*/) {}

  // Called after the depth test, which compares the incoming code with the stored one.
  virtual void compared(const FragmentSource& /*source*/, const Fragment& /*fragment*/,
                        std::uint32_t /*code*/, std::uint32_t /*stored*/, bool& /*in_front*/) {}

  // Called after the attributes have been interpolated, for a fragment that passed the depth test.
  virtual void attributes_interpolated(const Fragment& /*fragment*/, Varyings& /*at*/) {}

  // Called with the surface's own colour: material times vertex colour times texture.
  virtual void textured(const Varyings& /*at*/, Rgba& /*surface*/) {}

  // Called with the light that the surface emits; not called if the material emits none.
  virtual void emitted(const Varyings& /*at*/, std::array<float, 3>& /*emission*/) {}

  // Called with the colour after lighting and with the emission added, still linear.
  virtual void lit(const Varyings& /*at*/, const Rgba& /*surface*/, Rgba& /*color*/) {}

  // Called with the bytes to be stored, before the colour mask; `before` is what the pixel held.
  virtual void encoded(const Fragment& /*fragment*/, const Rgba8& /*before*/, Rgba8& /*after*/) {}

  // Called at the end of every fragment for which compared() was called.
  virtual void fragment_finished(const FragmentSource& /*source*/, const Fragment& /*fragment*/,
                                 FragmentResult /*result*/) {}
};

// The observers of a run, in the order in which they are called. The first observer may change the
// results; the later observers see the changed results. Observer::covered is called for the first
// observer only.
class Observers {
public:
  Observers() = default;
  Observers(Observer* one) { add(one); }  // null: no observer
  Observers(Observer* first, Observer* second) : Observers(first) { add(second); }

  bool empty() const { return observers_.empty(); }
  Observer& first() const { return *observers_.front(); }
  auto begin() const { return observers_.begin(); }
  auto end() const { return observers_.end(); }

private:
  void add(Observer* observer) {
    if (observer != nullptr) observers_.push_back(observer);
  }
  std::vector<Observer*> observers_;
};

}  // namespace glassbox
