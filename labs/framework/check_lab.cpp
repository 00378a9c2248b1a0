#include "labs/framework/check_lab.h"

#include "labs/framework/in_parallel.h"
#include "labs/framework/points.h"

namespace glassbox::labs {

Result<LabResult> check_lab(const Lab& whole, const Sources& sources, const BuildRequest& request,
                            const CheckOptions& options, Runner& runner) {
  BuildRequest build = request;
  build.with_hidden = options.with_hidden;
  const auto built = build_runner(sources, build);
  if (!built) return tl::unexpected(built.error());
  const auto shares = read_shares(whole, sources.folder_of(whole.folder) / "points.json");
  if (!shares) return tl::unexpected(shares.error());
  const Lab& lab = shares->lab;
  std::vector<std::vector<Case>> cases(lab.checks.size());
  std::vector<CheckResult> results(lab.checks.size());
  in_parallel(lab.checks.size(), [&](std::size_t i) { cases[i] = lab.checks[i].cases(); });
  in_parallel(lab.checks.size(), [&](std::size_t i) {
    const Check& check = lab.checks[i];
    if (check.hidden && !options.with_hidden) return;
    const double points = points_of_case(lab, check, cases[i].size());
    if (!built->built) {
      results[i] = not_built_check(check, cases[i].size(), points);
      return;
    }
    const CheckAnswers answers =
        run_check(runner, built->program, check.name, cases[i].size(), options.limits);
    results[i] = judge_check(check, cases[i], answers, points);
  });
  std::erase_if(results, [](const CheckResult& each) { return each.name.empty(); });
  LabResult result = sum_up(lab, std::move(results));
  result.warnings = shares->warnings;
  if (!built->built) {
    result.not_built = built->messages.empty() ? "the compiler failed" : built->messages;
  } else if (!built->messages.empty()) {
    result.warnings.push_back(built->messages);
  }
  return result;
}

}  // namespace glassbox::labs
