// A run as arrays: every number of its records, record beside record, for programs that think in arrays (docs/trace.md lists
// them). What belongs to a triangle but comes in varying numbers (the vertices that clipping left, the pieces) has a table of
// its own, and the triangle the first of its rows there and their count.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/table.h>
#include <glassbox/render/trace/tracer.h>

namespace glassbox {

// How many records of each kind a run has.
struct TraceCounts {
  std::uint64_t draws = 0, triangles = 0, cuts = 0, cut_vertices = 0, vertices = 0, pieces = 0,
                fragments = 0;
};

// Counts, and keeps the draws only.
class TraceCounter : public TraceSink {
public:
  const TraceCounts& counts() const { return counts_; }
  const std::vector<TracedDraw>& draws() const { return draws_; }
  void draw(const TracedDraw& draw) override;
  void triangle(const TracedTriangle& triangle) override;
  void fragment(const TracedFragment& fragment) override;

private:
  TraceCounts counts_;
  std::vector<TracedDraw> draws_;
};

class TraceArrays : public TraceSink {
public:
  // `wanted`: names of arrays ("fragment.depth") or of tables ("fragment"); empty for all.
  TraceArrays(const View& view, const std::vector<std::string>& wanted);

  void draw(const TracedDraw& draw) override;
  void triangle(const TracedTriangle& triangle) override;
  void fragment(const TracedFragment& fragment) override;
  // After the last record.
  void finish();

  // The names in `wanted` that name nothing.
  std::vector<std::string> unknown() const { return unknown_; }
  // The bytes of all wanted arrays of a run with these counts.
  std::uint64_t bytes_for(const TraceCounts& counts) const;
  // Takes that much memory at once, and no more later.
  void reserve(const TraceCounts& counts);
  const RoundTrips& round_trips() const { return round_trips_; }

  // In the order of the stages.
  std::span<const Table> tables() const { return tables_; }
  std::span<Table> tables() { return tables_; }

private:
  enum Kind : std::size_t {
    kRun,
    kPlane,
    kDraw,
    kTriangle,
    kCorner,
    kCut,
    kCutVertex,
    kVertex,
    kPiece,
    kFragment,
    kRoundTrip,
    kKinds
  };
  std::array<std::uint64_t, kKinds> rows_for(const TraceCounts& counts) const;

  BoundsOfRun bounds_;
  RoundTrips round_trips_;
  std::array<Table, kKinds> tables_{Table("run", 0),     Table("plane"),        Table("draw"),
                                    Table("triangle"),   Table("corner", 3),    Table("cut"),
                                    Table("cut_vertex"), Table("vertex"),       Table("piece"),
                                    Table("fragment"),   Table("round_trip", 0)};
  std::vector<std::string> unknown_;
};

}  // namespace glassbox
