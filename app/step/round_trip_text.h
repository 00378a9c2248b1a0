// The way back from the screen to object space, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <glassbox/pipeline/round_trip.h>

namespace glassbox::app {

// A line for each coordinate: where it came back to, its bound, and how far that is from where it was. One line where the
// bounds are infinite.
std::vector<std::string> round_trip_lines(const RoundTrip& trip, bool bits);

nlohmann::ordered_json round_trip_json(const RoundTrip& trip);

}  // namespace glassbox::app
