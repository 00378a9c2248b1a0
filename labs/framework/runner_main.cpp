// The program around a lab's functions: calls them with the cases of one check and writes the
// answers, one JSON object per line.
//
//   runner --list
//                    {"check": "name", "cases": 3} for each check
//   runner --check NAME [--from N] [--case N] [--out-fd N]
//                    {"case": 0, "fields": {"name": [1, "nan"]}} for each case, and
//                    {"case": 1, "threw": "what"} where the function threw
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
using glassbox::labs::RunnerCheck;

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

std::string threw(const std::string& what) {
  std::string line = "\"threw\": ";
  append_string(line, what.substr(0, 500));
  return line;
}

std::string answered(const RunnerCheck& check, int index) {
  try {
    Answer answer;
    check.run(index, answer);
    return fields_of(answer);
  } catch (const std::exception& error) {
    return threw(error.what());
  } catch (...) {
    return threw("something that is not a std::exception");
  }
}

int run(const RunnerCheck& check, int from, int only, std::FILE* out) {
  const int first = only >= 0 ? only : from;
  const int last = only >= 0 ? only + 1 : check.cases;
  for (int index = first; index < last && index < check.cases; ++index) {
    const std::string line =
        "{\"case\": " + std::to_string(index) + ", " + answered(check, index) + "}\n";
    if (std::fwrite(line.data(), 1, line.size(), out) != line.size() || std::fflush(out) != 0)
      return 1;
  }
  return 0;
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
               "       %s --check NAME [--case N | --from N] [--seed N] [--out-fd N]\n",
               program, program);
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
    } else if (std::strcmp(argv[i], "--out-fd") == 0 && more) {
      out_fd = std::atoi(argv[++i]);
    } else {
      return usage(argv[0]);
    }
  }
  if (listing == named || from < 0) return usage(argv[0]);
  std::FILE* out = out_fd == 1 ? stdout : fdopen(out_fd, "w");
  if (out == nullptr) {
    std::perror("runner: --out-fd");
    return 2;
  }
  if (listing) return list(out);
  for (const RunnerCheck& check : glassbox::labs::runner_checks()) {
    if (check.name == name) return run(check, from, only, out);
  }
  std::fprintf(stderr, "%s: no check is called \"%s\"; --list names them\n", argv[0], name.c_str());
  return 2;
}
