// SPDX-License-Identifier: MIT
#include "motion/de_leva.h"

namespace flinch::motion::de_leva {
namespace {

constexpr Table kFemale{
    .head_and_neck = {6.68F, 48.41F},
    .upper_trunk = {15.45F, 20.77F},
    .middle_trunk = {14.65F, 45.12F},
    .lower_trunk = {12.47F, 49.20F},
    .upper_arm = {2.55F, 57.54F},
    .forearm = {1.38F, 45.59F},
    .hand = {0.56F, 74.74F},
    .thigh = {14.78F, 36.12F},
    .shank = {4.81F, 43.52F},
    .foot = {1.29F, 40.14F},
    .knuckle_length = 78.0F / 170.1F,
};

constexpr Table kMale{
    .head_and_neck = {6.94F, 50.02F},
    .upper_trunk = {15.96F, 29.99F},
    .middle_trunk = {16.33F, 45.02F},
    .lower_trunk = {11.17F, 61.15F},
    .upper_arm = {2.71F, 57.72F},
    .forearm = {1.62F, 45.74F},
    .hand = {0.61F, 79.00F},
    .thigh = {14.16F, 40.95F},
    .shank = {4.33F, 43.95F},
    .foot = {1.37F, 44.15F},
    .knuckle_length = 86.2F / 187.9F,
};

}  // namespace

const Table& table(Sex sex) {
  return sex == Sex::female ? kFemale : kMale;
}

}  // namespace flinch::motion::de_leva
