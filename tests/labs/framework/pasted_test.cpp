// Nothing that students get solves a task: each function of student.h is replaced by a call of each
// function that is defined in their headers, with the arguments in every order, with fewer of them,
// or with their members, and must not get all points of its task.
#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "labs/framework/run_in_parallel.h"
#include "tests/labs/framework/bench.h"
#include "tests/labs/framework/plant_faults.h"
#include "tests/support/daily_share.h"

using namespace glassbox;
using namespace glassbox::labs;

namespace {

// The environment variable that has the function's name and the number of the call to paste into
// it; instead of a number, "list" prints all calls and ends the program.
constexpr const char* kPasted = "GLASSBOX_PASTED";
constexpr const char* kCall = "call: ";
constexpr const char* kEnd = "all calls";

// What the pasted calls need. A call is offered if it compiles and its result, converted or one of
// its members, is of the type that the task's function returns.
constexpr const char* kPasting = R"code(
#include <sys/resource.h>
#include <unistd.h>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

namespace pasting {

template <class S>
  requires requires(S& s) { s.x; s.y; s.z; s.w; }
auto members(S& s) { return std::tie(s.x, s.y, s.z, s.w); }
template <class S>
  requires(requires(S& s) { s.x; s.y; s.z; } && !requires(S& s) { s.w; })
auto members(S& s) { return std::tie(s.x, s.y, s.z); }
template <class T, std::size_t kSize>
  requires(kSize < 9)
auto members(std::array<T, kSize>& a) { return std::apply([](auto&... x) { return std::tie(x...); }, a); }
template <class T, std::size_t kSize>
  requires(kSize < 9)
auto members(const std::array<T, kSize>& a) { return std::apply([](auto&... x) { return std::tie(x...); }, a); }
// MEMBERS
template <class S>
auto parts(S& s) {
  if constexpr (requires { members(s); }) return members(s);
  else return std::tie(s);
}

template <class R>
struct Trial {
  std::string wanted = std::getenv("GLASSBOX_PASTED");
  bool lists = wanted.ends_with(" list");
  int number = lists ? -1 : std::atoi(wanted.c_str() + wanted.find(' ')), offered = 0;
  std::optional<std::conditional_t<std::is_void_v<R>, char, R>> answer;
  std::function<R()> right;  // the solution

  bool takes(const char* name, const char* how, const char* arguments, const char* result) {
    if (lists) std::printf("call: %s(%s%s)%s\n", name, how, arguments, result);
    return offered++ == number;
  }
  R finish() {
    if (lists) {
      std::printf("all calls\n");
      std::fflush(stdout);
      _exit(0);
    }
    if (!answer) std::abort();
    if constexpr (!std::is_void_v<R>) return std::move(*answer);
  }
};

inline bool is_on(const char* name) {
  static const std::string wanted = [] {
    const char* set = std::getenv("GLASSBOX_PASTED");
    if (set == nullptr) return std::string();
    const rlimit seconds{5, 5}, memory{2'000'000'000, 2'000'000'000}, none{0, 0};
    setrlimit(RLIMIT_CPU, &seconds);
    setrlimit(RLIMIT_AS, &memory);
    setrlimit(RLIMIT_CORE, &none);
    return std::string(set);
  }();
  return wanted.starts_with(name) && wanted[std::string(name).size()] == ' ';
}

// Offers the result as a member of the right answer. Functions of the library's own headers, such
// as one that returns its argument, are left out.
template <class R, class Call>
void offer_as_member(Trial<R>& trial, const char* name, const char* how, const char* arguments,
                     Call call) {
  using S = std::remove_cvref_t<decltype(call())>;
  using Parts = decltype(members(std::declval<R&>()));
  const auto one = [&]<std::size_t i>(std::integral_constant<std::size_t, i>) {
    using Part = std::remove_cvref_t<std::tuple_element_t<i, Parts>>;
    if constexpr (std::is_same_v<S, Part>) {
      if (trial.takes(name, how, arguments, " as a member")) {
        trial.answer = trial.right();
        std::get<i>(members(*trial.answer)) = call();
      }
    }
  };
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (one(std::integral_constant<std::size_t, k>()), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<Parts>>());
}

template <class R, class Call>
void offer(Trial<R>& trial, const char* name, const char* how, const char* arguments, Call call) {
  using S = std::remove_cvref_t<decltype(call())>;
  if constexpr (std::is_void_v<R>) {
    if (trial.takes(name, how, arguments, "")) call(), trial.answer = 0;
  } else if constexpr (!std::is_void_v<S>) {
    if constexpr (std::is_convertible_v<S, R>) {
      if (trial.takes(name, how, arguments, "")) trial.answer.emplace(call());
    } else if constexpr (std::is_enum_v<R> && std::is_integral_v<S>) {
      if (trial.takes(name, how, arguments, " as an enumerator")) trial.answer = R(call());
    } else if constexpr (requires(S s) { R{s}; }) {
      if (trial.takes(name, how, arguments, " in braces")) trial.answer.emplace(R{call()});
    }
    if constexpr (requires(R & r) { members(r); }) {
      if (name[0] == 'l') offer_as_member(trial, name, how, arguments, call);
    }
    if constexpr (requires(S s) { s.front(); }) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(std::declval<S>().front())>, R>) {
        if (trial.takes(name, how, arguments, ".front()")) trial.answer.emplace(call().front());
}
}
if constexpr (requires(S & s) { members(s); }) {
  using Parts = decltype(members(std::declval<S&>()));
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    const auto one = [&]<std::size_t i>(std::integral_constant<std::size_t, i>) {
      if constexpr (std::is_same_v<std::remove_cvref_t<std::tuple_element_t<i, Parts>>, R>) {
        if (trial.takes(name, how, arguments, "'s member")) {
          S s = call();
          trial.answer.emplace(std::get<i>(members(s)));
        }
      }
    };
    (one(std::integral_constant<std::size_t, k>()), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<Parts>>());
}
}
}

