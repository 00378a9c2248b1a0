# Users link this library. It contains all parts, each as its own archive. raster comes together
# with render (raster_of_program).
add_library(glassbox INTERFACE)
add_library(glassbox::glassbox ALIAS glassbox)
foreach(part matrices render pipeline mesh compare html images base)
  target_link_libraries(glassbox INTERFACE glassbox_${part})
endforeach()
# Programs that use the library may use the matchers, too. They are installed with the program that
# the matchers start.
target_link_libraries(glassbox INTERFACE $<INSTALL_INTERFACE:glassbox::matchers>)
