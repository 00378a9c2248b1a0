// Row times column, summed from left to right: the one written order (DESIGN 3).
template <class Matrix, Number F>
inline F transform_row(const Matrix& m, int row, F x, F y, F z) {
  return m.at(row, 0) * x + m.at(row, 1) * y + m.at(row, 2) * z + m.at(row, 3);
}
