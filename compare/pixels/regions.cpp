#include <glassbox/compare/pixels/regions.h>

#include <algorithm>
#include <tuple>

namespace glassbox {
namespace {

bool worse(const Region& a, const Region& b) {
  const auto rank = [](const Region& r) {
    return std::tuple(~std::uint64_t(r.largest), ~r.pixels, r.worst.y, r.worst.x);
  };
  return rank(a) < rank(b);
}

PixelBox bounding_box(const PixelBox& a, const PixelBox& b) {
  const int left = std::min(a.x, b.x), top = std::min(a.y, b.y);
  return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
          std::max(a.y + a.height, b.y + b.height) - top};
}

void merge_region(Region& into, const Region& other) {
  const auto earlier = [](PixelPosition a, PixelPosition b) {
    return std::tuple(a.y, a.x) < std::tuple(b.y, b.x);
  };
  if (other.largest > into.largest ||
      (other.largest == into.largest && earlier(other.worst, into.worst))) {
    into.worst = other.worst;
    into.largest = other.largest;
  }
  into.pixels += other.pixels;
  into.box = bounding_box(into.box, other.box);
}

}  // namespace

// Every run of differing pixels starts as a component of its own.
std::vector<RegionFinder::Run> RegionFinder::find_runs(int y,
                                                       std::span<const std::uint32_t> steps) {
  std::vector<Run> runs;
  const int width = int(steps.size());
  for (int x = 0; x < width; ++x) {
    if (steps[std::size_t(x)] == 0) continue;
    Run run{x, x, open_.size()};
    Region region{{x, y, 0, 1}, 0, 0, {x, y}};
    for (; x < width && steps[std::size_t(x)] > 0; ++x) {
      if (steps[std::size_t(x)] > region.largest) {
        region.largest = steps[std::size_t(x)];
        region.worst = {x, y};
      }
      run.last = x;
    }
    region.box.width = run.last - run.first + 1;
    region.pixels = std::uint64_t(region.box.width);
    runs.push_back(run);
    into_.push_back(open_.size());
    open_.push_back(region);
  }
  return runs;
}

std::size_t RegionFinder::root(std::size_t region) {
  while (into_[region] != region) region = into_[region] = into_[into_[region]];
  return region;
}

void RegionFinder::join(std::size_t a, std::size_t b) {
  a = root(a);
  b = root(b);
  if (a == b) return;
  merge_region(open_[a], open_[b]);
  into_[b] = a;
}

void RegionFinder::add_row(int y, std::span<const std::uint32_t> steps) {
  std::vector<Run> runs = find_runs(y, steps);
  // The runs of both rows are sorted, so one pass over the two lists finds every two runs that
  // touch, corners included.
  std::size_t above = 0;
  for (const Run& run : runs) {
    while (above < runs_.size() && runs_[above].last < run.first - 1) ++above;
    for (std::size_t i = above; i < runs_.size() && runs_[i].first <= run.last + 1; ++i) {
      join(runs_[i].region, run.region);
    }
  }
  close_all_but(runs);
}

// Keeps the components that `runs` belong to, renumbered from 0, and closes the others.
void RegionFinder::close_all_but(std::vector<Run>& runs) {
  constexpr std::size_t kClosed = ~std::size_t(0);
  std::vector<std::size_t> number(open_.size(), kClosed);
  std::vector<Region> still_open;
  for (Run& run : runs) {
    const std::size_t region = root(run.region);
    if (number[region] == kClosed) {
      number[region] = still_open.size();
      still_open.push_back(open_[region]);
    }
    run.region = number[region];
  }
  for (std::size_t region = 0; region < open_.size(); ++region) {
    if (into_[region] == region && number[region] == kClosed) keep(open_[region]);
  }
  runs_ = std::move(runs);
  open_ = std::move(still_open);
  into_.resize(open_.size());
  for (std::size_t region = 0; region < into_.size(); ++region) into_[region] = region;
}

void RegionFinder::keep(const Region& region) {
  ++count_;
  closed_.push_back(region);
  std::push_heap(closed_.begin(), closed_.end(), worse);
  if (closed_.size() <= kept_) return;
  std::pop_heap(closed_.begin(), closed_.end(), worse);
  closed_.pop_back();
}

std::vector<Region> RegionFinder::worst() {
  std::vector<Run> none;
  close_all_but(none);
  std::vector<Region> sorted = closed_;
  std::sort_heap(sorted.begin(), sorted.end(), worse);
  return sorted;
}

}  // namespace glassbox
