// Traces as JSON with the schema "glassbox-trace/1" (docs/trace.md): the records with their error
// bounds.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

inline constexpr const char* kTraceSchema = "glassbox-trace/1";

// Numbers that are not finite become null. Names come from files and may not be valid UTF-8, so
// dump the result with error_handler_t::replace.
nlohmann::ordered_json to_json(const Scene& scene, const Trace& trace);

// The parts of a trace for separate use. The head is everything but the triangles, the fragments
// and the round trips.
nlohmann::ordered_json head_json(const Scene& scene, const Trace& trace);
nlohmann::ordered_json to_json(const RoundTrips& trips);
nlohmann::ordered_json to_json(const View& view);
nlohmann::ordered_json to_json(const BackFaceTest& test);
nlohmann::ordered_json to_json(const Trace& trace, const TracedTriangle& triangle,
                               const TriangleBounds& bounds);
// `known` is the fragment's triangle. It is null if the trace does not have it; the fragment's
// bounds are then left out.
nlohmann::ordered_json to_json(const Trace& trace, const TracedFragment& fragment,
                               const BoundsOfRun::KnownTriangle* known);

// A name for JSON: "hidden", "discarded", "written", "blended".
const char* name_of(FragmentResult result);

}  // namespace glassbox
