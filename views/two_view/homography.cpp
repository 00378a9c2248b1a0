#include "views/two_view/homography.h"

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>

#include "views/two_view/linear_fit.h"

namespace glassbox::views {

// Solves p_r x H p_l = 0, the cross product of the right point and the transformed left point,
// which gives two independent equations for each match.
Result<Eigen::Matrix3d> fit_homography(const Matches& matches) {
  if (matches.size() < 4) {
    return fail("the matches", fmt::format("there are {}, but 4 are needed", matches.size()),
                "give more matches");
  }
  return normalised(matches).and_then([&](const Normalised& from) -> Result<Eigen::Matrix3d> {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(Eigen::Index(2 * matches.size()), 9);
    for (Eigen::Index i = 0; i < Eigen::Index(matches.size()); ++i) {
      const Match& match = from.matches[std::size_t(i)];
      const Eigen::RowVector3d left = match.left.homogeneous().transpose();
      rows.row(2 * i) << -left, Eigen::RowVector3d::Zero(), match.right.x() * left;
      rows.row(2 * i + 1) << Eigen::RowVector3d::Zero(), -left, match.right.y() * left;
    }
    const Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::FullPivHouseholderQRPreconditioner> svd(
        rows, Eigen::ComputeFullV);
    const Eigen::Matrix<double, 9, 1> entries = svd.matrixV().col(8);
    const Eigen::Matrix3d there = entries.reshaped<Eigen::RowMajor>(3, 3);
    const Eigen::Matrix3d h = (from.right.inverse() * there * from.left).normalized();
    const double determinant = h.determinant();
    if (determinant == 0) {
      return fail("the matches", "too many of their points are on one line",
                  "give at least four matches of which no three points are on one line");
    }
    return determinant < 0 ? Eigen::Matrix3d(-h) : h;
  });
}

}  // namespace glassbox::views
