// What a compiler hands to the assembler, read before the assembler reads it.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace glassbox::labs::grading {

// The first statement of an assembly file that is neither an instruction nor one of the directives that compilers write; none if
// there is none. A source can put any text into its assembly, by asm, by the name of a section or of a symbol, and an assembler
// reads files: .incbin and .include name them, macros can hide these words.
//
// Comments inside a line, characters in single quotes and strings over several lines are refused too, so that nothing which the
// assembler reads can be taken for text here. For x86-64 and AArch64, in g++'s words and clang++'s.
std::optional<std::string> foreign_statement(std::string_view assembly);

}  // namespace glassbox::labs::grading
