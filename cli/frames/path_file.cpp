#include "cli/frames/path_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <glassbox/base/printable.h>
#include <glassbox/images/read.h>
#include <glassbox/pipeline/look_at.h>
#include <glassbox/pipeline/number_text.h>

namespace glassbox {

namespace {

using JsonEvent = nlohmann::json::parse_event_t;

// The levels of brackets in a file: a path, its list of keyframes, a keyframe, an array of numbers.
constexpr int kDeepest = 4;
constexpr double kMaxNumber = std::numeric_limits<float>::max();

// ---- JSON ----

// Reports errors that the JSON parser itself accepts: brackets nested deeper than a path's, and
// keys that occur twice.
class Watch {
public:
  bool operator()(int depth, JsonEvent event, const nlohmann::json& value) {
    if (event == JsonEvent::object_start || event == JsonEvent::array_start) {
      if (depth >= kDeepest) problem_ = "lists or objects are nested too deeply for a camera path";
      if (event == JsonEvent::object_start) keys_.emplace_back();
    } else if (event == JsonEvent::object_end) {
      keys_.pop_back();
    } else if (event == JsonEvent::key) {
      const std::string key = value.get<std::string>();
      if (!keys_.back().insert(key).second) {
        problem_ = "the key " + in_quotes(key) + " occurs twice";
      }
    }
    if (!problem_.empty()) throw Stop{problem_};
    return true;
  }

  struct Stop {
    std::string problem;
  };

private:
  std::vector<std::set<std::string>> keys_;  // of each object that is not closed yet
  std::string problem_;
};

// The place of a byte in the text: "line 3, column 7", counted from 1.
std::string place_in(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const std::size_t line_start = before.rfind('\n');
  const std::size_t column =
      before.size() - (line_start == std::string_view::npos ? 0 : line_start + 1);
  return fmt::format("line {}, column {}", std::ranges::count(before, '\n') + 1, column + 1);
}

Result<nlohmann::json> parse_json(std::string_view text) {
  Watch watch;
  try {
    return nlohmann::json::parse(text, [&watch](int depth, JsonEvent event, nlohmann::json& value) {
      return watch(depth, event, value);
    });
  } catch (const Watch::Stop& stop) {
    return fail("", stop.problem, "see the format in docs/stereo.md");
  } catch (const nlohmann::json::parse_error& error) {
    return fail(place_in(text, error.byte), "this is not valid JSON", "correct it there");
  } catch (const nlohmann::json::exception&) {
    return fail("", "a number is too large for a double", "make it smaller");
  }
}

// ---- values ----

std::string quoted(std::string_view key) {
  return std::string("\"").append(key).append("\"");
}

Result<void> check_keys(const nlohmann::json& object, const std::vector<std::string>& known,
                        const std::string& place) {
  for (const auto& [key, value] : object.items()) {
    if (std::ranges::find(known, key) != known.end()) continue;
    std::string names;
    for (const std::string& name : known) names += (names.empty() ? "" : ", ") + name;
    return fail(place, "unknown key " + in_quotes(key), "the keys are " + names);
  }
  return {};
}

Result<double> read_number(const nlohmann::json& value, const std::string& place) {
  if (!value.is_number()) return fail(place, "is not a number", "write a number");
  const double number = value.get<double>();
  if (!(std::abs(number) <= kMaxNumber)) {
    return fail(place, "is " + number_text(number) + ", which a float cannot hold",
                "write a smaller number");
  }
  return number;
}

Result<std::array<double, 3>> read_triple(const nlohmann::json& value, const std::string& place) {
  if (!value.is_array() || value.size() != 3) {
    return fail(place, "is not a list of three numbers", "write [x, y, z]");
  }
  std::array<double, 3> triple{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Result<double> number = read_number(value[i], place);
    if (!number) return tl::unexpected(number.error());
    triple[i] = *number;
  }
  return triple;
}

// ---- a keyframe ----

class KeyframeReader {
public:
  KeyframeReader(const nlohmann::json& object, std::size_t number, PathClock clock)
      : object_(object), place_(fmt::format("keyframe {}", number)), clock_(clock) {}

