// The glassbox program. Each executable consists of this file and of the command groups (subjects)
// that app/CMakeLists.txt names for it.
#include "app/commands.h"
#include "app/first/first_picture.h"
#include "cli/run_program.h"
#include "labs/commands/commands.h"
#include "study/commands/commands.h"
#include "views/commands/commands.h"

int main(int argc, char** argv) {
  using namespace glassbox;
  constexpr Subject kSubjects[] = {
      {{}, app::add_commands},
      {study::kCommands, GLASSBOX_HAS_STUDY ? study::add_commands : nullptr},
      {views::kCommands, GLASSBOX_HAS_VIEWS ? views::add_commands : nullptr},
      {labs::kCommands, GLASSBOX_HAS_LABS ? labs::add_commands : nullptr},
  };
  return run_program(kSubjects, app::draw_first_picture, argc, argv);
}
