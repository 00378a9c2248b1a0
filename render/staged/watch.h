// The types that watch a run of the staged stages: one does nothing, one counts, and one counts and
// calls observers. Methods that do nothing cost nothing.
//
// A stage passes its result to the observers in one line, tell(&Observer::divided, ...), with the
// method of Observer to call. A result that is counted in the statistics is passed to a count_...()
// method in a line of its own.
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

// Counts, and calls observers, which may change what a stage has made. If the call of tell() comes
// before the counting, the changed result is counted.
struct Observed : Counting {
  const Observers& observers;  // at least one

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
