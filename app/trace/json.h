// Traces as JSON, schema "glassbox-trace/1" (docs/trace.md): the records with their error bounds.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <glassbox/mesh/scene.h>
#include <glassbox/render/trace/bounds.h>
#include <glassbox/render/trace/records.h>

namespace glassbox {

inline constexpr const char* kTraceSchema = "glassbox-trace/1";

// Numbers that are not finite become null. Names come from files and may be anything but UTF-8: dump with
// error_handler_t::replace.
nlohmann::ordered_json to_json(const Scene& scene, const Trace& trace);

// The parts, for those who want them alone. The head is all but the triangles, the fragments and the round trips.
nlohmann::ordered_json head_json(const Scene& scene, const Trace& trace);
nlohmann::ordered_json to_json(const RoundTrips& trips);
nlohmann::ordered_json to_json(const View& view);
nlohmann::ordered_json to_json(const BackFaceTest& test);
nlohmann::ordered_json to_json(const Trace& trace, const TracedTriangle& triangle,
                               const TriangleBounds& bounds);
// `known`: the fragment's triangle; null where the trace does not have it, and the fragment's bounds are left out then.
nlohmann::ordered_json to_json(const Trace& trace, const TracedFragment& fragment,
                               const BoundsOfRun::Known* known);

// For programs: "hidden", "discarded", "written", "blended".
const char* name_of(Fate fate);

}  // namespace glassbox
