// SPDX-License-Identifier: MIT
#include "models/fit/kernels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tests/models/fit/kernel_sets.h"

namespace flinch::models {
namespace {

using Floats = std::vector<float>;

Floats random_floats(std::mt19937_64& random, std::size_t count) {
  std::uniform_real_distribution<float> uniform(-2, 2);
  Floats floats(count);
  for (float& value : floats) value = uniform(random);
  return floats;
}

/// The definition, element by element.
void add_product(const ProductShape& shape, const Floats& a, const Floats& b, Floats& c) {
  for (std::size_t j = 0; j < shape.columns; ++j)
    for (std::size_t i = 0; i < shape.rows; ++i)
      for (std::size_t k = 0; k < shape.depth; ++k)
        c[j * shape.rows + i] += a[k * shape.rows + i] * b[k * shape.b_row + j * shape.b_column];
}

float dot(const Floats& x, const Floats& y) {
  std::array<float, kPartialSums> sums{};
  for (std::size_t i = 0; i < x.size(); ++i) sums[i % kPartialSums] += x[i] * y[i];
  for (std::size_t half = kPartialSums / 2; half > 0; half /= 2)
    for (std::size_t i = 0; i < half; ++i) sums[i] += sums[i + half];
  return sums[0];
}

TEST(Kernels, AreThereForEveryProcessorAndTheWidestAreUsed) {
  const auto sets = kernel_sets();
  ASSERT_NE(kernels_for(InstructionSet::baseline), nullptr);
  EXPECT_EQ(&widest_kernels(), sets.back());
}

TEST(Kernels, ProductsHaveTheBitsOfTheDefinition) {
  for (const Kernels* kernels : kernel_sets()) {
    SCOPED_TRACE(kernels->instruction_set);
    std::mt19937_64 random(1);
    for (const std::size_t rows : {16U, 32U, 48U, 64U}) {
      for (std::size_t columns = 0; columns < 10; ++columns) {
        for (const std::size_t depth : {0U, 1U, 7U, 32U}) {
          const bool is_transposed = columns % 2 == 0;
          const ProductShape shape{.rows = rows,
                                   .columns = columns,
                                   .depth = depth,
                                   .b_row = is_transposed ? 1 : columns,
                                   .b_column = is_transposed ? depth : 1};
          const Floats a = random_floats(random, rows * depth);
          const Floats b = random_floats(random, depth * columns);
          Floats c = random_floats(random, rows * columns);
          Floats expected = c;
          add_product(shape, a, b, expected);
          kernels->add_product(shape, a.data(), b.data(), c.data());
          ASSERT_EQ(c, expected) << rows << " rows, " << columns << " columns, depth " << depth;
        }
      }
    }
  }
}

TEST(Kernels, DotProductsHaveTheBitsOfTheDefinition) {
  for (const Kernels* kernels : kernel_sets()) {
    SCOPED_TRACE(kernels->instruction_set);
    std::mt19937_64 random(2);
    for (std::size_t count = 0; count <= 160; count += kKernelBlock) {
      const Floats x = random_floats(random, count);
      const Floats y = random_floats(random, count);
      ASSERT_EQ(kernels->dot(count, x.data(), y.data()), dot(x, y)) << count << " elements";
    }
  }
}

TEST(Kernels, ScaledSumsHaveTheBitsOfTheDefinition) {
  for (const Kernels* kernels : kernel_sets()) {
    SCOPED_TRACE(kernels->instruction_set);
    std::mt19937_64 random(3);
    const Floats x = random_floats(random, 48);
    Floats y = random_floats(random, 48);
    Floats expected = y;
    for (std::size_t i = 0; i < x.size(); ++i) expected[i] += 0.3F * x[i];
    kernels->add_scaled(x.size(), 0.3F, x.data(), y.data());
    EXPECT_EQ(y, expected);
  }
}

TEST(Kernels, AdamWStepsHaveTheBitsOfTheDefinition) {
  const AdamWStep step{
      .mean_gain = 0.1F, .square_gain = 0.001F, .rate = 0.03F, .root_scale = 31.6F, .kept = 0.99F};
  for (const Kernels* kernels : kernel_sets()) {
    SCOPED_TRACE(kernels->instruction_set);
    std::mt19937_64 random(4);
    constexpr std::size_t kCount = 51;  // no multiple of any vector
    Floats mean(kCount);
    Floats square(kCount);
    Floats weights = random_floats(random, kCount);
    Floats m = mean;
    Floats v = square;
    Floats w = weights;
    for (int t = 0; t < 3; ++t) {
      const Floats gradient = random_floats(random, kCount);
      for (std::size_t i = 0; i < kCount; ++i) {
        m[i] += step.mean_gain * (gradient[i] - m[i]);
        v[i] += step.square_gain * (gradient[i] * gradient[i] - v[i]);
        w[i] = step.kept * w[i] - step.rate * m[i] / (step.root_scale * std::sqrt(v[i]) + 1e-8F);
      }
      kernels->adamw_step(step, kCount, gradient.data(), mean.data(), square.data(),
                          weights.data());
      ASSERT_EQ(mean, m);
      ASSERT_EQ(square, v);
      ASSERT_EQ(weights, w);
    }
  }
}

}  // namespace
}  // namespace flinch::models
