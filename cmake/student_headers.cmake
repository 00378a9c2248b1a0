# A program for students installs only those headers of the library that the files of the labs
# include, because others contain formulas that solve a task. The main program installs these headers
# alone with `cmake --install BUILD --component student-headers`, as a test does.
set(files "")
foreach(part student.h student.cpp cases.h generators*.h runner.cpp stages.cpp timed.cpp)
  file(GLOB some CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/labs/[0-9][0-9]-*/${part})
  list(APPEND files ${some})
endforeach()
file(GLOB some CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/labs/framework/*.h ${PROJECT_SOURCE_DIR}/labs/framework/*_main.cpp)
list(APPEND files ${some})

set(headers "")
while(files)
  list(POP_FRONT files file)
  file(STRINGS ${file} lines REGEX "^#include <glassbox/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^#include <glassbox/(.*)>.*" "\\1" header "${line}")
    if(NOT header IN_LIST headers)
      list(APPEND headers ${header})
      list(APPEND files ${PROJECT_SOURCE_DIR}/${header})
    endif()
  endforeach()
endwhile()

set(apart EXCLUDE_FROM_ALL)
if(GLASSBOX_STUDENT)
  set(apart "")
endif()
foreach(header IN LISTS headers)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${PROJECT_SOURCE_DIR}/${header} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glassbox/${folder}
    COMPONENT student-headers ${apart})
endforeach()
