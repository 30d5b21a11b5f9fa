// SPDX-License-Identifier: MIT
#include "database/export/glb.h"

#include <gtest/gtest.h>

#include <numeric>

#include "glb_reader.h"

namespace flinch::database {
namespace {

std::vector<double> as_doubles(const auto& numbers) {
  return {numbers.begin(), numbers.end()};
}

TEST(Glb, AccessorsRoundTripAligned) {
  const std::vector<std::uint8_t> bytes{1, 2, 255};
  const std::vector<std::uint32_t> few{0, 1, 65534};
  const std::vector<std::uint32_t> many{0, 65535, 7};
  const std::vector<float> floats{-1.5F, 1e-30F, 3e38F, 0, 1, 2};
  GltfBuffer buffer;
  buffer.add(bytes, GltfElement::scalar, GltfTarget::none);
  buffer.add_indices(few);
  buffer.add_indices(many);
  buffer.add(floats, GltfElement::vec3, GltfTarget::vertices, true);
  buffer.add(bytes, GltfElement::scalar, GltfTarget::none);
  // The reader throws where a buffer view is not at a multiple of 4 bytes.
  const tests::Glb glb = tests::read_glb(buffer.file({{"asset", {{"version", "2.0"}}}}));
  EXPECT_EQ(tests::numbers_of(glb, 0), as_doubles(bytes));
  EXPECT_EQ(tests::numbers_of(glb, 1), as_doubles(few));
  EXPECT_EQ(tests::numbers_of(glb, 2), as_doubles(many));
  EXPECT_EQ(tests::numbers_of(glb, 3), as_doubles(floats));
  EXPECT_EQ(tests::numbers_of(glb, 4), as_doubles(bytes));
  const auto& accessors = glb.document["accessors"];
  EXPECT_EQ(accessors[1]["componentType"], 5123);  // 16 bits are enough
  EXPECT_EQ(accessors[2]["componentType"], 5125);  // 65535 is the 16-bit restart value
  EXPECT_EQ(accessors[3]["count"], 2);
  EXPECT_EQ(accessors[3]["min"], (std::vector<float>{-1.5F, 1e-30F, 2}));
  EXPECT_EQ(accessors[3]["max"], (std::vector<float>{0, 1, 3e38F}));
}

TEST(Glb, DocumentOfAnyLengthRoundTrips) {
  for (int length = 0; length < 8; ++length) {
    GltfBuffer buffer;
    buffer.add(std::vector<float>{1}, GltfElement::scalar);
    const std::string name(static_cast<std::size_t>(length), 'x');
    const tests::Glb glb = tests::read_glb(buffer.file({{"name", name}}));
    EXPECT_EQ(glb.document["name"], name);
    EXPECT_EQ(glb.document["buffers"][0]["byteLength"], 4);
  }
}

}  // namespace
}  // namespace flinch::database
