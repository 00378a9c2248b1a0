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
  kBlended,    // it was blended over what was there
};

// The kind of a fragment that does not come from the inside of a triangle. An edge is that of a
// triangle, drawn as a line.
enum class LineKind : std::uint8_t { kEdge, kLine, kPoint };

// The primitive that a fragment comes from.
struct FragmentSource {
  // For a triangle or its edge, the triangle's number in the whole scene; for a line or a point, an
  // index into its mesh's lines or points.
  std::uint32_t number = 0;
  std::uint32_t piece = 0;  // index in the fan that clipping left of the triangle; otherwise 0
  bool is_triangle = true;
  LineKind line = LineKind::kEdge;  // used only if it is not a triangle
  std::uint8_t edge = 0;            // for edges: from this corner of the triangle to the next
};

// To watch a run, derive from this class and override the stages of interest. A stage's output is
// passed by reference: a method that changes it replaces the stage, and the run continues with the
// changed value. The defaults change nothing, so a run that is only watched gives the same bytes as
// one that is not; a run without an observer is compiled without it (staged/watch.h).
//
// Calls come draw by draw. Within a draw all vertices come first, then triangles in batches, each
// followed by the fragments of the batch. For one triangle the calls come in the order of the
// methods below.
class Observer {
public:
  virtual ~Observer() = default;

  // ---- once for each draw ----

  virtual void draw(const Draw& /*draw*/) {}

  // ---- vertices ----

  // The transform from object to clip space, for entry `index` of the mesh's positions.
  virtual void projected(const Draw& /*draw*/, std::uint32_t /*index*/, Point<Clip>& /*clip*/) {}

  // ---- triangles ----

  // The triangle before clipping, and the polygon that the clipper left of it.
  virtual void clipped(const PrimitiveStage& /*stage*/, const Triangle& /*triangle*/,
                       const std::array<ClipVertex, 3>& /*corners*/, ClipPolygon& /*polygon*/) {}

  // A vertex of that polygon, divided by w.
  virtual void divided(const ClipVertex& /*clip*/, NdcVertex& /*ndc*/) {}

  // The same vertex on the screen.
  virtual void mapped_to_screen(const NdcVertex& /*ndc*/, ScreenVertex& /*screen*/) {}

  // The polygon's vertices after snapping, and the vertex at which its fan begins.
  virtual void fanned(std::span<SnappedVertex> /*polygon*/, int& /*apex*/) {}

  // The setup of one piece of the polygon; nothing where its area is zero.
  virtual void set_up(std::uint32_t /*piece*/, const std::array<ScreenVertex, 3>& /*vertices*/,
                      std::optional<TriangleSetup>& /*setup*/) {}

  // Whether the viewer sees the piece's front, and whether it is culled.
  virtual void facing_tested(const TriangleSetup& /*setup*/, bool /*front*/, bool& /*culled*/) {}

  // Called at the end of every triangle for which clipped() was called.
  virtual void triangle_finished(const Triangle& /*triangle*/) {}

  // ---- fragments ----

  // A piece before its fragments are drawn, with the attributes of its vertices.
  virtual void piece_ready(const ReadyTriangle& /*triangle*/) {}

  // Returns the pixel centres that the piece covers, in the order in which they are drawn, with its
  // edge functions there. Null: the stage finds them itself. The pixels must be in the picture. Not
  // called where several samples are drawn.
  virtual const std::vector<Coverage>* covered(const FragmentSource& /*source*/) { return nullptr; }

  // A covered pixel centre, with the depth and weights there.
  virtual void interpolated(const FragmentSource& /*source*/, const Coverage& /*coverage*/,
                            Fragment& /*fragment*/) {}

  // The depth test: compares the incoming code with the stored one.
  virtual void compared(const FragmentSource& /*source*/, const Fragment& /*fragment*/,
                        std::uint32_t /*code*/, std::uint32_t /*stored*/, bool& /*in_front*/) {}

  // The attributes at the pixel, for a fragment that passed the depth test.
  virtual void attributes_interpolated(const Fragment& /*fragment*/, Varyings& /*at*/) {}

  // The surface's own colour: material times vertex colour times texture.
  virtual void textured(const Varyings& /*at*/, Rgba& /*surface*/) {}

  // The light that the surface emits; not called where the material emits none.
  virtual void emitted(const Varyings& /*at*/, std::array<float, 3>& /*emission*/) {}

  // The colour after lighting and with the emission added, still linear.
  virtual void lit(const Varyings& /*at*/, const Rgba& /*surface*/, Rgba& /*color*/) {}

  // The bytes to be stored, before the colour mask; `before` is what the pixel held.
  virtual void encoded(const Fragment& /*fragment*/, const Rgba8& /*before*/, Rgba8& /*after*/) {}

  // Called at the end of every fragment for which compared() was called.
  virtual void fragment_finished(const FragmentSource& /*source*/, const Fragment& /*fragment*/,
                                 FragmentResult /*result*/) {}
};

// The observers of a run, in the order in which they are called. The first one may change the
// results; those after it see the changed results. Observer::covered is called for the first one
// only.
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
