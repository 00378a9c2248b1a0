# A page with a gdb session in it, with the answers that gdb gives: docs/debugging.md is written so, and tested so.
#
#   gdb -nx --batch -ex 'python page = "docs/debugging.md"' -x debug/replay.py PROGRAM >new.md
#
# Lines that begin with "(gdb) " are given to gdb one after the other, and what follows each of them, up to the next one
# or the end of the block, is replaced by the answer. Addresses, the directories of the build and line numbers, which
# say nothing and differ from build to build, are left out.
import os
import re
import tempfile

import gdb

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

LEFT_OUT = (
    (r"^(\[Thread debugging|Using host libthread_db|Starting program:) .*\n", ""),
    (r"\bat 0x[0-9a-f]+: (file )?", "at "),  # of breakpoints
    (r"^0x[0-9a-f]+ in ", ""),  # of frames that are returned to
    (r"^(#\d+ +)0x[0-9a-f]+ in ", r"\1"),
    (r"@0x[0-9a-f]+: ", ""),  # of references
    (r"\b0x[0-9a-f]{6,}", "0x..."),
    (r"[^\s\"]*/include/glassbox/", ""),
    (re.escape(ROOT) + "/", ""),
    (r"(?<![\w./])(\.\./)+", ""),  # where a compiler's cache makes paths relative
    (r"(\.(cpp|h))(:|, line )\d+", r"\1"),
    (r"^\d+\t", "    "),
)


def answer(command):
    """All of standard output: the lines that say where the program stopped are no part of a command's own output."""
    gdb.flush()
    output = os.dup(1)
    with tempfile.TemporaryFile("w+") as caught:
        os.dup2(caught.fileno(), 1)
        try:
            gdb.execute(command, from_tty=True)
        except gdb.error as error:
            gdb.write(f"{error}\n")
        gdb.flush()
        os.dup2(output, 1)
        os.close(output)
        caught.seek(0)
        text = caught.read()
    for pattern, replacement in LEFT_OUT:
        text = re.sub(pattern, replacement, text, flags=re.MULTILINE)
    return [line.rstrip() for line in text.strip("\n").splitlines()]


def replayed(lines):
    answering = False
    for line in lines:
        if line.startswith("(gdb) "):
            yield line
            yield from answer(line[len("(gdb) ") :])
            answering = True
            continue
        answering = answering and not line.startswith("```")
        if not answering:
            yield line


os.chdir(ROOT)
for setting in ("width 0", "height 0", "confirm off", "style enabled off"):
    gdb.execute(f"set {setting}")
with open(page) as file:  # noqa: F821 - given on the command line
    print("\n".join(replayed(file.read().splitlines())))