using glassbox::labs::Choices;

#define VISIBLE(id, name, fewest, most)                                                \
  struct id {                                                            \
    static constexpr const char* text = #name;                           \
    static constexpr bool takes(std::size_t count) {                     \
      return fewest <= count && count <= most;                           \
    }                                                                    \
    template <class... A>                                                \
    static auto plain(A&... a) -> decltype(name(a...)) {                 \
      return name(a...);                                                 \
    }                                                                    \
    template <class... A>                                                \
    static auto braced(A&... a) -> decltype(name({a...})) {              \
      return name({a...});                                               \
    }                                                                    \
    template <class... A>                                                \
    static auto named(A&... a) -> decltype(name({"", a...})) {           \
      return name({"", a...});                                           \
    }                                                                    \
    template <class... A>                                                \
    static auto chosen(Choices& c, A&... a) -> decltype(name(c, a...)) { \
      return name(c, a...);                                              \
    }                                                                    \
  };

template <class V, class R, class... A>
void offer_one(Trial<R>& trial, const char* arguments, A&... a) {
  if constexpr (V::takes(sizeof...(a))) {
    if constexpr (requires { V::plain(a...); })
      offer(trial, V::text, "", arguments, [&] { return V::plain(a...); });
  }
  if constexpr (V::takes(1)) {
    if constexpr (requires { V::braced(a...); } && !requires { V::plain(a...); })
      offer(trial, V::text, "in braces: ", arguments, [&] { return V::braced(a...); });
    if constexpr (requires { V::named(a...); })
      offer(trial, V::text, "in braces after \"\": ", arguments, [&] { return V::named(a...); });
  }
  if constexpr (V::takes(1 + sizeof...(a))) {
    Choices simplest(std::vector<std::uint64_t>{});
    if constexpr (requires { V::chosen(simplest, a...); })
      offer(trial, V::text, "after choices: ", arguments,
            [&] { return V::chosen(simplest, a...); });
  }
}

// VISIBLE
template <class R, class... A>
void offer_each(Trial<R>& trial, const char* arguments, A&... a) {
  // OFFERS
}

// Offers calls with some of the members one after the other.
template <class R, class Tuple>
void offer_members(Trial<R>& trial, Tuple all) {
  constexpr std::size_t count = std::tuple_size_v<Tuple>;
  if constexpr (count <= 9) {
    const auto range = [&]<std::size_t first, std::size_t... k>(
        std::integral_constant<std::size_t, first>, std::index_sequence<k...>) {
      offer_each(trial, "members", std::get<first + k>(all)...);
    };
    const auto from = [&]<std::size_t first, std::size_t... length>(
        std::integral_constant<std::size_t, first> start, std::index_sequence<length...>) {
      (range(start, std::make_index_sequence<length + 1>()), ...);
    };
    [&]<std::size_t... first>(std::index_sequence<first...>) {
      (from(std::integral_constant<std::size_t, first>(),
            std::make_index_sequence<count - first>()),
       ...);
    }
    (std::make_index_sequence<count>());
  } else {
    std::apply([&](auto&... a) { offer_each(trial, "members", a...); }, all);
  }
}

}  // namespace pasting
)code";

