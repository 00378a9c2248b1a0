#include "labs/measuring/claim.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "study/experiment/pareto.h"
#include "study/experiment/results_json.h"

namespace glassbox::labs {

namespace {

using Json = nlohmann::ordered_json;

bool is_one_of(const std::string& name, const std::vector<std::string>& all) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

// Reads a number as results_json.h writes it: infinities and NaN are strings.
double number_in(const Json& value) {
  if (value.is_number()) return value.get<double>();
  const double infinity = std::numeric_limits<double>::infinity();
  if (value == "infinity") return infinity;
  return value == "-infinity" ? -infinity : std::numeric_limits<double>::quiet_NaN();
}

bool same_number(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

std::string name_of(const ClaimedPoint& point) {
  std::string name = fmt::format("{} at {:g}", point.series, point.parameter);
  for (const std::string& more : {point.scene, point.measure}) {
    if (!more.empty()) name += ", " + more;
  }
  return name;
}

// Thrown with the reason why a file is no claim.
struct ClaimFormatError {
  std::string cause;
};

const Json& field(const Json& json, const char* name) {
  if (const auto found = json.find(name); found != json.end()) return *found;
  throw ClaimFormatError{fmt::format("has no '{}'", name)};
}

ClaimedPoint point_of(const Json& json) {
  ClaimedPoint point;
  point.series = field(json, "series").get<std::string>();
  point.measure = json.value("measure", "");
  point.scene = json.value("scene", "");
  point.parameter = field(json, "parameter").get<double>();
  point.error = number_in(field(json, "error"));
  const Json& ns = field(json, "ns_quartiles");
  point.ns = {number_in(ns.at(0)), number_in(field(json, "ns")), number_in(ns.at(1))};
  point.faster_than = field(json, "faster_than").get<std::vector<std::string>>();
  point.slower_than = field(json, "slower_than").get<std::vector<std::string>>();
  return point;
}

void compare(const ClaimedPoint& claimed, const ClaimedPoint& measured,
             std::vector<std::string>& found) {
  const std::string name = name_of(claimed);
  if (!same_number(claimed.error, measured.error))
    found.push_back(fmt::format("{}: the measured error is {:.6g}, not {:.6g}", name,
                                measured.error, claimed.error));
  for (const std::string& way : claimed.faster_than) {
    if (is_one_of(way, measured.slower_than))
      found.push_back(fmt::format("{}: measured as slower than \"{}\", not faster", name, way));
  }
  for (const std::string& way : claimed.slower_than) {
    if (is_one_of(way, measured.faster_than))
      found.push_back(fmt::format("{}: measured as faster than \"{}\", not slower", name, way));
  }
}

}  // namespace

std::string owner_text(const Claim& claim) {
  return fmt::format("{} (student.cpp with the digest {}), on {}",
                     claim.submission.empty() ? "a submission without a name" : claim.submission,
                     claim.code,
                     claim.machine.empty() ? "a machine without a name" : claim.machine);
}

Claim claim_of(const std::string& lab, const std::string& submission, const std::string& code,
               const study::Origin& origin, const study::ExperimentResult& result,
               const std::vector<std::string>& series) {
  Claim claim{lab, submission, code, result.id, origin.machine, origin.version, {}};
  for (const auto& each : result.configurations) {
    const study::Timing* const mine = study::timing_of(each, 1);
    if (!is_one_of(each.series, series) || mine == nullptr) continue;
    ClaimedPoint point{each.series, each.measure, each.scene, each.parameter,
                       each.error,  mine->ns,     {},         {}};
    for (const auto& other : result.configurations) {
      const study::Timing* const theirs = study::timing_of(other, 1);
      if (is_one_of(other.series, series) || theirs == nullptr ||
          !study::are_competitors(result, each, other))
        continue;
      if (mine->ns.upper < theirs->ns.lower) point.faster_than.push_back(other.series);
      if (theirs->ns.upper < mine->ns.lower) point.slower_than.push_back(other.series);
    }
    claim.points.push_back(std::move(point));
  }
  return claim;
}

Json claim_json(const Claim& claim) {
  Json points = Json::array();
  for (const ClaimedPoint& each : claim.points) {
    Json point{{"series", each.series}};
    if (!each.measure.empty()) point["measure"] = each.measure;
    if (!each.scene.empty()) point["scene"] = each.scene;
    point["parameter"] = each.parameter;
    point["error"] = study::number_json(each.error);
    point["ns"] = study::number_json(each.ns.median);
    point["ns_quartiles"] = {study::number_json(each.ns.lower), study::number_json(each.ns.upper)};
    point["faster_than"] = each.faster_than;
    point["slower_than"] = each.slower_than;
    points.push_back(std::move(point));
  }
  return {{"lab", claim.lab},           {"submission", claim.submission},
          {"code", claim.code},         {"experiment", claim.experiment},
          {"machine", claim.machine},   {"version", claim.version},
          {"points", std::move(points)}};
}

Result<Claim> read_claim(const std::string& path, const std::string& text) {
  const auto refused = [&](const std::string& cause) {
    return fail(path, "is not the measurement of a lab: it " + cause,
                "glassbox lab measure FOLDER --json FILE writes one");
  };
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return refused("is not a JSON object");
  try {
    Claim claim{field(json, "lab").get<std::string>(),
                json.value("submission", ""),
                field(json, "code").get<std::string>(),
                field(json, "experiment").get<std::string>(),
                json.value("machine", ""),
                json.value("version", ""),
                {}};
    for (const Json& each : field(json, "points")) claim.points.push_back(point_of(each));
    return claim;
  } catch (const ClaimFormatError& unread) {
    return refused(unread.cause);
  } catch (const Json::exception&) {
    return refused("has a value of the wrong type");
  }
}

std::vector<std::string> contradictions(const Claim& claimed, const Claim& measured) {
  std::vector<std::string> found;
  if (claimed.lab != measured.lab)
    found.push_back(fmt::format("it is for lab {}, not for lab {}", claimed.lab, measured.lab));
  if (claimed.experiment != measured.experiment)
    found.push_back(fmt::format("it is of experiment {}, but experiment {} was measured",
                                claimed.experiment, measured.experiment));
  if (!found.empty()) return found;
  if (claimed.code != measured.code)
    found.push_back("it was made with another student.cpp than this measurement");
  for (const ClaimedPoint& each : claimed.points) {
    const auto is_it = [&](const ClaimedPoint& other) { return name_of(other) == name_of(each); };
    if (std::ranges::none_of(measured.points, is_it))
      found.push_back(fmt::format("{}: is not a point of this lab's measurement", name_of(each)));
    if (&*std::ranges::find_if(claimed.points, is_it) != &each)
      found.push_back(fmt::format("{}: appears twice", name_of(each)));
  }
  for (const ClaimedPoint& each : measured.points) {
    const auto same =
        std::find_if(claimed.points.begin(), claimed.points.end(),
                     [&](const ClaimedPoint& other) { return name_of(other) == name_of(each); });
    if (same == claimed.points.end()) {
      found.push_back(fmt::format("{}: is missing", name_of(each)));
    } else {
      compare(*same, each, found);
    }
  }
  return found;
}

}  // namespace glassbox::labs
