// The vertices and triangles of the draws in the run of one eye. There is a class for an eye alone,
// one for the first eye of a pair, and one for the second eye, which reuses the results of the
// first eye's run (S0-03).
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glassbox/render/engine/engine.h>
#include <glassbox/render/engine/stopwatch.h>
#include <glassbox/render/staged/culling_list.h>
#include <glassbox/render/staged/vertex_stage.h>

namespace glassbox {

// Transforms the vertices of one draw.
template <class Watch>
DrawTables transform_draw(const Draw& draw, const EyePicture& eye, const Watch& watch) {
  Statistics& counts = eye.statistics;
  const Stopwatch stopwatch(counts.vertex_ms);
  DrawTables tables{project_vertices(draw, eye.view, watch),
                    make_eye_space_tables(draw, eye.settings)};
  counts.vertices += tables.clip.positions.size();
  counts.plane_tests += tables.clip.positions.size();
  counts.normals += tables.eye_space.normals.size() + tables.eye_space.face_normals.size();
  counts.eye_positions += tables.eye_space.positions.size();
  return tables;
}

class SingleEye {
public:
  explicit SingleEye(const std::vector<Draw>& draws) : draws_(draws) {}

  const std::vector<Draw>& draws() const { return draws_; }
  template <class Watch>
  const DrawTables& vertices(std::size_t draw, const EyePicture& eye, const Watch& watch) {
    tables_ = transform_draw(draws_[draw], eye, watch);
    return tables_;
  }
  std::span<const Triangle> triangles(std::size_t draw) const {
    return draws_[draw].triangulation->triangles;
  }

private:
  const std::vector<Draw>& draws_;
  DrawTables tables_;
};

// The data that the eyes of a pair share.
struct PairSharedData {
  // One for each draw; x in clip space is that of the current eye.
  std::vector<DrawTables> tables;
  std::optional<CullingList> culling;  // absent: all triangles are submitted

  std::span<const Triangle> triangles(const Draw& draw, std::size_t index) const {
    if (culling) return culling->triangles_of(index);
    return draw.triangulation->triangles;
  }
};

class FirstEyeOfPair {
public:
  FirstEyeOfPair(const std::vector<Draw>& draws, PairSharedData& pair)
      : draws_(draws), pair_(pair) {
    pair_.tables.resize(draws.size());
  }

  const std::vector<Draw>& draws() const { return draws_; }
  template <class Watch>
  const DrawTables& vertices(std::size_t draw, const EyePicture& eye, const Watch& watch) {
    DrawTables& tables = pair_.tables[draw];
    tables = transform_draw(draws_[draw], eye, watch);
    if (pair_.culling) pair_.culling->cull_draw(draw, tables.clip);
    return tables;
  }
  std::span<const Triangle> triangles(std::size_t draw) const {
    return pair_.triangles(draws_[draw], draw);
  }

private:
  const std::vector<Draw>& draws_;
  PairSharedData& pair_;
};

class SecondEyeOfPair {
public:
  SecondEyeOfPair(const std::vector<Draw>& draws, PairSharedData& pair)
      : draws_(draws), pair_(pair) {}

  const std::vector<Draw>& draws() const { return draws_; }
  template <class Watch>
  const DrawTables& vertices(std::size_t draw, const EyePicture& eye, const Watch& watch) {
    Statistics& counts = eye.statistics;
    const Stopwatch stopwatch(counts.vertex_ms);
    DrawTables& tables = pair_.tables[draw];
    tables.clip = project_other_eye(draws_[draw], eye.view, std::move(tables.clip), watch);
    counts.moved_in_x += tables.clip.positions.size();
    counts.plane_tests += tables.clip.positions.size();
    return tables;
  }
  std::span<const Triangle> triangles(std::size_t draw) const {
    return pair_.triangles(draws_[draw], draw);
  }

private:
  const std::vector<Draw>& draws_;
  PairSharedData& pair_;
};

}  // namespace glassbox
