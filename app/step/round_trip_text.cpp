#include "app/step/round_trip_text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/step/numbers_text.h"

namespace glassbox::app {

std::vector<std::string> round_trip_lines(const RoundTrip& trip, bool bits) {
  if (!trip.is_bounded()) return {"the three numbers do not tell where it was: no bound is finite"};
  const double back[] = {trip.object.x, trip.object.y, trip.object.z};
  const char* axes[] = {"x", "y", "z"};
  std::vector<std::string> lines;
  for (int i = 0; i < 3; ++i) {
    lines.push_back(fmt::format(
        "{}{}{}", number_line(axes[i], back[i], trip.bound[i], bits), bits ? "  " : "",
        trip.error[i] == 0 ? "as it was" : fmt::format("off by {:.1e}", trip.error[i])));
  }
  return lines;
}

nlohmann::ordered_json round_trip_json(const RoundTrip& trip) {
  return {{"object", {trip.object.x, trip.object.y, trip.object.z}},
          {"error", {trip.error.x, trip.error.y, trip.error.z}},
          {"bound", {trip.bound.x, trip.bound.y, trip.bound.z}}};
}

}  // namespace glassbox::app
