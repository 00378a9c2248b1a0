// Finds what is wrong with three matrices that are given as model, view and projection: each on its
// own, and all together. A finding is an alarm only if no correct set of matrices for the dialect
// (graphics API) looks like this.
#pragma once

#include <string>
#include <vector>

#include <glassbox/matrices/matrix_setup.h>

namespace glassbox {

// kNote: worth knowing. kHint: legal, but often a mistake. kAlarm: cannot be correct for the
// purpose (model, view or projection) for which the matrix was given.
enum class Severity { kNote, kHint, kAlarm };

struct Finding {
  Severity severity = Severity::kNote;
  const char* id = "";      // does not change between versions: "transposed", "depth-lost"
  const char* matrix = "";  // "model", "view", "projection", or empty if it concerns all
  std::string cause, remedy;
};

class Findings {
public:
  void note(const char* id, const char* matrix, std::string cause, std::string remedy) {
    list_.push_back({Severity::kNote, id, matrix, std::move(cause), std::move(remedy)});
  }
  void hint(const char* id, const char* matrix, std::string cause, std::string remedy) {
    list_.push_back({Severity::kHint, id, matrix, std::move(cause), std::move(remedy)});
  }
  void alarm(const char* id, const char* matrix, std::string cause, std::string remedy) {
    list_.push_back({Severity::kAlarm, id, matrix, std::move(cause), std::move(remedy)});
  }
  const std::vector<Finding>& list() const { return list_; }

private:
  std::vector<Finding> list_;
};

std::vector<Finding> check_matrices(const MatrixSetup& setup);

// A last row of zeros, which makes any of the three matrices singular.
bool has_last_row_of_zeros(const glm::dmat4& m);
void alarm_last_row(const char* name, const glm::dmat4& m, const std::string& remedy,
                    Findings& found);

// The checks of each matrix on its own. Its entries must be finite.
void check_model(const MatrixSetup& setup, Findings& found);
void check_view(const MatrixSetup& setup, Findings& found);
void check_projection(const MatrixSetup& setup, Findings& found);

}  // namespace glassbox
