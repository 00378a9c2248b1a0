// glassbox man: prints the manual page, for man(1).
#include <algorithm>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/help/help_command.h"
#include "cli/options/add_command.h"
#include "cli/options/command_tree.h"
#include "cli/report/exit_codes.h"

#include <glassbox/mesh/builtin/scenes.h>

namespace glassbox {

class ManCommand {
public:
  void add_to(CLI::App& app, int& exit_code);
};

// The manual page, made from the same tables as the help text.

namespace {

// Escapes text so that roff prints it unchanged. A hyphen becomes the ASCII minus, which can be
// copied and searched for.
std::string roff(const std::string& text) {
  std::string escaped;
  bool line_starts = true;
  for (const char c : text) {
    // At the start of a line, roff would read a dot or an apostrophe as a request.
    if (line_starts && (c == '.' || c == '\'')) escaped += "\\&";
    line_starts = c == '\n';
    if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else if (c == '\'') {
      escaped += "\\(aq";
    } else if (c == '`') {
      escaped += "\\(ga";
    } else if (c == '^') {
      escaped += "\\(ha";
    } else if (c == '~') {
      escaped += "\\(ti";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string option_entry(const OptionFacts& option) {
  std::string names;
  for (const std::string& name : option.names) {
    names += (names.empty() ? "" : ", ") + ("\\fB" + roff(name) + "\\fR");
  }
  if (option.is_positional()) names = "\\fI" + roff(option.positional) + "\\fR";
  if (!option.value.empty()) names += " \\fI" + roff(option.value) + "\\fR";
  return ".TP\n" + names + "\n" + roff(option.help) + "\n";
}

// The --help option, which every command has, is described only once.
bool is_help(const OptionFacts& option) {
  return std::ranges::find(option.names, "--help") != option.names.end();
}

std::vector<std::string> groups_of(const CommandFacts& command) {
  std::vector<std::string> groups;
  for (const OptionFacts& option : command.options) {
    const bool known = std::ranges::find(groups, option.group) != groups.end();
    if (!known && !is_help(option) && !option.is_positional()) groups.push_back(option.group);
  }
  return groups;
}

std::string options_of(const CommandFacts& command) {
  std::string text;
  for (const OptionFacts& option : command.options) {
    if (option.is_positional()) text += option_entry(option);
  }
  const std::vector<std::string> groups = groups_of(command);
  for (const std::string& group : groups) {
    if (group != "Options") text += ".PP\n\\fI" + roff(group) + "\\fR\n";
    for (const OptionFacts& option : command.options) {
      if (option.group == group && !is_help(option) && !option.is_positional()) {
        text += option_entry(option);
      }
    }
  }
  return text;
}

std::string usage_of(const CommandFacts& command) {
  std::string text;
  for (const OptionFacts& option : command.options) {
    if (!option.is_positional()) continue;
    std::string word = roff(option.positional) + (option.repeats ? "..." : "");
    if (!option.required) word = "[" + word + "]";
    text += " \\fI" + word + "\\fR";
  }
  return text;
}

// Keeps the line breaks of "Examples:" and the lines below it; leaves out the list of scenes, which
// has its own section.
std::string footer_of(const CommandFacts& command) {
  std::istringstream lines(command.footer.substr(0, command.footer.find("Built-in scenes:")));
  std::string text, line;
  for (bool verbatim = false; std::getline(lines, line);) {
    const bool indented = line.starts_with("  ");
    if (indented != verbatim) text += indented ? ".PP\n.nf\n" : ".fi\n";
    verbatim = indented;
    if (line.empty()) {
      text += ".PP\n";
    } else {
      text += roff(line) + "\n";
    }
    if (lines.peek() == EOF && verbatim) text += ".fi\n";
  }
  return text;
}

std::string commands_of(const CommandFacts& command, const std::string& name) {
  std::string text;
  for (const CommandFacts& one : command.commands) {
    const std::string own = name + " " + one.name;
    text += ".SS \"" + own + "\"\n";
    text += "\\fB" + roff(own) + "\\fR" +
            (one.commands.empty() ? " [\\fIoptions\\fR]" : " \\fISUBCOMMAND\\fR") + usage_of(one) +
            "\n.PP\n" + roff(one.help) + ".\n";
    text += options_of(one);
    if (!one.footer.empty()) text += ".PP\n" + footer_of(one);
    text += commands_of(one, own);
  }
  return text;
}

bool is_heading(const std::string& line) {
  return line.starts_with(".SS") || line.starts_with(".SH");
}

// Drops .PP (start of a paragraph) after a heading, before another .PP, and where it is repeated,
// because groff and mandoc warn of empty paragraphs.
std::string without_empty_paragraphs(const std::string& text) {
  std::istringstream lines(text);
  std::string out, line;
  for (bool begun = false, heading = false; std::getline(lines, line);) {
    if (line == ".PP") {
      begun = !heading;
      continue;
    }
    if (begun && !is_heading(line) && !line.starts_with(".TP")) out += ".PP\n";
    begun = false;
    heading = is_heading(line);
    out += line + "\n";
  }
  return out;
}

std::string scenes() {
  std::string text;
  for (const BuiltinScene& scene : builtin_scenes()) {
    text += ".TP\n\\fB" + roff(std::string(scene.name)) + "\\fR\n" +
            roff(std::string(scene.description));
    if (scene.levels) {
      text += roff(
          fmt::format(" ({0}:{1} .. {0}:{2})", scene.name, scene.levels->low, scene.levels->high));
    }
    text += "\n";
  }
  return text;
}

constexpr const char* kExitCodes =
    ".SH EXIT STATUS\n"
    ".TP\n0\nfine\n"
    ".TP\n1\na failure, or a difference was found\n"
    ".TP\n2\nbad usage or bad input; one line says what was wrong, where, and what to do\n";

}  // namespace

// The page glassbox(1) in the man macros that groff and mandoc read.
std::string man_page(const CommandFacts& program, const std::string& version) {
  std::string text =
      ".\\\" Written by `glassbox man`.\n"
      ".TH GLASSBOX 1 \"\" \"glassbox " +
      version + "\" \"User Commands\"\n";
  text += ".SH NAME\nglassbox \\- a software rasterizer you can see through\n";
  text += ".SH SYNOPSIS\n\\fBglassbox\\fR \\fISUBCOMMAND\\fR [\\fIoptions\\fR]\n";
  text += ".SH DESCRIPTION\n" + roff(program.footer) + "\n";
  text += ".PP\nEvery subcommand takes \\fB\\-h\\fR and \\fB\\-\\-help\\fR.\n";
  text += ".SH OPTIONS\n";
  for (const OptionFacts& option : program.options) text += option_entry(option);
  text += ".SH COMMANDS\n" + commands_of(program, "glassbox");
  text += ".SH BUILT\\-IN SCENES\n" + scenes();
  text += kExitCodes;
  return without_empty_paragraphs(text);
}

void ManCommand::add_to(CLI::App& app, int& exit_code) {
  CLI::App& command = *app.add_subcommand("man", "print the manual page, for man and groff");
  command.footer(
      "Examples:\n"
      "  glassbox man | man -l -\n"
      "  glassbox man > ~/.local/share/man/man1/glassbox.1\n\n"
      "cmake --install puts it where man looks for it.");
  command.callback([&app, &exit_code] {
    fmt::print("{}", man_page(command_tree(app), GLASSBOX_VERSION));
    exit_code = kSuccess;
  });
}

void add_man_command(CLI::App& app, int& exit_code) {
  add_command<ManCommand>(app, exit_code);
}

}  // namespace glassbox
