// A lab as an activity of Moodle's Virtual Programming Lab: https://vpl.dis.ulpgc.es.
#pragma once

#include <vector>

#include "labs/framework/lab.h"
#include "labs/framework/sources.h"
#include "labs/framework/zip.h"

namespace glassbox::labs::grading {

// The files: requested/student.cpp and student.h, which students edit and read;
// execution/vpl_run.sh and vpl_evaluate.sh; and README.txt, which explains where they go. `starter`
// are the files that students begin with.
std::vector<ZipEntry> vpl_files(const Lab& lab, const std::vector<SourceFile>& starter);

// The texts of vpl_run.sh and vpl_evaluate.sh. The jail server that runs them has glassbox
// installed.
std::string vpl_run_script(int lab);
std::string vpl_evaluate_script(int lab);

}  // namespace glassbox::labs::grading
