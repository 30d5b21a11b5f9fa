// SPDX-License-Identifier: MIT
#include "sim/ode/ode_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenes/error_of.h"
#include "tests/scenes/not_finite.h"

namespace flinch::sim {
namespace {

using testing::HasSubstr;

TEST(OdeWorld, AFailedStepIsAnErrorAndTheWorldIsNotTouchedAgain) {
  static dWorldID left = nullptr;  // so that what stays in memory for good is no leak
  {
    OdeWorld world;
    left = world.id();
    const dBodyID body = dBodyCreate(world.id());
    world.step(0.01);
    dBodySetAngularVel(body, double{tests::kNan}, 0, 0);
    EXPECT_THAT(tests::error_of([&] { world.step(0.01); }), HasSubstr("physics engine failed"));
    EXPECT_EQ(world.id(), nullptr) << "ODE cannot free a world in the middle of a step";
    EXPECT_THAT(tests::error_of([&] { world.step(0.01); }), HasSubstr("failed before"));
  }
  EXPECT_NE(left, nullptr);
  OdeWorld other;  // is not affected
  other.step(0.01);
}

}  // namespace
}  // namespace flinch::sim
