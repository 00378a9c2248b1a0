#include "views/files/camera_file.h"

#include <cmath>

#include <fmt/format.h>
#include <Eigen/LU>
#include <Eigen/SVD>

#include <glassbox/base/printable.h>

#include "views/files/number_rows.h"

namespace glassbox::views {

namespace {

constexpr std::size_t kNumbers = 21;

Matrix3d matrix_at(const std::vector<double>& numbers, std::size_t first) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(numbers.data() + first);
}

Result<void> check_intrinsic(const Matrix3d& k, const std::string& place) {
  const bool is_triangular = k(1, 0) == 0 && k(2, 0) == 0 && k(2, 1) == 0;
  if (!is_triangular || !(k(0, 0) > 0) || !(k(1, 1) > 0) || !(k(2, 2) > 0)) {
    return fail(
        place,
        "the intrinsic matrix K is wrong: it must be 0 below the diagonal and positive on it",
        "give the focal lengths, the skew and the principal point, in pixels");
  }
  return {};
}

// The nearest rotation to a matrix that was written with few digits.
Result<Matrix3d> rotation_of(const Matrix3d& r, const std::string& place) {
  constexpr double kFewDigits = 1e-5;
  const double off = (r.transpose() * r - Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= kFewDigits)) {
    return fail(
        place,
        fmt::format("the matrix R is not a rotation: an entry of R^T R - I is {:.3g} instead of 0",
                    off),
        "give R perpendicular rows of length 1");
  }
  if (r.determinant() < 0) {
    return fail(place, "the matrix R is a mirror, not a rotation: its determinant is -1",
                "change the sign of one of its rows");
  }
  const Eigen::JacobiSVD<Matrix3d> svd(r, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return Matrix3d(svd.matrixU() * svd.matrixV().transpose());
}

Result<NamedCamera> camera_of_row(const NumberRow& row) {
  const std::string place = fmt::format("line {}", row.line);
  if (row.name.empty() || row.numbers.size() != kNumbers) {
    return fail(place,
                fmt::format("a camera needs a picture's name and {} numbers, but there are {}",
                            kNumbers, row.numbers.size()),
                "write the name, then the intrinsic matrix K, the rotation R and the translation "
                "t, the matrices row by row");
  }
  const Matrix3d k = matrix_at(row.numbers, 0);
  if (const auto legal = check_intrinsic(k, place); !legal) return tl::unexpected(legal.error());
  const auto rotation = rotation_of(matrix_at(row.numbers, 9), place);
  if (!rotation) return tl::unexpected(rotation.error());
  const Vector3d shift(row.numbers[18], row.numbers[19], row.numbers[20]);
  return NamedCamera{row.name, {k / k(2, 2), *rotation, -rotation->transpose() * shift}, {}};
}

}  // namespace

Result<std::vector<NamedCamera>> parse_cameras(std::string_view text) {
  const auto rows = number_rows(text);
  if (!rows) return tl::unexpected(rows.error());
  const bool has_count =
      !rows->empty() && rows->front().name.empty() && rows->front().numbers.size() == 1;
  if (!has_count) {
    return fail("line 1", "the first line must be the number of cameras and nothing else",
                "write this number into the first line");
  }
  const double count = rows->front().numbers.front();
  if (count != double(rows->size() - 1)) {
    return fail(fmt::format("line {}", rows->front().line),
                fmt::format("the first line announces {:g} cameras, but there are {}", count,
                            rows->size() - 1),
                "make the number agree with the lines");
  }
  std::vector<NamedCamera> cameras;
  for (std::size_t i = 1; i < rows->size(); ++i) {
    auto camera = camera_of_row((*rows)[i]);
    if (!camera) return tl::unexpected(camera.error());
    cameras.push_back(std::move(*camera));
  }
  return cameras;
}

std::string cameras_text(const std::vector<NamedCamera>& cameras) {
  std::string text = fmt::format("{}\n", cameras.size());
  for (const auto& [picture, camera, size] : cameras) {
    text += picture;
    const auto add = [&](const Matrix3d& matrix) {
      for (int i = 0; i < 9; ++i) text += fmt::format(" {}", matrix(i / 3, i % 3));
    };
    add(camera.intrinsic);
    add(camera.camera_from_world);
    const Vector3d shift = -camera.camera_from_world * camera.centre;
    text += fmt::format(" {} {} {}\n", shift.x(), shift.y(), shift.z());
  }
  return text;
}

}  // namespace glassbox::views
