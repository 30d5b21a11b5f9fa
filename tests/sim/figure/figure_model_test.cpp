// SPDX-License-Identifier: MIT
#include "sim/figure/figure_model.h"

#include <gmock/gmock.h>
#include <ode/mass.h>

#include "motion/default_character.h"

namespace flinch::sim {
namespace {

using motion::Body;

/// ODE's inertia of a body of uniform density, in the axes of its shape.
Eigen::Matrix3d inertia_by_ode(const motion::Shape& shape, double mass_kg) {
  dMass mass;
  if (shape.kind == motion::Shape::Kind::capsule) {
    dMassSetCapsuleTotal(&mass, mass_kg, 3, double{shape.radius}, 2 * double{shape.half_length});
  } else {
    const Eigen::Vector3d sides = 2 * shape.half_extents.cast<double>();
    dMassSetBoxTotal(&mass, mass_kg, sides.x(), sides.y(), sides.z());
  }
  Eigen::Matrix3d inertia;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) inertia(row, column) = mass.I[4 * row + column];
  }
  return inertia;
}

TEST(FigureModel, InertiasAreThoseOfTheReferenceEngine) {
  const motion::Physique character = motion::default_character();
  const FigureModel figure_model(character);
  for (Body body : motion::kBodies) {
    SCOPED_TRACE(name_of(body));
    const motion::BodyProperties& properties = figure_model.model[body];
    const Eigen::Matrix3d turn = properties.shape.orientation.cast<double>().toRotationMatrix();
    const Eigen::Matrix3d expected =
        turn * inertia_by_ode(properties.shape, double{properties.mass_kg}) * turn.transpose();
    EXPECT_LT((figure_model.inertia[body] - expected).norm(), 1e-6 * expected.norm());
    EXPECT_GT(expected.norm(), 0);
  }
}

}  // namespace
}  // namespace flinch::sim
