// Sends batches of records to the student's process and reads its answers.
#include <sys/mman.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

#include <fmt/format.h>

#include "cli/process/wait_for_process.h"
#include "labs/drawing/stage_program.h"

namespace glassbox::labs {

namespace {

// How many numbers of questions one process gets (unless one question has more). They take 32 MiB,
// so that questions and answers fit into the memory of the process.
constexpr std::size_t kBatch = std::size_t(4) << 20;

}  // namespace

// A batch of questions as a file in memory, in the form that stages_main.cpp reads.
class BatchFile {
public:
  explicit BatchFile(std::span<const Question> batch) {
    std::size_t numbers = 2;
    for (const Question& question : batch) numbers += 1 + question.numbers.size();
    bytes_ = numbers * sizeof(double);
    const int file = ::memfd_create("records", MFD_CLOEXEC);
    if (file < 0) return;
    file_.set(file);
    if (::ftruncate(file_.get(), off_t(bytes_)) != 0) return;
    void* const at = ::mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED, file_.get(), 0);
    if (at == MAP_FAILED) return;
    at_ = static_cast<double*>(at);
    double* to = at_;
    *to++ = 0;
    *to++ = double(batch.size());
    for (const Question& question : batch) {
      *to++ = double(question.numbers.size());
      to = std::copy(question.numbers.begin(), question.numbers.end(), to);
    }
  }
  ~BatchFile() {
    if (at_ != nullptr) ::munmap(at_, bytes_);
  }
  BatchFile(const BatchFile&) = delete;
  BatchFile& operator=(const BatchFile&) = delete;

  bool valid() const { return at_ != nullptr; }
  int descriptor() const { return file_.get(); }
  // How many records (at most `most`) the process has begun, by its own report.
  std::size_t begun(std::size_t most) const {
    const double reported = *at_;
    return reported >= 0 && reported <= double(most) ? std::size_t(reported) : 0;
  }

private:
  Descriptor file_;
  std::size_t bytes_ = 0;
  double* at_ = nullptr;
};

namespace {

// Returns nothing if the bytes are not answers to `count` questions.
std::optional<std::vector<Numbers>> answers_of(const std::string& bytes, std::size_t count) {
  std::vector<Numbers> answers;
  answers.reserve(count);
  const std::size_t size = bytes.size() / sizeof(double);
  const auto read = [&](std::size_t i) {
    double number = 0;
    std::memcpy(&number, bytes.data() + i * sizeof(double), sizeof number);
    return number;
  };
  std::size_t at = 0;
  while (at < size) {
    const double length = read(at++);
    if (!(length >= 0 && length <= double(size - at)) || length != std::floor(length))
      return std::nullopt;
    Numbers& answer = answers.emplace_back(std::size_t(length));
    std::memcpy(answer.data(), bytes.data() + at * sizeof(double), answer.size() * sizeof(double));
    at += answer.size();
  }
  if (answers.size() != count) return std::nullopt;
  return answers;
}

}  // namespace

StudentAnswers::StudentAnswers(const grading::Sandbox& sandbox, std::filesystem::path program,
                               double seconds)
    : sandbox_(sandbox), program_(std::move(program)) {
  limits_.seconds = seconds;
  // The largest answer has 640 MiB: a triangle that covers all of a picture of 4096 x 4096 pixels.
  // It is in a vector that doubles its capacity when it grows.
  limits_.memory_bytes = 2048 * grading::kMiB;
  limits_.output_bytes = 1024 * grading::kMiB;
}

Result<std::vector<Numbers>> StudentAnswers::ask(const DrawnStage& stage,
                                                 std::span<const Question> questions) {
  std::vector<Numbers> answers;
  answers.reserve(questions.size());
  for (std::size_t from = 0; from < questions.size();) {
    std::size_t to = from, numbers = 0;
    while (to < questions.size() &&
           (to == from || numbers + questions[to].numbers.size() <= kBatch))
      numbers += questions[to++].numbers.size();
    auto some = ask_batch(stage, 0, questions.subspan(from, to - from));
    if (!some) return some;
    std::move(some->begin(), some->end(), std::back_inserter(answers));
    from = to;
  }
  return answers;
}

Result<Numbers> StudentAnswers::time(const DrawnStage& stage, const Question& question,
                                     int rounds) {
  auto times = ask_batch(stage, rounds, {&question, 1});
  if (!times) return tl::unexpected(times.error());
  if (times->front().size() == 2 * std::size_t(rounds)) return std::move(times->front());
  failure_ = stage.functions + ": something other than a time was written among the times";
  return fail("student.cpp", *failure_, "");
}

// Runs one process. After many runs in a row, the kernel may not have removed the namespaces of
// earlier processes yet, and they count towards the limit on the user's processes, so that
// bubblewrap fails. If no record was begun, the run is tried again.
RunOutcome StudentAnswers::run(const DrawnStage& stage, int rounds, const BatchFile& file) {
  std::vector<std::string> words{"--stage", stage.name};
  if (rounds > 0) words.insert(words.end(), {"--rounds", std::to_string(rounds)});
  constexpr int kTries = 40;
  for (int tried = 1;; ++tried) {
    RunOutcome outcome = sandbox_.run(program_, words, limits_, file.descriptor());
    const bool not_begun = outcome.ending == RunOutcome::Ending::kExit && outcome.code == 1 &&
                           file.begun(1) == 0 && outcome.printed.starts_with("bwrap:");
    if (!not_begun || tried == kTries) return outcome;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
}

Result<std::vector<Numbers>> StudentAnswers::ask_batch(const DrawnStage& stage, int rounds,
                                                       std::span<const Question> batch) {
  const BatchFile file(batch);
  if (!file.valid())
    return fail("the questions to student.cpp", "there is not enough memory for them",
                "draw a smaller picture");
  const RunOutcome outcome = run(stage, rounds, file);
  seconds_ += outcome.seconds;
  constexpr std::size_t kPrintedBytes = 4096;
  if (printed_.size() < kPrintedBytes)
    printed_ += outcome.printed.substr(0, kPrintedBytes - printed_.size());
  const bool well = outcome.ending == RunOutcome::Ending::kExit && outcome.code == 0;
  if (well) {
    if (auto answers = answers_of(outcome.answers, batch.size())) return std::move(*answers);
  }
  constexpr int kThrew = 3;  // the exit code in stages_main.cpp
  const bool threw = outcome.ending == RunOutcome::Ending::kExit && outcome.code == kThrew;
  const std::string how =
      threw  ? outcome.printed.substr(0, outcome.printed.find('\n'))
      : well ? "the program that runs your functions wrote something other than an answer"
             : ending_text(outcome, {limits_.seconds, limits_.output_bytes, 0});
  std::string text = fmt::format("{}: {}", stage.functions, how);
  const std::size_t begun = file.begun(batch.size());
  if (begun == 0 && !outcome.printed.empty()) text += ": " + outcome.printed.substr(0, 500);
  if (begun > 0) {
    const Question& question = batch[begun - 1];
    if (question.triangle != kNone) text += fmt::format(", at triangle {}", question.triangle);
    text += "\n  its input: " + stage.restate(question.numbers);
  }
  failure_ = text;
  return fail("student.cpp", text, "");
}

}  // namespace glassbox::labs
