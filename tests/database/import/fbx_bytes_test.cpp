// SPDX-License-Identifier: MIT
#include "database/import/fbx_bytes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace flinch::database {
namespace {

std::string number_bytes(std::uint32_t number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

std::string text(const std::string& value) {
  return "S" + number_bytes(static_cast<std::uint32_t>(value.size())) + value;
}

std::string whole(std::int32_t value) {
  return "I" + number_bytes(static_cast<std::uint32_t>(value));
}

std::string real(double value) {
  return "D" + std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string property(const std::string& name, const std::string& numbers) {
  return "\x01P" + text(name) + text("a type") + text("a label") + text("") + numbers;
}

std::string node(const std::string& name) {
  return "L12345678" + text(name + std::string("\0\1Model", 7)) + text("LimbNode");
}

// As binary files have them, without what stands around.
std::string binary() {
  return property("RotationActive", whole(1)) + node("Hips") + property("RotationOrder", whole(6)) +
         node("Spine") + property("PreRotation", real(0) + real(0) + real(-0.5)) +
         property("RotationActive", whole(0)) + node("");
}

// The same, as text.
constexpr const char* kText = R"(
  P: "RotationActive", "bool", "", "",1
  Model: 1, "Model::Hips", "LimbNode" {
    P: "RotationOrder", "enum", "", "",6
  }
  Model: 2, "Model::Spine", "LimbNode" {
    P: "PreRotation", "Vector3D", "Vector", "",0,0,-0.5
    P: "RotationActive", "bool", "", "",0
  }
  Model: 3, "Model::", "LimbNode" {
  }
)";

void expect_rules(const std::vector<FbxRotationRules>& rules) {
  ASSERT_EQ(rules.size(), 4U);
  EXPECT_TRUE(rules[0].is_active);
  EXPECT_EQ(rules[1].name, "Hips");
  EXPECT_FALSE(rules[1].has_euler_order());
  EXPECT_TRUE(rules[1].is_active);
  EXPECT_EQ(rules[2].name, "Spine");
  EXPECT_TRUE(rules[2].has_euler_order());
  EXPECT_FALSE(rules[2].is_active);
  EXPECT_TRUE(rules[2].is_turned_else);
  EXPECT_EQ(rules[3].name, "");
  EXPECT_TRUE(rules[3].is_active);
  EXPECT_FALSE(rules[3].is_turned_else);
}

TEST(FbxBytes, SayWhatRotatesHowInTextAndInBinary) {
  expect_rules(fbx_rotation_rules(kText));
  expect_rules(fbx_rotation_rules(binary()));
}

TEST(FbxBytes, MayEndAnywhere) {
  for (const std::string& file : {binary(), std::string(kText)}) {
    for (std::size_t size = 0; size < file.size(); ++size) {
      for (std::size_t from : {std::size_t{0}, size / 2}) {
        const std::string part = file.substr(from, size - from);
        EXPECT_GE(fbx_rotation_rules(part).size(), 1U);
        EXPECT_FALSE(has_animation_layers(part));
      }
    }
  }
}

TEST(FbxBytes, TellLayersFromStacks) {
  const std::string stack = "\"AnimStack::a\"";
  const std::string layer = "\"AnimLayer::a\"";
  EXPECT_FALSE(has_animation_layers(stack + layer + stack + layer));
  EXPECT_TRUE(has_animation_layers(stack + layer + layer));
  const std::string binary_stack = text(std::string("a\0\1AnimStack", 12));
  const std::string binary_layer = text(std::string("a\0\1AnimLayer", 12));
  EXPECT_FALSE(has_animation_layers(binary_stack + binary_layer));
  EXPECT_TRUE(has_animation_layers(binary_stack + binary_layer + binary_layer));
}

}  // namespace
}  // namespace flinch::database
