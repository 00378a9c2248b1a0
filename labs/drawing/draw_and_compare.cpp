#include "labs/drawing/draw_and_compare.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <string_view>

namespace glassbox::labs {

namespace {

// The position of a stage in the pipeline.
std::size_t rank_of(const std::string& stage) {
  static constexpr std::array<std::string_view, 10> kOrder{
      "object", "world",    "eye",   "clip",    "ndc",
      "screen", "coverage", "depth", "shading", "anaglyph"};
  return std::size_t(std::find(kOrder.begin(), kOrder.end(), stage) - kOrder.begin());
}

std::vector<Numbers> answers_of(const DrawnStage& stage, std::span<const Question> questions) {
  std::vector<Numbers> answers;
  answers.reserve(questions.size());
  for (const Question& question : questions) {
    RecordReader in(question.numbers.data(), question.numbers.size());
    answers.push_back(stage.reference(in));
  }
  return answers;
}

class ReferenceAnswers : public AnswerSource {
public:
  Result<std::vector<Numbers>> ask(const DrawnStage& stage,
                                   std::span<const Question> questions) override {
    return answers_of(stage, questions);
  }
};

// Passes on the student's answers, and compares each with the reference's answer to the same
// question.
class JudgedAnswers : public AnswerSource {
public:
  JudgedAnswers(AnswerSource& student, const LabDrawing& lab, DrawingResult& result)
      : student_(student), result_(result) {
    for (const DrawnStage& stage : lab.stages)
      result_.stages.push_back({stage.name, stage.stage, stage.functions, 0, 0});
    std::stable_sort(result_.stages.begin(), result_.stages.end(),
                     [](const JudgedStage& a, const JudgedStage& b) {
                       return rank_of(a.stage) < rank_of(b.stage);
                     });
  }

  Result<std::vector<Numbers>> ask(const DrawnStage& stage,
                                   std::span<const Question> questions) override {
    auto yours = student_.ask(stage, questions);
    if (!yours) return yours;
    const auto judged =
        std::find_if(result_.stages.begin(), result_.stages.end(),
                     [&](const JudgedStage& each) { return each.name == stage.name; });
    for (std::size_t i = 0; i < questions.size(); ++i) {
      const Numbers& in = questions[i].numbers;
      RecordReader reader(in.data(), in.size());
      const Numbers reference = stage.reference(reader);
      auto wrong = stage.judge(in, (*yours)[i], reference);
      ++judged->records;
      keep(std::size_t(judged - result_.stages.begin()), judged->records - 1, questions[i],
           (*yours)[i], reference, wrong);
      if (!wrong || ++judged->wrong > kMaxWrong) continue;
      result_.wrong.push_back({std::size_t(judged - result_.stages.begin()),
                               std::size_t(judged->records - 1), questions[i].triangle,
                               std::move(*wrong), stage.restate(in)});
    }
    return yours;
  }

private:
  void keep(std::size_t stage, std::size_t record, const Question& question, const Numbers& yours,
            const Numbers& reference, const std::optional<WrongNumber>& wrong) {
    static constexpr std::size_t kShown = 48;
    const auto first = [](const Numbers& all) {
      return Numbers(all.begin(), all.begin() + std::ptrdiff_t(std::min(all.size(), kShown)));
    };
    const bool room = wrong ? ++wrong_kept_ <= kMaxWrong : numbers_kept_ < kKeptNumbers;
    if (!room) return;
    result_.kept.push_back(
        {stage, record, question.triangle, first(yours), first(reference), wrong});
    if (!wrong) numbers_kept_ += result_.kept.back().yours.size();
  }

  AnswerSource& student_;
  DrawingResult& result_;
  std::size_t numbers_kept_ = 0, wrong_kept_ = 0;
};

std::optional<std::uint32_t> triangle_of(const Framebuffer& buffers, std::size_t pixel) {
  const std::uint32_t id = buffers.id.pixels[pixel];
  return id == 0 ? std::nullopt : std::optional(id - 1);
}

void compare_pictures(const Framebuffer& yours, const Framebuffer& reference,
                      DrawingResult& result) {
  const auto &a = yours.color.pixels, &b = reference.color.pixels;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] == b[i]) continue;
    if (++result.differing_pixels > 1) continue;
    const auto width = std::size_t(yours.color.width);
    result.first_pixel = WrongPixel{int(i % width),        int(i / width),           a[i], b[i],
                                    triangle_of(yours, i), triangle_of(reference, i)};
  }
}

// The index of the first wrong record. If a pixel is given, only records of the triangles that are
// visible there are considered, and records without a single triangle.
std::optional<std::size_t> first_of(const std::vector<WrongRecord>& wrong,
                                    const WrongPixel* pixel) {
  const auto concerns = [&](const WrongRecord& record) {
    return pixel == nullptr || record.triangle == kNone ||
           pixel->your_triangle == record.triangle || pixel->reference_triangle == record.triangle;
  };
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    if (concerns(wrong[i])) return i;
  }
  return std::nullopt;
}

Framebuffer with_ids(const PictureSetup& run) {
  PictureSetup numbered = run;
  numbered.settings.want_id = true;
  return numbered.render().buffers;
}

}  // namespace

Result<ComparedPictures> draw_and_compare(const LabDrawing& lab, const DrawingInput& input,
                                          AnswerSource& student) {
  ComparedPictures both;
  JudgedAnswers judged(student, lab, both.result);
  auto yours = lab.draw(input, judged);
  if (!yours) return tl::unexpected(yours.error());
  ReferenceAnswers answers;
  auto reference = lab.draw(input, answers);
  if (!reference) return tl::unexpected(reference.error());
  both.yours = std::move(*yours);
  both.reference = std::move(*reference);

  DrawingResult& result = both.result;
  std::stable_sort(result.wrong.begin(), result.wrong.end(),
                   [](const WrongRecord& a, const WrongRecord& b) { return a.stage < b.stage; });
  Framebuffer your_buffers = with_ids(both.yours), reference_buffers = with_ids(both.reference);
  compare_pictures(your_buffers, reference_buffers, result);
  result.first_record = first_of(result.wrong, nullptr);
  if (result.first_pixel) result.record_of_pixel = first_of(result.wrong, &*result.first_pixel);
  result.yours = std::move(your_buffers.color);
  result.reference = std::move(reference_buffers.color);
  if (lab.truth != nullptr) result.truth = lab.truth(input).render().buffers.color;
  return both;
}

}  // namespace glassbox::labs
