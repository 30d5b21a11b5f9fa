// SPDX-License-Identifier: MIT
// The source of the kernels, included once by a file per instruction set. Names are in an unnamed
// namespace, and no other header's functions are called: the linker would keep one copy of such a
// function for all files, and that might have instructions that the processor lacks.
#pragma once

#include "models/fit/kernels.h"

namespace flinch::models {
namespace {

/// kWidth floats in one register.
template <std::size_t kWidth>
struct Lanes {
  typedef float Vector __attribute__((vector_size(kWidth * sizeof(float))));

  static Vector load(const float* from) {
    Vector vector;
    __builtin_memcpy(&vector, from, sizeof vector);
    return vector;
  }
  static void store(const Vector& vector, float* to) {
    __builtin_memcpy(to, &vector, sizeof vector);
  }
};

/// The tile of kVectors * kWidth rows and kColumns columns of c += a b, which stays in registers
/// over the whole depth.
template <std::size_t kWidth, std::size_t kVectors, std::size_t kColumns>
void add_tile(const ProductShape& shape, const float* a, const float* b, float* c) {
  using L = Lanes<kWidth>;
  typename L::Vector sums[kColumns][kVectors];
  for (std::size_t j = 0; j < kColumns; ++j)
    for (std::size_t v = 0; v < kVectors; ++v)
      sums[j][v] = L::load(c + j * shape.rows + v * kWidth);
  for (std::size_t k = 0; k < shape.depth; ++k) {
    typename L::Vector column[kVectors];
    for (std::size_t v = 0; v < kVectors; ++v) column[v] = L::load(a + k * shape.rows + v * kWidth);
    for (std::size_t j = 0; j < kColumns; ++j)
      for (std::size_t v = 0; v < kVectors; ++v)
        sums[j][v] += column[v] * b[k * shape.b_row + j * shape.b_column];
  }
  for (std::size_t j = 0; j < kColumns; ++j)
    for (std::size_t v = 0; v < kVectors; ++v)
      L::store(sums[j][v], c + j * shape.rows + v * kWidth);
}

/// kVectors * kWidth rows of c += a b.
template <std::size_t kWidth, std::size_t kVectors>
void add_rows(const ProductShape& shape, const float* a, const float* b, float* c) {
  constexpr std::size_t kColumns = 4;
  std::size_t j = 0;
  for (; j + kColumns <= shape.columns; j += kColumns)
    add_tile<kWidth, kVectors, kColumns>(shape, a, b + j * shape.b_column, c + j * shape.rows);
  for (; j < shape.columns; ++j)
    add_tile<kWidth, kVectors, 1>(shape, a, b + j * shape.b_column, c + j * shape.rows);
}

template <std::size_t kWidth>
void add_product(const ProductShape& shape, const float* a, const float* b, float* c) {
  std::size_t i = 0;
  for (; i + 2 * kWidth <= shape.rows; i += 2 * kWidth) add_rows<kWidth, 2>(shape, a + i, b, c + i);
  for (; i < shape.rows; i += kWidth) add_rows<kWidth, 1>(shape, a + i, b, c + i);
}

/// Adds the upper half of the sums to the lower half, until one is left.
template <std::size_t kWidth, std::size_t kVectors>
float sum_by_halves(const typename Lanes<kWidth>::Vector (&sums)[kVectors]) {
  using L = Lanes<kWidth>;
  if constexpr (kVectors > 1) {
    typename L::Vector half[kVectors / 2];
    for (std::size_t v = 0; v < kVectors / 2; ++v) half[v] = sums[v] + sums[v + kVectors / 2];
    return sum_by_halves<kWidth>(half);
  } else if constexpr (kWidth > 4) {
    float lanes[kWidth];
    L::store(sums[0], lanes);
    using Half = Lanes<kWidth / 2>;
    const typename Half::Vector halves[2] = {Half::load(lanes), Half::load(lanes + kWidth / 2)};
    return sum_by_halves<kWidth / 2>(halves);
  } else {
    return (sums[0][0] + sums[0][2]) + (sums[0][1] + sums[0][3]);
  }
}

template <std::size_t kWidth>
float dot(std::size_t count, const float* x, const float* y) {
  using L = Lanes<kWidth>;
  constexpr std::size_t kVectors = kPartialSums / kWidth;
  typename L::Vector sums[kVectors];
#pragma GCC unroll 8
  for (std::size_t v = 0; v < kVectors; ++v) sums[v] = typename L::Vector{};
  std::size_t i = 0;
  for (; i + kPartialSums <= count; i += kPartialSums)
    for (std::size_t v = 0; v < kVectors; ++v)
      sums[v] += L::load(x + i + v * kWidth) * L::load(y + i + v * kWidth);
  if (i < count) {  // one block, half as many as there are partial sums
    for (std::size_t v = 0; v < kKernelBlock / kWidth; ++v)
      sums[v] += L::load(x + i + v * kWidth) * L::load(y + i + v * kWidth);
  }
  return sum_by_halves<kWidth>(sums);
}

template <std::size_t kWidth>
void add_scaled(std::size_t count, float factor, const float* x, float* y) {
  using L = Lanes<kWidth>;
  for (std::size_t i = 0; i < count; i += kWidth)
    L::store(L::load(y + i) + L::load(x + i) * factor, y + i);
}

/// Left to the compiler, which has vectors of square roots.
void adamw_step(const AdamWStep& step, std::size_t count, const float* __restrict gradient,
                float* __restrict mean, float* __restrict square, float* __restrict weights) {
  for (std::size_t i = 0; i < count; ++i) {
    const float g = gradient[i];
    mean[i] += step.mean_gain * (g - mean[i]);
    square[i] += step.square_gain * (g * g - square[i]);
    weights[i] = step.kept * weights[i] -
                 step.rate * mean[i] / (step.root_scale * __builtin_sqrtf(square[i]) + 1e-8F);
  }
}

template <std::size_t kWidth>
constexpr Kernels make_kernels(const char* instruction_set) {
  return {instruction_set, add_product<kWidth>, dot<kWidth>, add_scaled<kWidth>, adamw_step};
}

}  // namespace
}  // namespace flinch::models
