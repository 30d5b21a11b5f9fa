// SPDX-License-Identifier: MIT
#include "sim/figure/figure_plan.h"

#include <ode/mass.h>

#include "sim/collision/pair_clearance.h"

namespace flinch::sim {
namespace {

using motion::Body;

// How fast the figure takes back what a motion or a hit has put it out of, rad/s: the tracking
// study of docs/simulation.md.
constexpr double kJointFrequency = 60;
constexpr double kPelvisFrequency = 60;

MovingShape outline_of(const motion::BodyProperties& properties) {
  MovingShape outline{features::outline_of(properties.shape)};
  outline.centre = (properties.shape.centre - properties.centre_of_mass).cast<double>();
  return outline;
}

/// Of a body of even density that fills its outline, about its own middle.
Eigen::Matrix3d inertia_of(const MovingShape& outline, double mass_kg) {
  dMass mass;
  if (outline.kind == motion::Shape::Kind::capsule) {
    dMassSetCapsuleTotal(&mass, mass_kg, 3, outline.radius, 2 * outline.half_length);
  } else {
    const Eigen::Vector3d sides = 2 * outline.half_extents;
    dMassSetBoxTotal(&mass, mass_kg, sides.x(), sides.y(), sides.z());
  }
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) inertia(i, i) = mass.I[4 * i + i];
  const Eigen::Matrix3d turn = outline.orientation.toRotationMatrix();
  return turn * inertia * turn.transpose();
}

bool carries(Body carrier, Body body) {
  for (std::optional<Body> at = body; at; at = parent_of(*at)) {
    if (*at == carrier) return true;
  }
  return false;
}

/// What a joint carries in the rest pose: the inertia about it of all bodies beyond it,
///   I = sum tr(I_i)/3 + m_i |c_i - p|^2.
double carried_inertia(const FigurePlan& plan, const motion::JointFrames& rest, Body joint) {
  const Eigen::Vector3d pivot = rest.position[role_of(joint)].cast<double>();
  double inertia = 0;
  for (Body body : motion::kBodies) {
    if (!carries(joint, body)) continue;
    const Eigen::Vector3d arm = centre_of_mass(plan.model, rest, body).cast<double>() - pivot;
    inertia += plan.inertia[body].trace() / 3 +
               static_cast<double>(plan.model[body].mass_kg) * arm.squaredNorm();
  }
  return inertia;
}

MovingShape placed(const MovingShape& outline, const Eigen::Vector3d& centre_of_mass) {
  MovingShape shape = outline;
  shape.centre += centre_of_mass;
  return shape;
}

}  // namespace

FigurePlan::FigurePlan(const motion::Character& character)
    : skeleton(character.skeleton), model(make_body_model(character)) {
  const motion::JointFrames rest = forward_kinematics(skeleton, rest_pose(skeleton));
  for (Body body : motion::kBodies) {
    const double body_mass_kg = static_cast<double>(model[body].mass_kg);
    outline[body] = outline_of(model[body]);
    outline_radius[body] = outline[body].bounding_radius();
    radius[body] = outline[body].centre.norm() + outline_radius[body];
    inertia[body] = inertia_of(outline[body], body_mass_kg);
    kinds[body] = kind_of(body);
    limits[body] = limits_of(body);
    mass_kg += body_mass_kg;
  }
  for (Body body : motion::kBodies) {
    const bool root = !parent_of(body);
    gains[body] = critically_damped(carried_inertia(*this, rest, body),
                                    root ? kPelvisFrequency : kJointFrequency);
  }
  pelvis_gains = critically_damped(mass_kg, kPelvisFrequency);

  motion::PerBody<MovingShape> shapes;
  for (Body body : motion::kBodies) {
    shapes[body] = placed(outline[body], centre_of_mass(model, rest, body).cast<double>());
  }
  for (Body first : motion::kBodies) {
    for (Body second : motion::kBodies) {
      const bool jointed = parent_of(first) == second || parent_of(second) == first;
      if (first != second && !jointed && clearance(shapes[first], shapes[second]).gap > 0) {
        may_touch[first] |= set_of(second);
      }
    }
  }
}

}  // namespace flinch::sim