std::string filled_in(std::string text, const std::string& what, const std::string& by) {
  INFO("looking for: " << what);
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

// What students get, as a text without includes of its own, and what it defines.
struct HandedOut {
  std::string text;
  // "glassbox::dot", "lab_05::handed_out::prism", with the fewest and the most arguments
  std::map<std::string, std::pair<int, int>> functions;
  std::set<std::string> left_out;  // those that seem to compile with any arguments
  std::string members;  // functions members(S&), one for each struct S, which return a tuple
};

// The members of a struct, by its code between the braces: "s.x, s.y". They are indented by two
// columns, and each declaration ends with a semicolon.
std::string members_of_struct(const std::string& body) {
  static const std::regex declared(
      R"(\n  (?! |using|enum|friend|static|template)([^;(){}]|\{[^;()]*\})*;)");
  static const std::regex name(R"((\w+)\s*(?:\[[^\]]*\])*\s*(?:=[^,;]*)?[,;])");
  std::string list;
  for (std::sregex_iterator at(body.begin(), body.end(), declared), end; at != end; ++at) {
    // Commas between <> or braces separate no members.
    std::string flat;
    int depth = 0;
    for (const char c : at->str()) {
      if (c == '<' || c == '{') ++depth;
      if (depth == 0) flat += c;
      if (c == '>' || c == '}') --depth;
    }
    for (std::sregex_iterator one(flat.begin(), flat.end(), name); one != end; ++one)
      list += (list.empty() ? "s." : ", s.") + (*one)[1].str();
  }
  return list;
}

// Whether a parameter's type is a template's, so that a call with any type seems to compile until
// the body is compiled.
bool takes_any_type(const std::string& templated, const std::string& parameters) {
  static const std::regex type("class (\\w+)");
  for (std::sregex_iterator at(templated.begin(), templated.end(), type), end; at != end; ++at) {
    const std::string name = (*at)[1];
    const std::regex alone("(^|, *)(const )?" + name + "\\b"), within("<[^()]*\\b" + name + "\\b");
    if (std::regex_search(parameters, alone) && !std::regex_search(parameters, within)) return true;
  }
  return false;
}

// The fewest and the most arguments that a list of parameters takes.
std::pair<int, int> argument_counts(const std::string& parameters) {
  int all = parameters.find_first_not_of(" \n") == std::string::npos ? 0 : 1, defaults = 0;
  int depth = 0;
  for (const char c : parameters) {
    if (c == '<' || c == '(') ++depth;
    if (c == '>' || c == ')') --depth;
    if (c == ',' && depth == 0) ++all;
    if (c == '=' && depth == 0) ++defaults;
  }
  return {all - defaults, all};
}

// Finds what a header defines in the first column, but no functions for arguments of any type.
void add_definitions(HandedOut& all, const std::string& header, const std::string& space) {
  const std::string bare = std::regex_replace("\n" + header, std::regex("//[^\n]*"), "");
  const std::string code = std::regex_replace(bare, std::regex(R"(= \{\})"), "= 0");
  static const std::regex function(
      R"(\n(template <[^\n]*>\n(?:  requires[^\n]*\n)?)?)"
      R"((?!namespace|struct|class|using|enum|return|template)[A-Za-z][\w:<>, ]*[ >&*](\w+)\(([^;{}]*)\)[^;{}()]*\{)");
  for (std::sregex_iterator at(code.begin(), code.end(), function), end; at != end; ++at) {
    const std::string name = space + "::" + (*at)[2].str();
    if (takes_any_type((*at)[1], (*at)[3])) all.left_out.insert(name);
    const auto [fewest, most] = argument_counts((*at)[3]);
    const auto& known = all.functions.try_emplace(name, fewest, most).first;
    known->second = {std::min(known->second.first, fewest), std::max(known->second.second, most)};
  }
  static const std::regex record(R"(([^\n]*)\nstruct (\w+) \{\n)");
  for (std::sregex_iterator at(code.begin(), code.end(), record), end; at != end; ++at) {
    if ((*at)[1].str().starts_with("template")) continue;
    const std::size_t first = std::size_t(at->position() + at->length()) - 1;
    const std::string list =
        members_of_struct(code.substr(first, code.find("\n};", first) - first));
    if (list.empty()) continue;
    for (const char* qualifier : {"", "const "})
      all.members += fmt::format("inline auto members({}{}::{}& s) {{ return std::tie({}); }}\n",
                                 qualifier, space, (*at)[2].str(), list);
  }
}

// Puts the headers of the lab's folder together: those that a student's file includes stay outside,
// and everything else has a namespace of its own in the lab's, so that it is not mistaken for what
// the runner is compiled with.
class Collector {
public:
  Collector(const Sources& sources, const Lab& lab) : lab_(fmt::format("lab_{:02}", lab.number)) {
    const auto files = support_files(sources, lab.folder, false);
    REQUIRE(files);
    std::vector<SourceFile> own;
    for (const SourceFile& each : *files) {
      texts_[each.path] = each.text;
      if (each.path == "student.h") own.push_back(each);
    }
    const auto of_all = library_headers(sources, *files), of_own = library_headers(sources, own);
    REQUIRE(of_all);
    REQUIRE(of_own);
    for (const SourceFile& each : *of_all) texts_[each.path] = each.text;
    for (const SourceFile& each : *of_own) {
      add_definitions(all_, each.text, "glassbox");
      done_.insert(each.path);
    }
    add_definitions(all_, texts_.at("student.h"), lab_);
    done_.insert("student.h");
    take("labs/framework/runner.h");
    take("cases.h");
    if (texts_.count("generators.h") == 1) take("generators.h");
  }
  const HandedOut& all() const { return all_; }

private:
  void take(const std::string& path) {
    if (!done_.insert(path).second) return;
    std::istringstream lines(texts_.at(path));
    std::string kept;
    static const std::regex include(R"re(#include ["<](.*)[">])re");
    for (std::string line; std::getline(lines, line);) {
      std::smatch found;
      if (line == "#pragma once") continue;
      if (std::regex_match(line, found, include) && texts_.count(found[1]) == 1) {
        take(found[1]);
      } else {
        kept += line + "\n";
      }
    }
    const bool of_library = path.starts_with("glassbox/");
    const bool of_framework = path.starts_with("labs/framework/");
    if (!of_library && !of_framework) {
      kept = filled_in(kept, "namespace " + lab_ + " {",
                       "namespace " + lab_ + " { namespace handed_out {");
      kept = filled_in(kept, "}  // namespace " + lab_, "}}");
    }
    add_definitions(all_, kept,
                    of_library     ? "glassbox"
                    : of_framework ? "glassbox::labs"
                                   : lab_ + "::handed_out");
    all_.text += kept;
  }

  std::string lab_;
  std::map<std::string, std::string> texts_;
  std::set<std::string> done_;
  HandedOut all_;
};

// "a, b" becomes {"a", "b"}.
std::vector<std::string> words_of(const std::string& list) {
  std::vector<std::string> words;
  static const std::regex word(R"(\w+)");
  for (std::sregex_iterator at(list.begin(), list.end(), word), end; at != end; ++at)
    words.push_back(at->str());
  return words;
}

// The lists of arguments to try: all of them in every order, and fewer of them in their order.
std::vector<std::vector<std::string>> argument_lists(std::vector<std::string> words) {
  std::vector<std::vector<std::string>> lists;
  const std::size_t count = words.size();
  for (std::size_t set = 0; set + 1 < std::size_t(1) << count; ++set) {
    lists.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
      if ((set >> i & 1) == 1) lists.back().push_back(words[i]);
    }
  }
  // More than 24 orders would take too long.
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  do {
    lists.emplace_back();
    for (const std::size_t i : order) lists.back().push_back(words[i]);
  } while (count <= 4 && std::next_permutation(order.begin(), order.end()));
  return lists;
}

