// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace flinch::models {

/// Counts of rows and elements that kernels accept are multiples of this.
inline constexpr std::size_t kKernelBlock = 16;

/// Floats that are aligned as the widest vectors are: kernels read them fastest.
struct alignas(kKernelBlock * sizeof(float)) KernelBlock {
  std::array<float, kKernelBlock> values{};
};
inline float* floats_of(std::vector<KernelBlock>& blocks) {
  return reinterpret_cast<float*>(blocks.data());
}
inline const float* floats_of(const std::vector<KernelBlock>& blocks) {
  return reinterpret_cast<const float*>(blocks.data());
}

/// Partial sums of a dot product.
inline constexpr std::size_t kPartialSums = 32;

/// Sizes of the product of two matrices of floats, c += a b.
struct ProductShape {
  std::size_t rows = 0;  ///< of a and c, whose columns are contiguous; a multiple of kKernelBlock
  std::size_t columns = 0;   ///< of b and c
  std::size_t depth = 0;     ///< columns of a, rows of b
  std::size_t b_row = 0;     ///< elements from one row of b to the next
  std::size_t b_column = 0;  ///< elements from one column of b to the next
};

/// Factors of a step of AdamW, in which weight w with the gradient g becomes w':
///   m' = m + mean_gain (g - m),   v' = v + square_gain (g^2 - v),
///   w' = kept w - rate m' / (root_scale sqrt(v') + 1e-8).
struct AdamWStep {
  float mean_gain = 0;
  float square_gain = 0;
  float rate = 0;
  float root_scale = 0;
  float kept = 0;
};

/// The arithmetic on which fitting spends its time, compiled for one instruction set. All sets give
/// the same bits: each result is one fixed sequence of rounded products and sums, and the set only
/// decides how many results are computed at once. Arrays must not overlap; they need no alignment.
struct Kernels {
  const char* instruction_set;

  /// For each row i and column j adds a(i, k) b(k, j) to c(i, j), from k = 0 to depth - 1.
  void (*add_product)(const ProductShape& shape, const float* a, const float* b, float* c);

  /// Returns x.y. Product i is added to partial sum i % kPartialSums, in ascending order; then the
  /// upper half of the partial sums is added to the lower half, until one is left. `count` is a
  /// multiple of kKernelBlock.
  float (*dot)(std::size_t count, const float* x, const float* y);

  /// y += factor x. `count` is a multiple of kKernelBlock.
  void (*add_scaled)(std::size_t count, float factor, const float* x, float* y);

  /// Takes a step with `count` weights w; `mean` and `square` hold m and v.
  void (*adamw_step)(const AdamWStep& step, std::size_t count, const float* gradient, float* mean,
                     float* square, float* weights);
};

/// Instruction sets that Kernels are compiled for, narrowest first.
enum class InstructionSet { baseline, avx2, avx512 };

/// Returns the kernels for an instruction set, or null where this processor does not have it.
const Kernels* kernels_for(InstructionSet set);

/// Returns the kernels for the widest vectors that this processor has.
const Kernels& widest_kernels();

}  // namespace flinch::models
