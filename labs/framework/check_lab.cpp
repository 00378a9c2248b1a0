#include "labs/framework/check_lab.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace glassbox::labs {

namespace {

// Calls work(0) to work(count - 1), some at a time.
void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  const std::size_t hands = std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1,
                                                    std::max<std::size_t>(count, 1));
  std::vector<std::jthread> threads;
  for (std::size_t i = 1; i < hands; ++i) threads.emplace_back(take);
  take();
}

}  // namespace

Result<LabResult> check_lab(const Lab& lab, const Sources& sources, const BuildRequest& request,
                            const CheckOptions& options, Runner& runner) {
  BuildRequest build = request;
  build.with_hidden = options.with_hidden;
  const auto built = build_runner(sources, build);
  if (!built) return tl::unexpected(built.error());
  std::vector<std::vector<Case>> cases(lab.checks.size());
  std::vector<std::size_t> counts(lab.checks.size());
  std::vector<CheckResult> results(lab.checks.size());
  in_parallel(lab.checks.size(), [&](std::size_t i) {
    cases[i] = lab.checks[i].cases();
    counts[i] = cases[i].size();
  });
  in_parallel(lab.checks.size(), [&](std::size_t i) {
    const Check& check = lab.checks[i];
    if (check.hidden && !options.with_hidden) return;
    const double points = points_of_case(lab, counts, check.task);
    if (!built->built) {
      results[i] = not_built_check(check, counts[i], points);
      return;
    }
    const CheckAnswers answers =
        run_check(runner, built->program, check.name, counts[i], options.limits);
    results[i] = judge_check(check, cases[i], answers, points);
  });
  std::erase_if(results, [](const CheckResult& each) { return each.name.empty(); });
  LabResult result = sum_up(lab, std::move(results));
  if (!built->built) {
    result.not_built = built->messages.empty() ? "the compiler failed" : built->messages;
  } else if (!built->messages.empty()) {
    result.warnings.push_back(built->messages);
  }
  return result;
}

}  // namespace glassbox::labs