  Result<Keyframe> read() const {
    if (!object_.is_object()) {
      return fail(place_, "is not a JSON object",
                  "write {\"time\": ..., \"eye\": ..., \"look_at\": ...}");
    }
    const auto known =
        check_keys(object_, {"time", "frame", "eye", "look_at", "up", "fov", "window"}, place_);
    if (!known) return tl::unexpected(known.error());
    Keyframe keyframe;
    for (const Result<void>& part :
         {read_clock(keyframe), read_point("eye", keyframe.eye, true),
          read_point("look_at", keyframe.look_at, true), read_point("up", keyframe.up, false),
          read_fov(keyframe), read_window(keyframe), check_pose(keyframe)}) {
      if (!part) return tl::unexpected(part.error());
    }
    return keyframe;
  }

private:
  std::string place_of(std::string_view key) const { return place_ + ", " + quoted(key); }

  Result<void> read_clock(Keyframe& keyframe) const {
    const bool frames = clock_ == PathClock::kFrames;
    const char* key = frames ? "frame" : "time";
    if (object_.contains(frames ? "time" : "frame")) {
      return fail(place_of(frames ? "time" : "frame"),
                  fmt::format("the first keyframe has a {}", quoted(key)),
                  "give all of them a time, or all of them a frame");
    }
    if (!object_.contains(key)) {
      return fail(place_, "has no " + quoted(key), "give the time or frame of every keyframe");
    }
    return read_number(object_[key], place_of(key)).and_then([&](double at) -> Result<void> {
      if (frames && !(at >= 1 && at <= kMaxFrames && at == std::floor(at))) {
        return fail(place_of(key), "is " + number_text(at),
                    fmt::format("write a whole number from 1 to {}", kMaxFrames));
      }
      keyframe.time = at;
      return {};
    });
  }

  Result<void> read_point(const char* key, std::array<double, 3>& point, bool needed) const {
    if (!object_.contains(key)) {
      if (!needed) return {};
      return fail(place_, "has no " + quoted(key), "write " + quoted(key) + ": [x, y, z]");
    }
    return read_triple(object_[key], place_of(key)).map([&](const auto& read) { point = read; });
  }

  Result<void> read_fov(Keyframe& keyframe) const {
    if (!object_.contains("fov")) return {};
    return read_number(object_["fov"], place_of("fov")).and_then([&](double fov) -> Result<void> {
      if (!(fov > 0 && fov < 180)) {
        return fail(place_of("fov"), "the full vertical angle is " + number_text(fov) + " degrees",
                    "give an angle between 0 and 180 degrees");
      }
      keyframe.fov_degrees = fov;
      return {};
    });
  }

  Result<void> read_window(Keyframe& keyframe) const {
    if (!object_.contains("window") || object_["window"] == "auto") return {};
    const nlohmann::json& value = object_["window"];
    const std::string place = place_of("window");
    const char* remedy = "write a distance along the gaze, or \"auto\"";
    if (!value.is_number()) return fail(place, "is neither a number nor \"auto\"", remedy);
    return read_number(value, place).and_then([&](double window) -> Result<void> {
      // 1/window, which is interpolated, must not be above kMaxNumber either.
      if (!(window >= 1 / kMaxNumber)) {
        return fail(place, "is " + number_text(window) + ", which is not in front of the camera",
                    remedy);
      }
      keyframe.window = window;
      return {};
    });
  }

  Result<void> check_pose(const Keyframe& keyframe) const {
    const auto& [eye, target, up] = std::tie(keyframe.eye, keyframe.look_at, keyframe.up);
    const auto pose = camera_pose(Point<World, double>{eye[0], eye[1], eye[2]},
                                  Point<World, double>{target[0], target[1], target[2]},
                                  Vector<World, double>{up[0], up[1], up[2]});
    if (pose) return {};
    return fail(place_, pose.error().cause, pose.error().remedy);
  }

