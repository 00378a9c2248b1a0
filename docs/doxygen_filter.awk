# The headers' comments as Doxygen wants them. They are plain: "//" above what they are about, or behind it. The first
# comment of a file is about the file. A comment with an empty line below it, or of dashes, is about nothing in particular.
# Lines that a comment indents are kept as they are, words that Doxygen would take for commands are not.

# Text of a comment with what is special to Doxygen made plain, but for code between backquotes.
function plain(text,    parts, count, i, result) {
  count = split(text, parts, "`")
  for (i = 1; i <= count; i++) {
    if (i % 2 == 1 || i == count) gsub(/[\\@<>&#%|*_]/, "\\\\&", parts[i])
    result = result (i > 1 ? "`" : "") parts[i]
  }
  return result
}

function end_verbatim() {
  if (verbatim) print indent "/// @endverbatim"
  verbatim = 0
}

# The comment that has been read, as documentation or as it was.
function flush(documents,    i, text, list) {
  if (documents && first && held) print "/// @file"
  for (i = 1; i <= held; i++) {
    if (!documents) {
      print lines[i]
      continue
    }
    match(lines[i], /^ */)
    indent = substr(lines[i], 1, RLENGTH)
    text = substr(lines[i], RLENGTH + 3)
    if (text !~ /^   /) list = 0
    if (text ~ /^ *- /) list = 1
    if (text ~ /^   / && !list) {
      if (!verbatim) print indent "/// @verbatim"
      verbatim = 1
      print indent "///" text
    } else {
      end_verbatim()
      print indent "///" plain(text)
    }
  }
  end_verbatim()
  first = 0
  held = 0
}

FNR == 1 { first = 1; column = 0; held = 0 }

/^ *\/\/ ----/ { flush(0); column = 0; print; next }

# A comment of its own, or the rest of one that began behind the code above.
/^ *\/\// {
  match($0, /\/\//)
  if (column && RSTART == column) {
    print substr($0, 1, RSTART - 1) "///<" plain(substr($0, RSTART + 2))
    next
  }
  column = 0
  lines[++held] = $0
  next
}

{
  flush(first || $0 !~ /^ *$/)
  # Behind a declaration or one of its parts: no string here has blanks and two slashes.
  column = 0
  if (match($0, /[;,)}A-Za-z0-9_]  +\/\/ /) && $0 !~ /^ *#/ && $0 !~ /^ *}[^;]/) {
    column = RSTART + RLENGTH - 3
    $0 = substr($0, 1, column - 1) "///<" plain(substr($0, column + 2))
  }
  print
}

END { flush(0) }