// The code that a task's function begins with.
std::string pasted_into(const Function& function) {
  const std::vector<std::string> words = words_of(function.arguments);
  std::string text = fmt::format(
      "  if (pasting::is_on(\"{0}\")) {{\n    pasting::Trial<decltype({0}({1}))> trial;\n"
      "    trial.right = [&] {{ return chosen().{0}({1}); }};\n",
      function.name, function.arguments);
  for (const std::vector<std::string>& list : argument_lists(words)) {
    const std::string arguments = fmt::format("{}", fmt::join(list, ", "));
    text += fmt::format("    pasting::offer_each(trial, \"{}\"{}{});\n", arguments,
                        list.empty() ? "" : ", ", arguments);
  }
  std::string tuples;
  for (const std::string& word : words)
    tuples += (tuples.empty() ? "pasting::parts(" : "), pasting::parts(") + word;
  text += fmt::format(
      "    using Tied = decltype(std::tie({0}));\n"
      "    const auto parts = std::tuple_cat({1}));\n"
      "    if constexpr (!std::is_same_v<std::remove_const_t<decltype(parts)>, Tied>)\n"
      "      pasting::offer_members(trial, parts);\n    return trial.finish();\n  }}\n",
      function.arguments, tuples);
  return text;
}

// Returns a student.cpp: the solution, each function of which begins with the pasted calls.
std::string solution_with_calls(const std::string& header, const std::string& solution,
                                const HandedOut& handed_out) {
  std::string visible, offers;
  int number = 0;
  for (const auto& [name, counts] : handed_out.functions) {
    if (handed_out.left_out.count(name) == 1) continue;
    visible +=
        fmt::format("VISIBLE(V{}, {}, {}, {})\n", ++number, name, counts.first, counts.second);
    offers += fmt::format("  offer_one<V{}>(trial, arguments, a...);\n", number);
  }
  std::string before = filled_in(kPasting, "// MEMBERS", handed_out.members);
  before = filled_in(filled_in(before, "// VISIBLE", visible), "// OFFERS", offers);
  std::string text = solution_with_all_faults(header, solution, {});
  for (const Function& each : functions_of(header)) {
    const std::string call = fmt::format("  return chosen().{}({});", each.name, each.arguments);
    text = filled_in(text, call, pasted_into(each) + call);
  }
  return filled_in(text, "\nnamespace lab_", "\n" + handed_out.text + before + "\nnamespace lab_");
}

