// Checks the assembly that a compiler produces before the assembler reads it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glassbox::labs::grading {

// The first statement of an assembly file that is neither an instruction nor one of the directives
// that compilers write; empty if there is none. A source can put any text into its assembly, by asm
// or by the name of a section or of a symbol. An assembler can read files: .incbin and .include
// name them, and macros can hide these words.
//
// Comments inside a line, characters in single quotes and strings over several lines are refused
// too, so that no statement of the assembler can be mistaken for plain text here. For x86-64 and
// AArch64, as g++ and clang++ write them.
std::optional<std::string> foreign_statement(std::string_view assembly);

}  // namespace glassbox::labs::grading
