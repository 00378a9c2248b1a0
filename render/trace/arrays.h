// The numbers of a run's records as arrays: one array for each number, one row for each record, for
// programs that work with arrays (docs/trace.md lists them). The vertices that clipping left of a
// triangle, and the triangles of its fan (pieces), vary in number, so they are in tables of their
// own; the triangle's row has the index of its first row there, and the number of rows.
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

// Counts the records of a run, and keeps only the records of draws.
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
  // Must be called after the last record.
  void finish();

  // Returns the names in `wanted` that do not exist.
  std::vector<std::string> unknown() const { return unknown_; }
  // Returns the number of bytes that all wanted arrays take for a run with these counts.
  std::uint64_t bytes_for(const TraceCounts& counts) const;
  // Reserves the memory for a run with these counts at once, so that no more is needed later.
  void reserve(const TraceCounts& counts);
  const RoundTrips& round_trips() const { return round_trips_; }

  // The tables in the order of the stages.
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
