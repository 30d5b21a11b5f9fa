// SPDX-License-Identifier: MIT
// Vectors, matrices and rotations for several figures side by side. Included once by a file
// per instruction set. Names are in an unnamed namespace, and no other header's functions are
// called: the linker would keep one copy of such a function for all files, and that might have
// instructions that the processor lacks.
#pragma once

#include <cstddef>

namespace flinch::sim {
namespace {

template <std::size_t kLanes>
struct LaneType {
  typedef double Number __attribute__((vector_size(kLanes * sizeof(double))));
  typedef long long Mask __attribute__((vector_size(kLanes * sizeof(double))));
};
template <>
struct LaneType<1> {
  using Number = double;
  using Mask = bool;
};

/// Where a lane's condition holds its number of the first, else that of the second.
template <class N, class Mask>
N select(const Mask& where, const N& first, const N& second) {
  return where ? first : second;
}

/// Whether a condition holds in all lanes.
template <class Mask>
bool holds_everywhere(const Mask& mask) {
  if constexpr (sizeof(Mask) < sizeof(double)) {
    return mask != 0;
  } else {
    bool all = true;
    for (std::size_t lane = 0; lane < sizeof mask / sizeof(double); ++lane)
      all = all && mask[lane] != 0;
    return all;
  }
}

template <class N>
N absolute(const N& number) {
  return select(number < 0.0, -number, number);
}
template <class N>
N square_root(const N& number) {
  constexpr std::size_t kLanes = sizeof(N) / sizeof(double);
  double lanes[kLanes];
  __builtin_memcpy(lanes, &number, sizeof number);
  for (std::size_t lane = 0; lane < kLanes; ++lane) lanes[lane] = __builtin_sqrt(lanes[lane]);
  N root;
  __builtin_memcpy(&root, lanes, sizeof root);
  return root;
}

template <class N>
struct Vector {
  N x, y, z;
};
/// A matrix by its columns.
template <class N>
struct Matrix {
  Vector<N> x, y, z;
};
template <class N>
struct SymmetricMatrix {
  N xx, yy, zz, xy, xz, yz;
};

template <class N, class Mask>
Vector<N> select(const Mask& where, const Vector<N>& first, const Vector<N>& second) {
  return {select(where, first.x, second.x), select(where, first.y, second.y),
          select(where, first.z, second.z)};
}
template <class N, class Mask>
Matrix<N> select(const Mask& where, const Matrix<N>& first, const Matrix<N>& second) {
  return {select(where, first.x, second.x), select(where, first.y, second.y),
          select(where, first.z, second.z)};
}
template <class N, class Mask>
SymmetricMatrix<N> select(const Mask& where, const SymmetricMatrix<N>& first,
                          const SymmetricMatrix<N>& second) {
  return {select(where, first.xx, second.xx), select(where, first.yy, second.yy),
          select(where, first.zz, second.zz), select(where, first.xy, second.xy),
          select(where, first.xz, second.xz), select(where, first.yz, second.yz)};
}

template <class N>
Vector<N> operator+(const Vector<N>& a, const Vector<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
Vector<N> operator-(const Vector<N>& a, const Vector<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
Vector<N> operator-(const Vector<N>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class N, class Factor>
Vector<N> operator*(const Factor& factor, const Vector<N>& v) {
  return {factor * v.x, factor * v.y, factor * v.z};
}
template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class N>
Matrix<N> operator+(const Matrix<N>& a, const Matrix<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
Matrix<N> operator-(const Matrix<N>& a, const Matrix<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N, class Factor>
Matrix<N> scaled(const Factor& factor, const Matrix<N>& m) {
  return {factor * m.x, factor * m.y, factor * m.z};
}
template <class N>
Vector<N> operator*(const Matrix<N>& m, const Vector<N>& v) {
  return v.x * m.x + v.y * m.y + v.z * m.z;
}
template <class N>
Matrix<N> operator*(const Matrix<N>& a, const Matrix<N>& b) {
  return {a * b.x, a * b.y, a * b.z};
}
template <class N>
Vector<N> transposed_times(const Matrix<N>& m, const Vector<N>& v) {
  return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}
template <class N>
Matrix<N> transposed(const Matrix<N>& m) {
  return {{m.x.x, m.y.x, m.z.x}, {m.x.y, m.y.y, m.z.y}, {m.x.z, m.y.z, m.z.z}};
}
/// m [v]x
template <class N>
Matrix<N> times_cross(const Matrix<N>& m, const Vector<N>& v) {
  return {v.z * m.y - v.y * m.z, v.x * m.z - v.z * m.x, v.y * m.x - v.x * m.y};
}

template <class N>
SymmetricMatrix<N> operator+(const SymmetricMatrix<N>& a, const SymmetricMatrix<N>& b) {
  return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
}
template <class N>
SymmetricMatrix<N> operator-(const SymmetricMatrix<N>& a, const SymmetricMatrix<N>& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
}
template <class N, class Factor>
SymmetricMatrix<N> scaled(const Factor& factor, const SymmetricMatrix<N>& m) {
  return {factor * m.xx, factor * m.yy, factor * m.zz, factor * m.xy, factor * m.xz, factor * m.yz};
}
template <class N>
Matrix<N> full(const SymmetricMatrix<N>& m) {
  return {{m.xx, m.xy, m.xz}, {m.xy, m.yy, m.yz}, {m.xz, m.yz, m.zz}};
}
/// The upper triangle of a matrix that is symmetric except for rounding.
template <class N>
SymmetricMatrix<N> upper(const Matrix<N>& m) {
  return {m.x.x, m.y.y, m.z.z, m.y.x, m.z.x, m.z.y};
}
template <class N>
Vector<N> operator*(const SymmetricMatrix<N>& m, const Vector<N>& v) {
  return full(m) * v;
}
/// a b^T, for a product that is known to be symmetric.
template <class N>
SymmetricMatrix<N> symmetric_product(const Matrix<N>& a, const Matrix<N>& b) {
  const Matrix<N> rows_a = transposed(a);
  const Matrix<N> rows_b = transposed(b);
  return {dot(rows_a.x, rows_b.x), dot(rows_a.y, rows_b.y), dot(rows_a.z, rows_b.z),
          dot(rows_a.x, rows_b.y), dot(rows_a.x, rows_b.z), dot(rows_a.y, rows_b.z)};
}
/// v v^T
template <class N>
SymmetricMatrix<N> square(const Vector<N>& v) {
  return {v.x * v.x, v.y * v.y, v.z * v.z, v.x * v.y, v.x * v.z, v.y * v.z};
}
/// Inverse by cofactors.
template <class N>
SymmetricMatrix<N> inverse(const SymmetricMatrix<N>& m) {
  const N xx = m.yy * m.zz - m.yz * m.yz;
  const N xy = m.xz * m.yz - m.xy * m.zz;
  const N xz = m.xy * m.yz - m.xz * m.yy;
  const N share = 1.0 / (m.xx * xx + m.xy * xy + m.xz * xz);
  return {share * xx,
          share * (m.xx * m.zz - m.xz * m.xz),
          share * (m.xx * m.yy - m.xy * m.xy),
          share * xy,
          share * xz,
          share * (m.xy * m.xz - m.xx * m.yz)};
}
/// Solves m x = b by Cramer's rule.
template <class N>
Vector<N> solved(const Matrix<N>& m, const Vector<N>& b) {
  const Vector<N> yz = cross(m.y, m.z);
  const N share = 1.0 / dot(m.x, yz);
  return {share * dot(b, yz), share * dot(b, cross(m.z, m.x)), share * dot(b, cross(m.x, m.y))};
}

template <class N>
struct Quaternion {
  N w;
  Vector<N> u;
};
template <class N>
Quaternion<N> operator*(const Quaternion<N>& a, const Quaternion<N>& b) {
  return {a.w * b.w - dot(a.u, b.u), a.w * b.u + b.w * a.u + cross(a.u, b.u)};
}
template <class N>
Quaternion<N> conjugate(const Quaternion<N>& q) {
  return {q.w, -q.u};
}
/// The rotation matrix of a unit quaternion.
template <class N>
Matrix<N> rotation(const Quaternion<N>& q) {
  const Vector<N> twice = q.u + q.u;
  const Vector<N> by_w = q.w * twice;
  const N xx = q.u.x * twice.x, yy = q.u.y * twice.y, zz = q.u.z * twice.z;
  const N xy = q.u.x * twice.y, xz = q.u.x * twice.z, yz = q.u.y * twice.z;
  return {{1.0 - (yy + zz), xy + by_w.z, xz - by_w.y},
          {xy - by_w.z, 1.0 - (xx + zz), yz + by_w.x},
          {xz + by_w.y, yz - by_w.x, 1.0 - (xx + yy)}};
}

}  // namespace
}  // namespace flinch::sim
