// SPDX-License-Identifier: MIT
#include "sim/ode/ode_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenes/allow_leaks.h"
#include "tests/scenes/error_of.h"
#include "tests/scenes/not_finite.h"

namespace flinch::sim {
namespace {

using testing::HasSubstr;

TEST(OdeWorld, AFailedStepIsAnErrorAndTheWorldIsNotTouchedAgain) {
  {
    const tests::AllowLeaks allow_leaks;  // ODE cannot free a world in the middle of a step
    OdeWorld world;
    const dBodyID body = dBodyCreate(world.id());
    world.step(0.01);
    dBodySetAngularVel(body, double{tests::kNan}, 0, 0);
    EXPECT_THAT(tests::error_of([&] { world.step(0.01); }), HasSubstr("physics engine failed"));
    EXPECT_EQ(world.id(), nullptr) << "it stays in memory";
    EXPECT_THAT(tests::error_of([&] { world.step(0.01); }), HasSubstr("failed before"));
  }
  OdeWorld other;  // is not affected
  other.step(0.01);
}

}  // namespace
}  // namespace flinch::sim