  const nlohmann::json& object_;
  const std::string place_;
  const PathClock clock_;
};

// ---- the whole ----

Result<void> read_header(const nlohmann::json& json, CameraPath& path) {
  if (!json.is_object() || !json.contains("camera_path")) {
    return fail("", "is not a camera path: it does not begin with {\"camera_path\": 1}",
                "see the format in docs/stereo.md");
  }
  if (json["camera_path"] != kPathVersion) {
    return fail("\"camera_path\"", "only version 1 of the format can be read",
                fmt::format("write {}", kPathVersion));
  }
  const auto known = check_keys(json, {"camera_path", "interpolation", "keyframes"}, "");
  if (!known) return known;
  if (!json.contains("interpolation")) return {};
  const nlohmann::json& interpolation = json["interpolation"];
  if (interpolation != "linear" && interpolation != "smooth") {
    return fail("\"interpolation\"", "is neither \"linear\" nor \"smooth\"", "write one of them");
  }
  path.interpolation = interpolation == "smooth" ? Interpolation::kSmooth : Interpolation::kLinear;
  return {};
}

// Whether all keyframes have the key. An error if only some do.
Result<bool> is_in_all(const nlohmann::json& keyframes, const char* key) {
  const bool first = keyframes[0].contains(key);
  for (std::size_t i = 1; i < keyframes.size(); ++i) {
    if (keyframes[i].contains(key) == first) continue;
    return fail(fmt::format("keyframe {}, {}", i + 1, quoted(key)),
                first ? "is missing, but the keyframes before this one have one"
                      : "the keyframes before have none",
                "give this value in all keyframes or in none");
  }
  return first;
}

Result<void> check_order(const CameraPath& path, std::size_t i) {
  if (i == 0) return {};
  const double before = path.keyframes[i - 1].time, at = path.keyframes[i].time;
  if (at - before >= kMinKeyframeGap) return {};
  const std::string_view key = path.clock == PathClock::kFrames ? "frame" : "time";
  return fail(fmt::format("keyframe {}, {}", i + 1, quoted(key)),
              fmt::format("is {}, but must be at least 1e-9 above {} in the keyframe before",
                          number_text(at), number_text(before)),
              "write the keyframes in order, at least 1e-9 apart");
}

Result<CameraPath> read_path(const nlohmann::json& json) {
  CameraPath path;
  if (const auto header = read_header(json, path); !header) return tl::unexpected(header.error());
  if (!json.contains("keyframes") || !json["keyframes"].is_array() || json["keyframes"].empty()) {
    return fail("\"keyframes\"", "there are none", "write a list of at least one keyframe");
  }
  const nlohmann::json& keyframes = json["keyframes"];
  if (keyframes.size() > kMaxKeyframes) {
    return fail("\"keyframes\"", fmt::format("there are {}", keyframes.size()),
                fmt::format("write {} or fewer", kMaxKeyframes));
  }
  path.clock = keyframes[0].contains("frame") ? PathClock::kFrames : PathClock::kTime;
  for (std::size_t i = 0; i < keyframes.size(); ++i) {
    const Result<Keyframe> keyframe = KeyframeReader(keyframes[i], i + 1, path.clock).read();
    if (!keyframe) return tl::unexpected(keyframe.error());
    path.keyframes.push_back(*keyframe);
    if (const auto order = check_order(path, i); !order) return tl::unexpected(order.error());
  }
  const Result<bool> fov = is_in_all(keyframes, "fov");
  if (!fov) return tl::unexpected(fov.error());
  const Result<bool> window = is_in_all(keyframes, "window");
  if (!window) return tl::unexpected(window.error());
  path.has_fov = *fov;
  path.has_window = *window;
  return path;
}

}  // namespace

Result<CameraPath> parse_camera_path(std::string_view text, const std::string& file) {
  return parse_json(text).and_then(read_path).map_error([&](Error error) {
    error.file = file;
    return error;
  });
}

Result<CameraPath> read_camera_path(const std::string& file) {
  return read_file(file, kMaxPathBytes).and_then([&](const std::vector<std::byte>& bytes) {
    return parse_camera_path({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, file);
  });
}

}  // namespace glassbox
