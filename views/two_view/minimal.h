// Matrices from as few matches as can decide them: what a random sample is fitted with (ransac.h).
#pragma once

#include <vector>

#include <Eigen/Core>

#include <glassbox/base/error.h>

#include "views/two_view/match.h"

namespace glassbox::views {

// Seven matches leave a pencil a F1 + b F2, of which det = 0 chooses at most three.
Result<std::vector<Eigen::Matrix3d>> seven_point(const Matches& pixels);

// Five calibrated matches leave x X + y Y + z Z + W; Demazure's equations and det = 0, ten cubics, choose at most ten (Nister, PAMI 26,
// 2004). They are solved as eigenvalues of multiplication by x among the ten monomials of degree 2 or less (Stewenius, Engels,
// Nister, ISPRS 60, 2006), and improved by Newton's method; the real ones are returned, of Frobenius norm 1.
Result<std::vector<Eigen::Matrix3d>> five_point(const Matches& calibrated);

}  // namespace glassbox::views
