// The program around a lab's functions: calls them with the cases of one check and writes the
// answers, one JSON object per line.
//
//   runner --list
//                    {"check": "name", "cases": 3} for each check
//   runner --check NAME [--from N] [--case N] [--out-fd N]
//                    {"case": 0, "fields": {"name": [1, "nan"]}} for each case, and
//                    {"case": 1, "threw": "what"} where the function threw
//   runner --check NAME [--case N] --inputs FIRST END
//   runner --check NAME --case N --choices '1 0 2;3'
//                    of a class of generated inputs (without --case, of each class) only these: by
//                    their numbers FIRST to END - 1, or made from the given choices
//
// The answers to the inputs of a class are in one line. A field then has the numbers of all
// answers, one after the other, each as 16 hexadecimal digits, and "sizes" says how many each
// answer has (batch.h).
//
// Every line is written before the next case starts, so that a crash does not lose the earlier
// answers. --case runs one case only, for a debugger. Uses only the standard library, because
// students wait for this file to compile.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>

#include "labs/framework/runner.h"
#include "labs/framework/varied_inputs.h"

namespace {

using glassbox::labs::Answer;
using glassbox::labs::Choices;
using glassbox::labs::RunnerCheck;
using glassbox::labs::RunnerInputs;

std::uint64_t the_seed = 0;

void append_string(std::string& line, const std::string& text) {
  line += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      line += '\\';
      line += c;
    } else if (byte < 0x20 || byte >= 0x7f) {  // as if it were Latin-1: any byte gives valid JSON
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\u%04x", byte);
      line += escaped;
    } else {
      line += c;
    }
  }
  line += '"';
}

void append_number(std::string& line, double value) {
  if (std::isnan(value)) {
    line += "\"nan\"";
  } else if (std::isinf(value)) {
    line += value > 0 ? "\"inf\"" : "\"-inf\"";
  } else {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", value);
    line += text;
  }
}

std::string fields_of(const Answer& answer) {
  std::string line = "\"fields\": {";
  bool first = true;
  for (const Answer::Field& field : answer.fields()) {
    if (!first) line += ", ";
    first = false;
    append_string(line, field.name);
    line += ": [";
    for (std::size_t i = 0; i < field.values.size(); ++i) {
      if (i > 0) line += ", ";
      append_number(line, field.values[i]);
    }
    line += ']';
  }
  return line + '}';
}

// The answers to many inputs: for each field all numbers, and how many of them each answer has.
class Batch {
public:
  void add(const Answer& answer) {
    for (const Answer::Field& field : answer.fields()) {
      Field& all = named(field.name);
      all.sizes.resize(inputs_, -1);  // the answers before have no such field
      all.sizes.push_back(double(field.values.size()));
      all.values.insert(all.values.end(), field.values.begin(), field.values.end());
    }
    ++inputs_;
  }
  std::string text() {
    std::string line = "\"fields\": {";
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      if (i > 0) line += ", ";
      append_string(line, fields_[i].name);
      line += ": \"";
      for (const double value : fields_[i].values) append_bits(line, value);
      line += '"';
    }
    line += "}, \"sizes\": {";
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      if (i > 0) line += ", ";
      append_string(line, fields_[i].name);
      line += ": [";
      fields_[i].sizes.resize(inputs_, -1);
      append_sizes(line, fields_[i].sizes);
      line += ']';
    }
    return line + '}';
  }

private:
  struct Field {
    std::string name;
    std::vector<double> values, sizes;
  };
  Field& named(const std::string& name) {
    for (Field& field : fields_) {
      if (field.name == name) return field;
    }
    fields_.push_back({name, {}, {}});
    return fields_.back();
  }
  static void append_bits(std::string& line, double value) {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    for (int shift = 60; shift >= 0; shift -= 4) line += "0123456789abcdef"[(bits >> shift) & 15];
  }
  // One number if all answers have the same size.
  static void append_sizes(std::string& line, const std::vector<double>& sizes) {
    bool same = true;
    for (const double size : sizes) same = same && size == sizes[0];
    for (std::size_t i = 0; i < (same ? 1 : sizes.size()); ++i)
      line += (i > 0 ? ", " : "") + std::to_string(int(sizes[i]));
  }

  std::vector<Field> fields_;
  std::size_t inputs_ = 0;
};

std::string threw(const std::string& what) {
  std::string line = "\"threw\": ";
  append_string(line, what.substr(0, 500));
  return line;
}

// Which inputs of a class are run; all of them if there are no choices and `end` is 0.
struct Chosen {
  int first = 0, end = 0;
  std::vector<std::vector<std::uint64_t>> choices;
};

