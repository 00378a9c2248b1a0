#include "app/frames/frames.h"

#include <chrono>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/frames/eye_plan.h"
#include "app/frames/frames_report.h"
#include "cli/frames/frame_range.h"
#include "cli/frames/path_file.h"
#include "cli/frames/sequence_frames.h"
#include "cli/frames/stop_request.h"
#include "cli/options/scene_input.h"
#include "cli/report/exit_codes.h"
#include "cli/report/output.h"
#include "cli/report/progress.h"

#include <glassbox/base/counted.h>
#include <glassbox/base/elapsed.h>
#include <glassbox/images/recipe.h>
#include <glassbox/images/write.h>
#include <glassbox/render/renderer.h>

namespace glassbox::app {

namespace {

using Clock = std::chrono::steady_clock;

// A picture, with the numbers measured in it.
struct DrawnFrame {
  Image<Rgba8> image;
  FrameRecord record;
};

class FramesRun {
public:
  explicit FramesRun(const FramesRequest& request) : request_(request) {}

  int run() {
    for (const auto step :
         {&FramesRun::check, &FramesRun::load, &FramesRun::place_cameras, &FramesRun::plan}) {
      if (const auto done = (this->*step)(); !done) return refuse(done.error());
    }
    const StopRequest stop;
    for (std::size_t i = first_index(); i < end_index(); ++i) {
      if (stop.is_requested()) return report_stop();
      progress_.phase(frame_progress("rendering", i));
      if (const auto written = render(i); !written) return refuse(written.error());
    }
    if (const auto written = write_others(); !written) return refuse(written.error());
    progress_.done();
    if (request_.json != "-") fmt::print("{}", frames_text(report_));
    return kSuccess;
  }

private:
  const FrameRange& range() const { return *request_.frames.range; }
  int count() const { return range().count; }
  // The eyes depend on the neighbouring frames, so they are chosen for all frames together, even if
  // only some are drawn.
  FrameRange planned_range() const { return stereo() ? FrameRange{1, count(), count()} : range(); }
  // The indices of the first frame that is drawn, and of the one after the last.
  std::size_t first_index() const { return std::size_t(range().first - planned_range().first); }
  std::size_t end_index() const { return std::size_t(range().last - planned_range().first) + 1; }
  bool stereo() const { return request_.stereo.form.wanted; }
  const Size& size() const { return request_.picture.size; }

  std::string frame_progress(const char* what, std::size_t i) const {
    return fmt::format("{} frame {} of {}", what, sequence_[i].number, count());
  }

  Result<void> read_path() {
    if (request_.frames.turntable) return {};
    const auto path = read_camera_path(*request_.frames.path);
    if (!path) return tl::unexpected(path.error());
    path_ = *path;
    return check_path_options(request_.picture, path_);
  }

  Result<void> check() {
    if (const auto read = read_path(); !read) return read;
    const auto names = FrameNames::from_output(request_.output, request_.default_output, count());
    if (!names) return tl::unexpected(names.error());
    names_ = *names;
    report_.scene = request_.scene;
    report_.path = request_.frames.path.value_or("");
    report_.range = range();
    report_.size = size();
    if (stereo() && !range().is_slice()) {
      report_.plot = request_.frames.plot.value_or(names_.plot());
    }
    return check_paths();
  }

  Result<void> check_paths() const {
    if (const auto legal = check_image_path(names_.name(1)); !legal) return legal;
    std::vector<std::string> paths;
    for (int number = range().first; number <= range().last; ++number) {
      paths.push_back(names_.name(number));
    }
    if (!report_.plot.empty()) paths.push_back(report_.plot);
    if (request_.json && *request_.json != "-") paths.push_back(*request_.json);
    return check_outputs(paths);
  }

  Result<void> load() {
    progress_.phase("loading " + scene_title(request_.scene));
    Result<Scene> scene =
        load_scene_argument(request_.scene, request_.limits).and_then([&](Scene loaded) {
          return with_model_matrix(std::move(loaded), request_.picture.matrices);
        });
    if (!scene) return tl::unexpected(scene.error());
    scene_ = with_texture_filter(std::move(*scene), request_.picture);
    renderer_.emplace(make_renderer(scene_, request_.picture.settings, request_.engine));
    for (const std::string& warning : scene_.warnings) progress_.print_line("warning: " + warning);
    return {};
  }

  Result<void> place_cameras() {
    progress_.phase("following the path");
    std::optional<Turntable> turntable;
    if (request_.frames.turntable) {
      const double aspect = double(size().width) / double(size().height);
      const auto made = make_turntable(scene_, request_.picture.camera, aspect);
      if (!made) return tl::unexpected(made.error());
      turntable = *made;
    }
    auto sequence =
        make_sequence_frames(scene_, request_.picture, path_, turntable, planned_range(), stereo());
    if (!sequence) return tl::unexpected(sequence.error());
    sequence_ = std::move(*sequence);
    note_path_problems();
    return {};
  }

