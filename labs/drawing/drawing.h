// A picture with a student's functions in it (glassbox lab render): which stages of the pipeline a
// lab's functions replace, with the reference's own way and the error bounds for each.
//
// A lab's part of this is two files in its folder:
//   stages.cpp    passes records to the student's functions (framework/stages.h); in its own
//                 process
//   drawing.cpp   asks the questions, puts the answers into the pipeline, and judges them:
//                 LabDrawing drawing_NN()
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

// The input of one call.
struct Question {
  Numbers numbers;
  std::uint32_t triangle = kNone;  // the triangle of the scene; kNone: no single triangle
};

// The first wrong number of an answer.
struct WrongNumber {
  std::string element;  // "vertex 2, w"
  double yours = 0, reference = 0;
  double bound = 0;         // of |yours - reference|, in `unit`
  std::string unit;         // "clip units", "px"; empty: a count
  std::string explanation;  // where the numbers do not explain it: "missing"
};

// A stage of the picture that the student's functions replace.
struct DrawnStage {
  std::string name;  // its name in stages.cpp: "clip"
  // of the pipeline: one of "object", "world", "eye", "clip", "ndc", "screen", "coverage", "depth",
  // "shading"
  std::string stage;
  std::string functions;  // the functions of student.h: "outcode, trivial_verdict, clip_to_frustum"
  std::function<Numbers(RecordReader& in)> reference;
  // Returns nothing if the answer meets its contract. An answer may be of any length.
  std::function<std::optional<WrongNumber>(const Numbers& in, const Numbers& yours,
                                           const Numbers& reference)>
      judge;
};

// The source of the answers: the student's process, or the reference.
class AnswerSource {
public:
  virtual ~AnswerSource() = default;
  // Returns one answer for each question.
  virtual Result<std::vector<Numbers>> ask(const DrawnStage& stage,
                                           std::span<const Question> questions) = 0;
};

// ---- pictures ----

// The picture's input.
struct DrawingInput {
  const Scene& scene;
  const Camera& camera;
  View view;
  RenderSettings settings;
  Formulation formulation;  // how the view's matrices are to be computed
  StereoPair pair;          // for lab 9
};

// The scene as the answers make it: the data that the pipeline draws, and the observer of its
// stages.
struct PictureSetup {
  Scene scene;
  View view;
  RenderSettings settings;
  std::shared_ptr<Observer> stages;  // null: the pipeline's own stages
  // A change of the finished picture; empty: none.
  std::function<void(Framebuffer& picture)> finish;

  Rendering render() const;
};

struct LabDrawing {
  std::vector<DrawnStage> stages;  // in the order of the pipeline
  std::function<Result<PictureSetup>(const DrawingInput& input, AnswerSource& answer_source)> draw;
  std::string not_drawn;  // functions of student.h that are not used; empty: all are
  // Where the lab draws in another way than the pipeline does: the pipeline's picture, shown beside
  // both others. Null: the reference's picture is that of the pipeline.
  PictureSetup (*truth)(const DrawingInput& input) = nullptr;
};

// Returns nothing for a lab that has no drawing.
std::optional<LabDrawing> drawing_of(int lab);

// ---- for the labs' own files ----

// Compares |yours - reference| of each number with its bound and returns the first that exceeds it.
// `name(i)` is the name of number i.
std::optional<WrongNumber> first_wrong(std::span<const double> yours,
                                       std::span<const double> reference,
                                       const std::function<double(std::size_t)>& bound,
                                       const std::string& unit,
                                       const std::function<std::string(std::size_t)>& name);

// The same for sixteen numbers of a matrix, row by row, all with one bound.
std::optional<WrongNumber> first_wrong_entry(std::span<const double> yours,
                                             std::span<const double> reference, double bound,
                                             const std::string& unit);

// Watches a run of the pipeline and gathers the questions of a round; the next run gets the answers
// to the questions of the earlier runs. All runs of a scene are the same.
void observe_run(const PictureSetup& run, Observer& observer);

// For PictureSetup::finish: a picture of depth that has distances[i], in world units, at
// pixel pixels[i] (numbered row by row), and the pipeline's own distances elsewhere.
std::function<void(Framebuffer&)> show_distances(std::vector<std::size_t> pixels,
                                                 Numbers distances);

// Returns an error if a scene has transparent surfaces or ones cut out by their alpha, for labs
// whose functions do not handle them.
Result<void> check_opaque(const Scene& scene, const std::string& lab);

// The value as a float that the later stages can handle: finite, at most `most` in size.
float to_finite_float(double value, float most = 1e30f);

}  // namespace glassbox::labs
