// Finds connected components of the pixels that differ, row by row.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glassbox/compare/pixels/differences.h>

namespace glassbox {

// Finds the components of a picture whose rows are added from the top. A component is open while it
// reaches the last row added. Only open components and the worst of the closed ones are kept, so
// the memory is proportional to a row and to `kept`.
class RegionFinder {
public:
  RegionFinder(int width, std::size_t kept) : kept_(kept) { runs_.reserve(std::size_t(width)); }

  // `steps[x]` is above 0 where pixel (x, y) differs; y counts up by one from call to call.
  void add_row(int y, std::span<const std::uint32_t> steps);

  // The worst regions first: by largest difference, then by pixels, then from the top left. Closes
  // all open components.
  std::vector<Region> worst();
  std::uint64_t count() const { return count_; }  // number of all regions, valid after worst()

private:
  // Neighbouring pixels of one row, first to last, that belong to the component `region` of
  // `open_`.
  struct Run {
    int first = 0, last = 0;
    std::size_t region = 0;
  };

  std::vector<Run> find_runs(int y, std::span<const std::uint32_t> steps);
  std::size_t root(std::size_t region);
  void join(std::size_t a, std::size_t b);
  void close_all_but(std::vector<Run>& runs);
  void keep(const Region& region);

  std::size_t kept_;
  std::uint64_t count_ = 0;
  std::vector<Run> runs_;     // of the last row
  std::vector<Region> open_;  // components that the runs belong to
  // If a component was joined to another one, the index of that one in `open_`, otherwise its own
  // index.
  std::vector<std::size_t> into_;
  std::vector<Region> closed_;  // a heap with the smallest difference on top
};

}  // namespace glassbox
