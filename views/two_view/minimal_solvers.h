// Minimal solvers: matrices from as few matches as determine them. RANSAC applies them to its
// random samples (ransac.h).
#pragma once

#include <vector>

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// Seven matches leave a pencil of possible matrices, t F1 + F2, from which det = 0 selects at most
// three.
Result<std::vector<Eigen::Matrix3d>> seven_point(const Matches& pixels);

// Five calibrated matches leave the matrices x X + y Y + z Z + W, from which Demazure's equations
// and det = 0, ten cubics, select at most ten (Nister, PAMI 26, 2004). The equations are solved as
// eigenvalues of the multiplication by x among the ten monomials of degree 2 or less (Stewenius,
// Engels, Nister, ISPRS 60, 2006), and the solutions are improved by Gauss-Newton steps. Returns
// the real solutions, with Frobenius norm 1.
Result<std::vector<Eigen::Matrix3d>> five_point(const Matches& calibrated);

}  // namespace glassbox::views
