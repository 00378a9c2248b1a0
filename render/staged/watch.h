// The types that watch a run of the reference's stages: one does nothing, one counts, and one
// counts and calls observers. Methods that do nothing cost no time.
//
// A stage passes its result to the observers in one line, notify(&Observer::divided, ...), with the
// method of Observer to call. A result that is counted in the statistics is passed to a count_...()
// method in a line of its own.
#pragma once

#include <optional>
#include <vector>

#include <glassbox/render/engine/observer.h>
#include <glassbox/render/engine/statistics.h>

namespace glassbox {

struct NullWatch {
  template <class... Parameters, class... Arguments>
  void notify(void (Observer::*)(Parameters...), Arguments&&...) const {}
  static constexpr const std::vector<Coverage>* covered(const FragmentSource&) { return nullptr; }

  void count_culled_early() const {}
  void count_clipped(ClipVerdict, const ClipPolygon&) const {}
  void count_set_up(const std::optional<TriangleSetup>&) const {}
  void count_faced(bool /*culled*/) const {}
  void count_finished(FragmentResult) const {}
};

// Counts the results of the stages.
struct CountingWatch : NullWatch {
  Statistics& statistics;

  explicit CountingWatch(Statistics& counts) : statistics(counts) {}

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
  void count_finished(FragmentResult result) const {
    ++statistics.covered;
    switch (result) {
      case FragmentResult::kHidden:
        ++statistics.depth_failed;
        break;
      case FragmentResult::kDiscarded:
        ++statistics.discarded;
        break;
      case FragmentResult::kBlended:
        ++statistics.blended;
        [[fallthrough]];
      case FragmentResult::kWritten:
        ++statistics.written;
        break;
    }
  }
};

// Counts, and calls observers, which may change the result of a stage. If notify() is called before
// the count_...() method, the changed result is counted.
struct ObserverWatch : CountingWatch {
  const Observers& observers;  // at least one

  ObserverWatch(Statistics& counts, const Observers& called)
      : CountingWatch(counts), observers(called) {}

  template <class... Parameters, class... Arguments>
  void notify(void (Observer::*what)(Parameters...), Arguments&&... arguments) const {
    for (Observer* observer : observers) (observer->*what)(arguments...);
  }
  const std::vector<Coverage>* covered(const FragmentSource& source) const {
    return observers.first().covered(source);
  }
};

}  // namespace glassbox