// Runs a program with one pasted call. It is not run again after a crash or when it is out of time.
class PastedRunner : public Runner {
public:
  PastedRunner(std::string function, const std::string& call)
      : chosen_(fmt::format("{}={} {}", kPasted, function, call)) {}
  RunOutcome run(const RunRequest& request) override {
    if (has_failed_) return {};
    RunRequest asked = request;
    asked.program = "/usr/bin/env";
    asked.arguments = {chosen_, request.program.string()};
    asked.arguments.insert(asked.arguments.end(), request.arguments.begin(),
                           request.arguments.end());
    RunOutcome outcome = LocalRunner().run(asked);
    has_failed_ = outcome.ending != RunOutcome::Ending::kExit;
    return outcome;
  }

private:
  std::string chosen_;
  bool has_failed_ = false;
};

RunLimits long_limits() {
  RunLimits limits;
  limits.seconds = 120;  // of a busy machine; a program stops after 5 seconds of the processor's
  limits.printed_bytes = std::size_t(1) << 22;
  return limits;
}

// The calls that compile in place of a function, and the task whose checks ask for it.
struct Calls {
  std::string task;
  std::vector<std::string> names;
};

Calls calls_of(const Lab& lab, const BenchProgram& program, const std::string& function) {
  Calls calls;
  for (const Check& check : lab.checks) {
    PastedRunner runner(function, "list");
    const auto answers = run_check(runner, program.path, check.name, 1, long_limits(), 1);
    std::istringstream lines(answers.printed);
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with(kCall)) calls.names.push_back(line.substr(std::string(kCall).size()));
    }
    if (answers.printed.find(kEnd) == std::string::npos) continue;
    calls.task = check.task;
    break;
  }
  return calls;
}

class CasesOfLab {
public:
  explicit CasesOfLab(const Lab& lab) : lab_(lab), cases_(lab.checks.size()) {}
  const std::vector<Case>& of(std::size_t check) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!cases_[check]) cases_[check] = lab_.checks[check].cases();
    return *cases_[check];
  }

private:
  const Lab& lab_;
  std::mutex mutex_;
  std::vector<std::optional<std::vector<Case>>> cases_;
};

