// Who watches a run of the staged stages, as a type: nobody, somebody who counts, or somebody who
// counts and tells observers. What nobody does costs nothing.
//
// A stage says what it has made in one line, tell(&Observer::divided, ...): the events are
// Observer's. What goes into statistics it says in a line of its own.
#pragma once

#include <optional>
#include <vector>

#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/statistics.h>

namespace glassbox {

struct Nobody {
  template <class... Parameters, class... Arguments>
  void tell(void (Observer::*)(Parameters...), Arguments&&...) const {}
  static constexpr const std::vector<Coverage>* covered(const FragmentSource&) { return nullptr; }

  void count_culled_early() const {}
  void count_clipped(ClipVerdict, const ClipPolygon&) const {}
  void count_set_up(const std::optional<TriangleSetup>&) const {}
  void count_faced(bool /*culled*/) const {}
  void count_ended(Fate) const {}
};

// Counts the results of the stages.
struct Counting : Nobody {
  Statistics& statistics;

  explicit Counting(Statistics& counts) : statistics(counts) {}

  void count_culled_early() const { ++statistics.culled_early; }
  void count_clipped(ClipVerdict verdict, const ClipPolygon& polygon) const {
    switch (verdict) {
      case ClipVerdict::kAccept:
        break;
      case ClipVerdict::kReject:
        ++statistics.rejected;
        break;
      case ClipVerdict::kClip:
        ++(polygon.count == 0 ? statistics.clipped_away : statistics.clipped);
        break;
    }
  }
  void count_set_up(const std::optional<TriangleSetup>& setup) const {
    ++statistics.after_clipping;
    if (!setup) ++statistics.zero_area;
  }
  void count_faced(bool culled) const { ++(culled ? statistics.culled : statistics.set_up); }
  void count_ended(Fate fate) const {
    ++statistics.covered;
    switch (fate) {
      case Fate::kHidden:
        ++statistics.depth_failed;
        break;
      case Fate::kDiscarded:
        ++statistics.discarded;
        break;
      case Fate::kBlended:
        ++statistics.blended;
        [[fallthrough]];
      case Fate::kWritten:
        ++statistics.written;
        break;
    }
  }
};

// Counts, and tells observers, who may change what a stage has made: what is counted after a stage
// was told is what goes on.
struct Observed : Counting {
  const Observers& observers;  // some

  Observed(Statistics& counts, const Observers& told) : Counting(counts), observers(told) {}

  template <class... Parameters, class... Arguments>
  void tell(void (Observer::*what)(Parameters...), Arguments&&... arguments) const {
    for (Observer* observer : observers) (observer->*what)(arguments...);
  }
  const std::vector<Coverage>* covered(const FragmentSource& source) const {
    return observers.first().covered(source);
  }
};

}  // namespace glassbox
