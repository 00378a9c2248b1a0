# cmake -D whole=PROGRAM -D launcher=FILE -D parts=PROGRAM,... -P partial_programs.cmake
# checks what a program of one subject says about the other subjects.
execute_process(COMMAND ${whole} --help OUTPUT_VARIABLE whole_help COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "," ";" parts "${parts}")
# The launcher (./glassbox) has its own list, the function program_of. For each command of the whole
# program it must name a program that has the command.
file(READ ${launcher} text)
string(REGEX MATCH "program_of\\(\\) {\n.*\n}\n" program_of "${text}")
string(REGEX REPLACE "\n}\n.*" "\n}\n" program_of "${program_of}")
string(REGEX MATCHALL "\n  [a-z]+ " commands "${whole_help}")
list(LENGTH commands count)
if(count LESS 14) # ten commands of one picture, and four subjects
  message(FATAL_ERROR "${whole} --help lists ${count} commands:\n${whole_help}")
endif()
get_filename_component(folder ${whole} DIRECTORY)
foreach(command ${commands})
  string(STRIP "${command}" command)
  execute_process(COMMAND /bin/sh -euc "${program_of}program_of ${command}" OUTPUT_VARIABLE program
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${folder}/${program} ${command} --help OUTPUT_VARIABLE help RESULT_VARIABLE code)
  execute_process(COMMAND ${whole} ${command} --help OUTPUT_VARIABLE right)
  # The program prints which instruction sets it has, and the best of them. The program of the ten
  # commands has fewer.
  foreach(text help right)
    string(REGEX REPLACE "--target [^\n]*(\n            *)?[^\n]*instructions to use[^\n]*" "" ${text} "${${text}}")
  endforeach()
  if(NOT code EQUAL 0 OR NOT help STREQUAL right)
    message(FATAL_ERROR "${launcher} runs ${command} with ${program}, which lacks it")
  endif()
endforeach()
# glassbox-picture lacks these instruction sets, and all other programs have them.
foreach(words "render teapot --target avx512=glassbox" "stereo cube --target=SSE4 --size 8x8=glassbox"
    "render teapot --target avx2=glassbox-picture" "render avx512.obj=glassbox-picture" "views klt --target avx512=glassbox-views")
  string(REGEX MATCH "(.*)=(.*)" words "${words}")
  set(right ${CMAKE_MATCH_2})
  execute_process(COMMAND /bin/sh -euc "${program_of}program_of ${CMAKE_MATCH_1}" OUTPUT_VARIABLE program
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT program STREQUAL right)
    message(FATAL_ERROR "${launcher} runs ${words} with ${program}")
  endif()
endforeach()
foreach(part ${parts})
  # The program lists all subcommands, with the same words.
  execute_process(COMMAND ${part} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
  if(NOT help STREQUAL whole_help)
    message(FATAL_ERROR "${part} --help differs from ${whole} --help:\n${help}")
  endif()
  # The program has the full help of its own subject, after which it is named. It refuses any other
  # subject with the command that builds it.
  get_filename_component(name ${part} NAME)
  string(REPLACE "glassbox-" "" own ${name})
  foreach(subject study views lab)
    execute_process(COMMAND ${part} ${subject} --help OUTPUT_VARIABLE help RESULT_VARIABLE code)
    execute_process(COMMAND ${whole} ${subject} --help OUTPUT_VARIABLE right)
    if(subject STREQUAL own AND NOT help STREQUAL right)
      message(FATAL_ERROR "${part} ${subject} --help differs from the whole program's:\n${help}")
    endif()
    if(NOT subject STREQUAL own)
      execute_process(COMMAND ${part} ${subject} list RESULT_VARIABLE code ERROR_VARIABLE said)
      if(NOT code EQUAL 2 OR NOT said MATCHES "\\./glassbox ${subject} builds it")
        message(FATAL_ERROR "${part} ${subject} ended with ${code}: ${said}")
      endif()
    endif()
  endforeach()
endforeach()
