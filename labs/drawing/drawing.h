// A picture that is partly drawn by a student's functions (glassbox lab render): which stages of
// the pipeline a lab's functions replace, and for each stage the reference (the pipeline's own
// computation) and the bounds of the error.
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

#include "labs/drawing/input_words.h"
#include "labs/framework/stages.h"

#include <glassbox/base/error.h>
#include <glassbox/mesh/scene.h>
#include <glassbox/pipeline/formulation.h>
#include <glassbox/pipeline/stereo/stereo_pair.h>
#include <glassbox/pipeline/view.h>
#include <glassbox/render/staged/staged.h>

namespace glassbox::labs {

// ---- records ----

// The input of one call of a stage's functions.
struct Question {
  Numbers numbers;
  std::uint32_t triangle = kNone;  // the triangle it belongs to; kNone: no single one
};

// The first wrong number of an answer.
struct WrongNumber {
  std::string element;  // "vertex 2, w"
  double yours = 0, reference = 0;
  double bound = 0;         // of the allowed |yours - reference|, in `unit`
  std::string unit;         // "clip units", "px"; empty: a count
  std::string explanation;  // "missing", "too many" or another reason; may be empty
};

// A stage of the pipeline that the student's functions replace.
struct DrawnStage {
  std::string name;  // its name in stages.cpp: "clip"
  // the stage of the pipeline: one of "object", "world", "eye", "clip", "ndc", "screen",
  // "coverage", "depth", "shading"
  std::string stage;
  std::string functions;  // the functions of student.h: "outcode, trivial_verdict, clip_to_frustum"
  std::function<Numbers(RecordReader& in)> reference;
  // Returns nothing if the student's answer `yours`, which may have any length, is right.
  std::function<std::optional<WrongNumber>(const Numbers& in, const Numbers& yours,
                                           const Numbers& reference)>
      judge;
  // The input in words: input_words.h.
  std::function<std::string(const Numbers& in)> restate;
};

// What answers the questions: the student's process, or the reference.
class AnswerSource {
public:
  virtual ~AnswerSource() = default;
  // Returns one answer for each question.
  virtual Result<std::vector<Numbers>> ask(const DrawnStage& stage,
                                           std::span<const Question> questions) = 0;
};

// ---- pictures ----

// What a picture is drawn from.
struct DrawingInput {
  const Scene& scene;
  const Camera& camera;
  View view;
  RenderSettings settings;
  Formulation formulation;  // how the view's matrices are to be computed
  StereoPair pair;          // for lab 9
};

// A picture that is ready to be drawn: the scene, the view and the settings, and an observer that
// replaces stages of the pipeline by the answers.
struct PictureSetup {
  Scene scene;
  View view;
  RenderSettings settings;
  std::shared_ptr<Observer> stages;  // null: no stage is replaced
  // Changes the finished picture; empty: nothing is changed.
  std::function<void(Framebuffer& picture)> finish;

  Rendering render() const;
};

struct LabDrawing {
  std::vector<DrawnStage> stages;  // in the order of the pipeline
  std::function<Result<PictureSetup>(const DrawingInput& input, AnswerSource& answer_source)> draw;
  std::string not_drawn;  // functions of student.h that are not used; empty: all are
  // For a lab that does not draw as the pipeline does: prepares the pipeline's own picture, which
  // is shown beside the student's and the reference's. Null: the reference's picture is the
  // pipeline's.
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

// first_wrong() for the sixteen numbers of two matrices, row by row, with one bound for all.
std::optional<WrongNumber> first_wrong_entry(std::span<const double> yours,
                                             std::span<const double> reference, double bound,
                                             const std::string& unit);

// Draws a picture once so that the observer can gather the inputs of a stage. In the next run of
// the pipeline the observer uses the answers for these inputs. All runs of a scene are the same.
void observe_run(const PictureSetup& run, Observer& observer);

// For PictureSetup::finish: changes the picture into one of depth that has distances[i], in world
// units, at pixel pixels[i] (numbered row by row), and the pipeline's own distances elsewhere.
std::function<void(Framebuffer&)> show_distances(std::vector<std::size_t> pixels,
                                                 Numbers distances);

// Returns an error if a scene has transparent surfaces or ones cut out by their alpha, for labs
// whose functions do not handle them.
Result<void> check_opaque(const Scene& scene, const std::string& lab);

// The value as a float that the later stages can handle: finite, at most `most` in size.
float to_finite_float(double value, float most = 1e30f);

}  // namespace glassbox::labs
