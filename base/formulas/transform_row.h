// One row of the matrix times the column (x, y, z, ...). The products are summed from left to
// right: this order is fixed, so that the result is the same everywhere.
template <class Matrix, Number F>
inline F transform_row(const Matrix& m, int row, F x, F y, F z) {
  return m.at(row, 0) * x + m.at(row, 1) * y + m.at(row, 2) * z + m.at(row, 3);
}