// Whether a call in place of a function gets all points of the task.
bool solves(const Lab& lab, CasesOfLab& cases, const BenchProgram& program, const std::string& task,
            const std::string& function, std::size_t number) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < lab.checks.size(); ++i) {
    if (lab.checks[i].task == task) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return lab.checks[a].generated < lab.checks[b].generated;
  });
  PastedRunner runner(function, std::to_string(number));
  return std::all_of(order.begin(), order.end(), [&](std::size_t i) {
    const std::vector<Case>& wanted = cases.of(i);
    const auto answers =
        run_check(runner, program.path, lab.checks[i].name, wanted.size(), long_limits());
    return judge_check(lab.checks[i], wanted, answers, 1).right == wanted.size();
  });
}

struct Tried {
  std::size_t calls = 0;
  std::vector<std::string> solved;  // "edge: lab_06::handed_out::area(a, b, p)"
};

// Tries all functions that the lab's headers, and `further` code in cases.h, define.
Tried try_all(const Lab& lab, const std::string& further = {}) {
  Bench& bench = Bench::for_lab(lab);
  const auto header = read_text_file(bench.sources().labs / lab.folder / "student.h");
  REQUIRE(header);
  HandedOut handed_out = Collector(bench.sources(), lab).all();
  const std::string space = fmt::format("lab_{:02}::handed_out", lab.number);
  handed_out.text += fmt::format("namespace {} {{{}}}\n", space, further);
  add_definitions(handed_out, further, space);
  const BenchProgram program =
      bench.program(solution_with_calls(*header, bench.solution(), handed_out));
  CasesOfLab cases(lab);
  Tried tried;
  std::mutex mutex;
  for (const Function& function : functions_of(*header)) {
    const Calls calls = calls_of(lab, program, function.name);
    INFO("lab " << lab.folder << ", " << function.name << ", task " << calls.task);
    CHECK_FALSE(calls.task.empty());
    if (std::getenv("VERBOSE") != nullptr)
      fmt::print("{} {} {} {}\n{}\n", lab.folder, calls.task, function.name, calls.names.size(),
                 fmt::join(calls.names, "\n"));
    tried.calls += calls.names.size();
    run_in_parallel(calls.names.size(), [&](std::size_t i) {
      if (!solves(lab, cases, program, calls.task, function.name, i)) return;
      const std::lock_guard<std::mutex> lock(mutex);
      tried.solved.push_back(function.name + ": " + calls.names[i]);
    });
  }
  return tried;
}

}  // namespace

// A program with all calls takes some 5 seconds to compile, so two of the labs are tried each
// day.
TEST_CASE("no function that students get solves a task if it is pasted in its place") {
  const char* only = std::getenv("LAB");
  const test::DailyShare share(7);
  const std::vector<Lab>& labs = all_labs();
  for (std::size_t i = 0; i < labs.size(); ++i) {
    if (only != nullptr ? std::to_string(labs[i].number) != only : !share.includes(i, labs.size()))
      continue;
    INFO("lab " << labs[i].folder << ", " << share.text());
    const Tried tried = try_all(labs[i]);
    CHECK(tried.solved == std::vector<std::string>());
    CHECK(tried.calls > 15);
  }
}

// Each of these functions solves a task of lab 11 in a way of its own.
TEST_CASE("a function that solves a task is found among those that students get") {
  const Lab& lab = all_labs().at(10);
  REQUIRE(lab.folder == "11-matching");
  const Tried tried = try_all(lab, R"(
inline int different(std::uint32_t b, std::uint32_t a) {
  int count = 0;
  for (std::uint32_t bits = a ^ b; bits != 0; bits &= bits - 1) ++count;
  return count;
}
struct Question {
  const char* what = "";
  double disparity = 0;
  Calibration by;
};
struct Reply {
  bool is_known = false;
  double number = 0;
};
inline Reply reply_to(const Question& q) {
  const double d = q.disparity + q.by.offset;
  return {true, d > 0 && d < kNone ? q.by.focal * q.by.baseline / d : kNone};
}
inline double with_choices(glassbox::labs::Choices&, double d, double f, double b, double offset) {
  return d + offset > 0 && d < kNone ? f * b / (d + offset) : kNone;
}
)");
  const std::vector<std::string> wanted{
      "hamming: lab_11::handed_out::different(a, b)",
      "hamming: lab_11::handed_out::different(b, a)",
      "depth: lab_11::handed_out::reply_to(in braces after \"\": disparity, calibration)'s member",
      "depth: lab_11::handed_out::with_choices(after choices: members)"};
  for (const std::string& each : wanted) {
    INFO(each);
    CHECK(std::count(tried.solved.begin(), tried.solved.end(), each) == 1);
  }
}