  void note_path_problems() {
    const double end = path_.keyframes.empty() ? 0 : path_.keyframes.back().time;
    if (path_.keyframes.size() == 1 && count() > 1) {
      progress_.print_line("note: the path has one keyframe: the camera stands still");
    } else if (path_.clock == PathClock::kFrames && end > count()) {
      progress_.print_line(
          fmt::format("note: the path continues to frame {}, but --frames is {}", end, count()));
    }
    std::error_code ignored;
    const std::string next = names_.name(count() + 1);
    if (std::filesystem::exists(next, ignored)) {
      progress_.print_line("note: " + next +
                           " is there from an earlier, longer sequence, and is not removed");
    }
  }

  Result<void> plan() {
    if (!stereo()) return {};
    const FramesOptions& frames = request_.frames;
    const auto px = [&](double percent) { return percent * size().width / 100; };
    report_.budget = {px(frames.budget_percent[0]), px(frames.budget_percent[1])};
    const EyePlanLimits limits{report_.budget, request_.picture.eyes.separation,
                               frames.release_frames, frames.max_step};
    const StereoSettings settings{request_.picture.settings, request_.stereo.culling};
    auto plan = plan_eyes(*renderer_, sequence_, limits, settings, [this](std::size_t i) {
      progress_.phase(frame_progress("looking at", i));
    });
    if (!plan) return tl::unexpected(plan.error());
    report_.eyes = std::move(*plan);
    return {};
  }

  Result<DrawnFrame> draw(std::size_t i) {
    const SequenceFrame& frame = sequence_[i];
    FrameRecord record = record_of(frame, names_.name(frame.number));
    RenderSettings settings = request_.picture.settings;
    if (!stereo()) {
      return DrawnFrame{renderer_->render(frame.centre, settings).buffers.color, record};
    }
    settings.want_distance = true;
    const StereoPair& pair = report_.eyes->pairs[i];
    const ChosenEyes eyes{frame.camera, frame.centre, {pair, "", ""}};
    return render_stereo_picture(*renderer_, scene_, eyes, settings, request_.stereo, second_)
        .map([&](StereoPicture drawn) {
          measure_parallax(record, frame.centre, pair, depth_seen_in(drawn.rendering));
          return DrawnFrame{std::move(drawn.image), record};
        });
  }

  Result<void> render(std::size_t i) {
    const Result<DrawnFrame> drawn = draw(i);
    if (!drawn) return tl::unexpected(drawn.error());
    std::vector<const CLI::Option*> options = request_.picture.options;
    options.insert(options.end(), request_.stereo.options.begin(), request_.stereo.options.end());
    const StereoPair* pair = stereo() ? &report_.eyes->pairs[i] : nullptr;
    std::vector<TextEntry> recipe;  // empty for a scene from a pipe, which cannot be read again
    if (request_.scene != "-") {
      recipe = to_text(Recipe{request_.scene, frame_command_words(sequence_[i], pair, options),
                              GLASSBOX_VERSION});
    }
    report_.frames.push_back(drawn->record);
    return write_image(drawn->record.image, drawn->image, recipe);
  }

  Result<void> write_others() {
    note_odd_frames();
    report_.total_ms = elapsed_ms(start_);
    if (!report_.plot.empty()) {
      const auto written = write_text(report_.plot, plot_svg(report_));
      if (!written) return written;
    }
    return request_.json ? write_json(*request_.json, frames_json(report_)) : Result<void>{};
  }

  // Prints notes about frames that show nothing, and about frames whose separation is less than a
  // hundredth of the largest one.
  void note_odd_frames() {
    if (!report_.eyes) return;
    double most = 0;
    for (const FrameRecord& frame : report_.frames) {
      most = std::max(most, frame.pair.half_separation);
    }
    int nothing = 0, flat = 0;
    const FrameRecord* flattest = nullptr;
    for (const FrameRecord& frame : report_.frames) {
      nothing += !frame.seen;
      if (!frame.seen || frame.pair.half_separation >= most / 100) continue;
      const double least = flattest ? flattest->pair.half_separation : most;
      if (frame.pair.half_separation < least) flattest = &frame;
      ++flat;
    }
    if (nothing > 0) {
      progress_.print_line(
          fmt::format("note: no part of the scene is in view in {}", counted(nothing, "frame")));
    }
    if (flat > 0) {
      progress_.print_line(fmt::format(
          "note: in {} the eye separation is less than a hundredth of its largest value along the "
          "path; in frame {} something is only {:.3g} world units in front of the camera",
          counted(flat, "frame"), flattest->number, flattest->seen->nearest));
    }
  }

  int report_stop() {
    progress_.done();
    fmt::print(stderr, "glassbox: stopped: {} of {} {} written\n", report_.frames.size(),
               counted(end_index() - first_index(), "frame"),
               singular_or_plural(report_.frames.size(), "is", "are"));
    return kFailure;
  }

  const FramesRequest& request_;
  const Clock::time_point start_ = Clock::now();
  Progress progress_;
  CameraPath path_;
  FrameNames names_;
  Scene scene_;
  std::optional<Renderer> renderer_;  // draws scene_
  views::SecondEye second_;
  std::vector<SequenceFrame> sequence_;
  FramesReport report_;
};

}  // namespace

int render_frames(const FramesRequest& request) {
  return FramesRun(request).run();
}

}  // namespace glassbox::app
