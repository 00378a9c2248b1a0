# `cmake --install` installs the program, the headers, the archives, and the files for
# find_package(glassbox).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# `glassbox lab` hands out these files and compiles students' code with them. The judges are in the
# program. Solutions and hidden cases are among these files, except in a glassbox for students.
set(installed_labs ${PROJECT_SOURCE_DIR}/labs)
if(GLASSBOX_STUDENT)
  set(installed_labs ${PROJECT_BINARY_DIR}/for-students/labs)
endif()
install(DIRECTORY ${installed_labs} DESTINATION ${CMAKE_INSTALL_DATADIR}/glassbox FILES_MATCHING
  REGEX "/[0-9][0-9]-[^/]*/(student\\.cpp|runner\\.cpp|stages\\.cpp|timed\\.cpp|student\\.h|cases\\.h|generators[^/]*\\.h|points\\.json)$"
  REGEX "/[0-9][0-9]-[^/]*/.*\\.(md|png|svg|jpg|ppm|obj|mtl|gltf|glb)$"
  REGEX "/framework/([^/]*\\.h|(runner|stages)_main\\.cpp)$"
  REGEX "/grading/(crash_reporter|compiler_view)\\.cpp$")
install(FILES ${PROJECT_SOURCE_DIR}/docs/references.md DESTINATION ${CMAKE_INSTALL_DATADIR}/glassbox/labs)
include(${CMAKE_CURRENT_LIST_DIR}/student_headers.cmake)
install(TARGETS glassbox_program DESTINATION ${CMAKE_INSTALL_BINDIR})
# The program writes the files for shells and for man from its own tables of options.
function(install_what_it_writes file destination)
  list(JOIN ARGN " " words)
  install(CODE "execute_process(COMMAND \"$<TARGET_FILE:glassbox_program>\" ${words}
    OUTPUT_FILE \"${PROJECT_BINARY_DIR}/${file}\" COMMAND_ERROR_IS_FATAL ANY)")
  install(FILES ${PROJECT_BINARY_DIR}/${file} DESTINATION ${destination})
endfunction()
install_what_it_writes(glassbox.1 ${CMAKE_INSTALL_MANDIR}/man1 man)
install_what_it_writes(glassbox ${CMAKE_INSTALL_DATADIR}/bash-completion/completions completion bash)
install_what_it_writes(_glassbox ${CMAKE_INSTALL_DATADIR}/zsh/site-functions completion zsh)
install_what_it_writes(glassbox.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d completion fish)

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# What remains is the library.
if(GLASSBOX_STUDENT)
  return()
endif()
set(parts base images html compare mesh pipeline raster render matrices)
foreach(part ${parts})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${part} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glassbox
    FILES_MATCHING PATTERN "*.h")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/include/glassbox/glassbox.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/glassbox)

set(archives ${parts})
list(TRANSFORM archives PREPEND glassbox_)
set_target_properties(glassbox_flags PROPERTIES EXPORT_NAME flags)
install(TARGETS glassbox glassbox_flags ${archives} EXPORT glassbox
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
# The matchers are found without the library and what it needs.
install(TARGETS glassbox_matchers EXPORT glassbox-matchers ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/glassbox)
install(EXPORT glassbox FILE glassbox-targets.cmake NAMESPACE glassbox:: DESTINATION ${package_dir})
install(EXPORT glassbox-matchers FILE glassbox-matchers-targets.cmake NAMESPACE glassbox:: DESTINATION ${package_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/glassbox-config.cmake.in
  ${PROJECT_BINARY_DIR}/glassbox-config.cmake INSTALL_DESTINATION ${package_dir}
  PATH_VARS CMAKE_INSTALL_BINDIR NO_SET_AND_CHECK_MACRO NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/glassbox-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/glassbox-config.cmake
  ${PROJECT_BINARY_DIR}/glassbox-config-version.cmake
  ${PROJECT_SOURCE_DIR}/compare/testing/glassbox-image-test.cmake
  ${PROJECT_SOURCE_DIR}/compare/testing/glassbox-run-image-test.cmake DESTINATION ${package_dir})