std::string batch_of(const RunnerInputs& inputs, const Chosen& chosen) {
  Batch batch;
  const auto run = [&](Choices choices) {
    Answer answer;
    inputs.run(choices, answer);
    batch.add(answer);
  };
  for (const auto& each : chosen.choices) run(Choices(each));
  const int end = !chosen.choices.empty() ? 0 : chosen.end > 0 ? chosen.end : inputs.count;
  for (int i = chosen.first; i < end && i < inputs.count; ++i)
    run(Choices(glassbox::labs::input_seed(the_seed, inputs.what, i)));
  return batch.text();
}

std::string answered(const RunnerCheck& check, int index, const Chosen& chosen) {
  try {
    if (!check.generated.empty()) return batch_of(check.generated[std::size_t(index)], chosen);
    Answer answer;
    check.run(index, answer);
    return fields_of(answer);
  } catch (const std::exception& error) {
    return threw(error.what());
  } catch (...) {
    return threw("something that is not a std::exception");
  }
}

int run(const RunnerCheck& check, int from, int only, const Chosen& chosen, std::FILE* out) {
  if (only >= check.cases) {
    std::fprintf(stderr, "--case: the check has the cases 0 to %d, and no case %d\n",
                 check.cases - 1, only);
    return 2;
  }
  const int first = only >= 0 ? only : from;
  const int last = only >= 0 ? only + 1 : check.cases;
  for (int index = first; index < last && index < check.cases; ++index) {
    const std::string line =
        "{\"case\": " + std::to_string(index) + ", " + answered(check, index, chosen) + "}\n";
    if (std::fwrite(line.data(), 1, line.size(), out) != line.size() || std::fflush(out) != 0)
      return 1;
  }
  return 0;
}

// Reads "1 0 2;3": numbers of one input, and those of the next after a semicolon.
std::vector<std::vector<std::uint64_t>> read_choices(const char* text) {
  std::vector<std::vector<std::uint64_t>> all(1);
  while (*text != '\0') {
    if (*text == ';') all.emplace_back();
    if (*text < '0' || *text > '9') {
      ++text;
      continue;
    }
    char* end = nullptr;
    all.back().push_back(std::strtoull(text, &end, 10));
    text = end;
  }
  return all;
}

int list(std::FILE* out) {
  for (const RunnerCheck& check : glassbox::labs::runner_checks()) {
    std::string line = "{\"check\": ";
    append_string(line, check.name);
    line += ", \"cases\": " + std::to_string(check.cases) + "}\n";
    if (std::fwrite(line.data(), 1, line.size(), out) != line.size()) return 1;
  }
  return std::fflush(out) == 0 ? 0 : 1;
}

int usage(const char* program) {
  std::fprintf(stderr,
               "usage: %s --list\n"
               "       %s --check NAME [--case N | --from N] [--seed N] [--out-fd N]\n"
               "       %s --check NAME --case N --inputs FIRST END | --choices '1 0 2;3'\n",
               program, program, program);
  return 2;
}

}  // namespace

std::uint64_t glassbox::labs::inputs_seed() {
  return the_seed;
}

int main(int argc, char** argv) {
  std::string name;
  bool listing = false, named = false;
  int from = 0, only = -1, out_fd = 1;
  Chosen chosen;
  for (int i = 1; i < argc; ++i) {
    const bool more = i + 1 < argc;
    if (std::strcmp(argv[i], "--list") == 0) {
      listing = true;
    } else if (std::strcmp(argv[i], "--check") == 0 && more) {
      name = argv[++i];
      named = true;
    } else if (std::strcmp(argv[i], "--from") == 0 && more) {
      from = std::atoi(argv[++i]);
    } else if (std::strcmp(argv[i], "--case") == 0 && more) {
      only = std::atoi(argv[++i]);
    } else if (std::strcmp(argv[i], "--seed") == 0 && more) {
      the_seed = std::strtoull(argv[++i], nullptr, 10);
    } else if (std::strcmp(argv[i], "--inputs") == 0 && i + 2 < argc) {
      chosen.first = std::atoi(argv[++i]);
      chosen.end = std::atoi(argv[++i]);
    } else if (std::strcmp(argv[i], "--choices") == 0 && more) {
      chosen.choices = read_choices(argv[++i]);
    } else if (std::strcmp(argv[i], "--out-fd") == 0 && more) {
      out_fd = std::atoi(argv[++i]);
    } else {
      return usage(argv[0]);
    }
  }
  if (listing == named || from < 0 || chosen.first < 0) return usage(argv[0]);
  std::FILE* out = out_fd == 1 ? stdout : fdopen(out_fd, "w");
  if (out == nullptr) {
    std::perror("runner: --out-fd");
    return 2;
  }
  if (listing) return list(out);
  for (const RunnerCheck& check : glassbox::labs::runner_checks()) {
    if (check.name == name) return run(check, from, only, chosen, out);
  }
  std::fprintf(stderr, "%s: no check is called \"%s\"; --list names them\n", argv[0], name.c_str());
  return 2;
}
