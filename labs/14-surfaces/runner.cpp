// Calls your functions with the cases of lab 14.
#include "labs/framework/runner.h"
#include "generators.h"
#include "student.h"

namespace lab_14 {
namespace {

using glassbox::labs::Answer;

// The edges of all polygons, one polygon after the other, with -1 after each.
std::vector<double> edge_list(const std::vector<std::vector<int>>& polygons) {
  std::vector<double> all;
  for (const std::vector<int>& polygon : polygons) {
    all.insert(all.end(), polygon.begin(), polygon.end());
    all.push_back(-1);
  }
  return all;
}

void cell(const CellCase& input, Answer& answer) {
  answer.emit("edges of the polygons", edge_list(cell_polygons(input.inside)));
}
// BEGIN HIDDEN
void sixteen_cells(const CellsCase& input, Answer& answer) {
  for (unsigned inside = input.first; inside < input.first + 16; ++inside)
    answer.emit("edges for corners " + std::to_string(inside), edge_list(cell_polygons(inside)));
}
// END HIDDEN

void edge(const EdgeCase& input, Answer& answer) {
  answer.emit("share", {crossing(input.from, input.to, input.level)});
}

// Emits the id of the nearest sample of each pixel after each edit, and all samples at the end.
void edited(const EditCase& input, Answer& answer) {
  Layers layers(input.pixels);
  std::vector<double> seen;
  for (const Edit& edit : input.edits) {
    if (edit.comes)
      add(layers, edit.id, edit.covered);
    else
      remove(layers, edit.id, edit.covered);
    for (const std::vector<Sample>& here : layers)
      seen.push_back(here.empty() ? -1 : here.front().id);
  }
  answer.emit("ids seen", seen);
  std::vector<double> counts, ids, distances;
  for (const std::vector<Sample>& here : layers) {
    counts.push_back(double(here.size()));
    for (const Sample& s : here) {
      ids.push_back(s.id);
      distances.push_back(s.distance);
    }
  }
  answer.emit("samples of each pixel", counts);
  answer.emit("ids", ids);
  answer.emit("distances", distances);
}

void weights(const ViewCase& input, Answer& answer) {
  const auto w = view_weights(input.direction, input.views, input.sees);
  answer.emit("weights", {w[0], w[1], w[2]});
}

void moments(const BandCase& input, Answer& answer) {
  const Statistics found = statistics(input.pixels);
  answer.emit("mean", found.mean);
  std::vector<double> all;
  for (const auto& row : found.covariance) all.insert(all.end(), row.begin(), row.end());
  answer.emit("covariance", all);
}

void emit_reconstruction(const BandCase& input, Answer& answer) {
  const Reconstruction made = reconstruct(input.pixels, input.mean, input.vectors, input.k);
  std::vector<double> all;
  for (const auto& pixel : made.pixels) all.insert(all.end(), pixel.begin(), pixel.end());
  answer.emit("reconstructed bands", all);
  answer.emit("mean square error", {made.error});
}

}  // namespace
}  // namespace lab_14

std::vector<glassbox::labs::RunnerCheck> glassbox::labs::runner_checks() {
  using namespace lab_14;
  return {
      check("polygons of a cell", cells(), cell), check("where an edge is crossed", edges(), edge),
      check("polygons come and go", edits(), edited),
      check("weights of three views", views_around(), weights),
      check("mean and covariance", bands(), moments),
      check("what the components have", bands(), emit_reconstruction),
      generated_check("the polygons of any cell", generated_cells(), cell),
      generated_check("any edge", generated_edges(), edge),
      generated_check("any polygons come and go", generated_edits(), edited),
      generated_check("weights of any views", generated_views_around(), weights),
      generated_check("covariance of any bands", generated_bands(), moments),
      generated_check("any components", generated_components(), emit_reconstruction),
      // BEGIN HIDDEN
      check("cells of every kind", hidden_cells(), sixteen_cells),
      check("edges of other values", hidden_edges(), edge),
      check("other polygons come and go", hidden_edits(), edited),
      check("weights of other views", hidden_views_around(), weights),
      check("covariance of other bands", hidden_bands(), moments),
      check("components of other bands", hidden_bands(), emit_reconstruction),
      // END HIDDEN
  };
}
