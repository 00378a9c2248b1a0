#include "labs/grading/vpl.h"

#include <fmt/format.h>

namespace glassbox::labs::grading {

namespace {

// {0} is the lab's number, {1} its title.
constexpr const char* kReadme = R"(Lab {0}, {1}, for Moodle's Virtual Programming Lab

1. Install glassbox on the jail server (cmake --install), so that every user there can run
   `glassbox --version`.
2. Make an activity. Requested files: requested/student.cpp. Execution files: the files in
   execution/, instead of the scripts of the same name. Mark student.h as a file to keep when
   running, and give students handout.md as the description.
3. Execution options: run and evaluate yes, automatic grade yes.

"Evaluate" grades the visible checks and gives their points, scaled to the activity's grade. It
does not run the hidden checks (--visible), because the grade would reveal them, and no file that it
leaves in the student's folder names one: download the submissions afterwards, and run
`glassbox lab grade FOLDER --lab {0} -o results`.

The glassbox on the jail server has the solutions and the hidden checks. Students' code runs in its
sandbox, which reads none of them. Give students no other activity with a terminal on this server.
)";

// A script for Moodle's Virtual Programming Lab (VPL). VPL runs the script, which writes the
// program vpl_execution, and then runs that program.
std::string script_that_leaves(const std::string& what, const std::string& commands) {
  return "#!/bin/bash\n# " + what +
         "\ncat >vpl_execution <<'END'\n#!/bin/bash\n[ -r vpl_environment.sh ] && . "
         "./vpl_environment.sh\n" +
         commands + "END\nchmod +x vpl_execution\n";
}

}  // namespace

std::string vpl_run_script(int lab) {
  return script_that_leaves(
      "Shows what is right so far.",
      fmt::format("glassbox lab grade . --one --visible --lab {} -o results.json --vpl report.txt "
                  ">/dev/null 2>grading.log || cat grading.log\n"
                  "grep -v '^<|--$\\|^--|>$\\|^Grade :=>>' report.txt | sed 's/^[->]//'\n",
                  lab));
}

std::string vpl_evaluate_script(int lab) {
  return script_that_leaves(
      "Prints a comment for each visible check, and their points as the grade.",
      fmt::format("export VPL_GRADEMAX\n"
                  "glassbox lab grade . --one --visible --lab {} -o results.json --vpl report.txt "
                  ">/dev/null 2>grading.log || cat grading.log\n"
                  "cat report.txt\n",
                  lab));
}

std::vector<ZipEntry> vpl_files(const Lab& lab, const std::vector<SourceFile>& starter) {
  std::vector<ZipEntry> entries{
      {"README.txt", fmt::format(kReadme, lab.number, lab.title)},
      {"execution/vpl_run.sh", vpl_run_script(lab.number), true},
      {"execution/vpl_evaluate.sh", vpl_evaluate_script(lab.number), true}};
  for (const SourceFile& file : starter) {
    if (file.path == "student.cpp" || file.path == "student.h")
      entries.push_back({"requested/" + file.path, file.text});
    if (file.path == "handout.md") entries.push_back({file.path, file.text});
  }
  return entries;
}

}  // namespace glassbox::labs::grading
