// A picture with a student's functions in it (glassbox lab render): which stages of the pipeline a lab's functions take the
// place of, with the reference's own way and the bounds for each.
//
// A lab's part of it is two files in its folder:
//   stages.cpp    puts records to the student's functions (framework/stages.h); in a process of its own
//   drawing.cpp   asks for them, puts the answers into the pipeline, and judges them: LabDrawing drawing_NN()
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "labs/framework/stages.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/formulation.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/staged/staged.h>

namespace glassbox::labs {

// ---- records ----

// What one call is asked.
struct Question {
  Numbers numbers;
  std::uint32_t triangle = kNone;  // of the scene; kNone: of no one triangle
};

// The first number of an answer that is not what it should be.
struct WrongNumber {
  std::string element;  // "vertex 2, w"
  double yours = 0, reference = 0;
  double bound = 0;         // of |yours - reference|, in `unit`
  std::string unit;         // "clip units", "px"; empty: a count
  std::string explanation;  // where the numbers do not say it: "missing"
};

// A stage of the picture that the student's functions do.
struct DrawnStage {
  std::string name;  // as stages.cpp has it: "clip"
  std::string
      stage;  // of the pipeline: "object", "world", "eye", "clip", "ndc", "screen", "coverage", "depth", "shading"
  std::string functions;  // of student.h: "outcode, trivial_verdict, clip_to_frustum"
  std::function<Numbers(RecordReader& in)> reference;
  // Nothing where the answer is within its contract. An answer may be of any length.
  std::function<std::optional<WrongNumber>(const Numbers& in, const Numbers& yours,
                                           const Numbers& reference)>
      judge;
};

// Who answers: the student's process, or the reference.
class Answering {
public:
  virtual ~Answering() = default;
  // One answer for each question.
  virtual Result<std::vector<Numbers>> ask(const DrawnStage& stage,
                                           std::span<const Question> questions) = 0;
};

// ---- pictures ----

// What is drawn.
struct Drawn {
  const Scene& scene;
  const Camera& camera;
  View view;
  RenderSettings settings;
  Formulation formulation;  // how the view's matrices are asked for
  StereoPair pair;          // of lab 9
};

// The same as the answers have it: data that the pipeline draws, and who stands in its stages.
struct StandIn {
  Scene scene;
  View view;
  RenderSettings settings;
  std::shared_ptr<Observer> stages;  // null: the pipeline's own
  // What is done to the picture afterwards; empty: nothing.
  std::function<void(Framebuffer& picture)> finish;

  Rendering render() const;
};

struct LabDrawing {
  std::vector<DrawnStage> stages;  // in the order of the pipeline
  std::function<Result<StandIn>(const Drawn& drawn, Answering& answering)> draw;
  std::string not_drawn;  // functions of student.h that take no part; empty: all do
  // Where the lab draws in another way than the pipeline does: what the pipeline shows, beside both. Null: the reference's picture is that.
  StandIn (*truth)(const Drawn& drawn) = nullptr;
};

// Nothing for a lab that draws nothing.
std::optional<LabDrawing> drawing_of(int lab);

// ---- for the labs' own files ----

// |yours - reference| of each number; the first beyond its bound. `name(i)` says which number it is.
std::optional<WrongNumber> first_wrong(std::span<const double> yours,
                                       std::span<const double> reference,
                                       const std::function<double(std::size_t)>& bound,
                                       const std::string& unit,
                                       const std::function<std::string(std::size_t)>& name);

// Sixteen numbers of a matrix, row by row, all with one bound.
std::optional<WrongNumber> first_wrong_entry(std::span<const double> yours,
                                             std::span<const double> reference, double bound,
                                             const std::string& unit);

// The questions of a round are gathered while a run of the pipeline is watched; the next run has the answers of those before it.
// Runs of a scene are the same from one to the next.
void watch_run(const StandIn& run, Observer& observer);

// For StandIn::finish: a picture of depth has distances[i], in world units, at pixel pixels[i], row by row, and the pipeline's own
// elsewhere.
std::function<void(Framebuffer&)> show_distances(std::vector<std::size_t> pixels,
                                                 Numbers distances);

// Surfaces that are seen through, or left out by their alpha: an error, for labs whose functions know none.
Result<void> check_opaque(const Scene& scene, const std::string& lab);

// A float that the stages behind can carry: finite, at most `most` in size.
float carried(double value, float most = 1e30f);

}  // namespace glassbox::labs
