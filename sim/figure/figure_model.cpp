// SPDX-License-Identifier: MIT
#include "sim/figure/figure_model.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "sim/collision/pair_clearance.h"
#include "sim/figure/waist_up.h"

namespace flinch::sim {
namespace {

using motion::Body;

// Natural frequency at which the figure returns to its reference after a motion or a hit has
// displaced it, rad/s: the tracking study of docs/simulation.md.
constexpr double kJointFrequency = 60;
constexpr double kPelvisFrequency = 60;
constexpr double kLimitStiffnessRatio = 20;  // of the springs beyond a joint limit

MovingShape collision_shape_of(const motion::BodyProperties& properties) {
  MovingShape outline{motion::collision_shape_of(properties.shape)};
  outline.centre = (properties.shape.centre - properties.centre_of_mass).cast<double>();
  return outline;
}

// Inertia of shapes of uniform density, with V the volume and m the mass:
//
//   box of sides a, b, c:       I_x = m (b^2 + c^2) / 12, and so on
//   capsule along z, of radius r, whose cylinder is l long (volume V_1) and whose caps form a
//   sphere (volume V_2):        I_x = I_y = m / V (V_1 (r^2 / 4 + l^2 / 12)
//                                                 + V_2 (2 r^2 / 5 + 3 r l / 8 + l^2 / 4))
//                               I_z = m / V (V_1 / 2 + 2 V_2 / 5) r^2

Eigen::Vector3d box_inertia(const Eigen::Vector3d& sides, double mass_kg) {
  const Eigen::Vector3d squares = sides.cwiseAbs2();
  const double volume = sides.x() * sides.y() * sides.z();
  const Eigen::Vector3d per_density{volume / 12 * (squares.y() + squares.z()),
                                    volume / 12 * (squares.x() + squares.z()),
                                    volume / 12 * (squares.x() + squares.y())};
  return mass_kg / volume * per_density;
}

Eigen::Vector3d capsule_inertia(double r, double l, double mass_kg) {
  const double cylinder = std::numbers::pi * r * r * l;
  const double caps = 4.0 / 3.0 * std::numbers::pi * r * r * r;
  const double across = cylinder * (0.25 * r * r + 1.0 / 12.0 * l * l) +
                        caps * (0.4 * r * r + 0.375 * r * l + 0.25 * l * l);
  const double along = (cylinder * 0.5 + caps * 0.4) * r * r;
  return mass_kg / (cylinder + caps) * Eigen::Vector3d(across, across, along);
}

/// Inertia about its centre of a body that fills its outline, kg·m².
Eigen::Matrix3d inertia_of(const MovingShape& outline, double mass_kg) {
  const Eigen::Vector3d principal =
      outline.kind == motion::Shape::Kind::capsule
          ? capsule_inertia(outline.radius, 2 * outline.half_length, mass_kg)
          : box_inertia(2 * outline.half_extents, mass_kg);
  const Eigen::Matrix3d turn = outline.orientation.toRotationMatrix();
  return turn * principal.asDiagonal() * turn.transpose();
}

bool is_ancestor_or_self(Body ancestor, Body body) {
  for (std::optional<Body> at = body; at; at = parent_of(*at)) {
    if (*at == ancestor) return true;
  }
  return false;
}

MovingShape placed(const MovingShape& outline, const Eigen::Vector3d& centre_of_mass) {
  MovingShape shape = outline;
  shape.centre += centre_of_mass;
  return shape;
}

int free_axes_of(JointKind kind) {
  switch (kind) {
    case JointKind::ball:
      return 3;
    case JointKind::elbow:
    case JointKind::saddle:
      return 2;
    case JointKind::hinge:
      return 1;
    case JointKind::fixed:
      break;
  }
  return 0;
}

}  // namespace

double composite_inertia(const FigureModel& figure_model, const motion::JointFrames& rest,
                         Body joint) {
  const Eigen::Vector3d pivot = rest.position[role_of(joint)].cast<double>();
  double inertia = 0;
  for (Body body : motion::kBodies) {
    if (!is_ancestor_or_self(joint, body)) continue;
    const Eigen::Vector3d arm =
        centre_of_mass(figure_model.model, rest, body).cast<double>() - pivot;
    inertia += figure_model.inertia[body].trace() / 3 +
               static_cast<double>(figure_model.model[body].mass_kg) * arm.squaredNorm();
  }
  return inertia;
}

bool has_bone_axes(const FigureModel& figure_model, Body body) {
  return figure_model.kinds[body] == JointKind::saddle || figure_model.laws[body].twist_share != 1;
}

int bone_index(const JointRange& limits) {
  int index = 0;
  limits.bone.cwiseAbs().maxCoeff(&index);
  return index;
}

TreeConstants tree_constants(const FigureModel& figure_model) {
  static_assert(TreeConstants::kBodies == motion::kBodyCount);
  const auto copy = [](const auto& from, auto& to) { std::ranges::copy(from, to); };
  TreeConstants constants;
  for (Body body : motion::kBodies) {
    TreeConstants::Body& constant = constants.bodies[static_cast<std::size_t>(body)];
    constant.parent = static_cast<std::size_t>(parent_of(body).value_or(body));
    constant.mass_kg = static_cast<double>(figure_model.model[body].mass_kg);
    const Eigen::Matrix3d& inertia = figure_model.inertia[body];
    copy(std::array{inertia(0, 0), inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(0, 2),
                    inertia(1, 2)},
         constant.inertia);
    if (parent_of(body)) copy(joint_offset(figure_model, body), constant.joint);
    constant.free_axes = free_axes_of(figure_model.kinds[body]);
    copy(figure_model.hinge[body], constant.hinge);
    constant.stiffness = figure_model.gains[body].stiffness;
    constant.damping = figure_model.gains[body].damping;
    const JointRange& range = figure_model.limits[body];
    copy(range.reference.coeffs(), constant.range.reference);
    copy(range.bone, constant.range.bone);
    copy(range.min, constant.range.min);
    copy(range.max, constant.range.max);
    if (has_bone_axes(figure_model, body)) constant.bone = bone_index(range);
    const ServoLaw& law = figure_model.laws[body];
    constant.follows_velocity = law.follows_velocity;
    constant.twist_share = law.twist_share;
    constant.limit_stiffness = law.limit_stiffness;
    constant.limit_damping = law.limit_damping;
  }
  return constants;
}

Eigen::Vector3d joint_offset(const FigureModel& figure_model, Body body) {
  return -figure_model.model[body].centre_of_mass.cast<double>();
}

FigureModel::FigureModel(const motion::Physique& character, const SimulationOptions& options)
    : skeleton(character.skeleton),
      model(make_body_model(character)),
      ball_meets(options.ball_meets) {
  const bool is_waist_up = options.figure == FigureKind::waist_up;
  if (is_waist_up) model = with_uniform_density(model);
  const motion::JointFrames rest = forward_kinematics(skeleton, rest_pose(skeleton));
  for (Body body : motion::kBodies) {
    const double body_mass_kg = static_cast<double>(model[body].mass_kg);
    outline[body] = collision_shape_of(model[body]);
    outline_radius[body] = outline[body].bounding_radius();
    radius[body] = outline[body].centre.norm() + outline_radius[body];
    inertia[body] = inertia_of(outline[body], body_mass_kg);
    kinds[body] = kind_of(body);
    hinge[body] = hinge_axis(kinds[body]);
    limits[body] = limits_of(body);
    mass_kg += body_mass_kg;
  }
  for (Body body : motion::kBodies) {
    const bool root = !parent_of(body);
    gains[body] = critically_damped(composite_inertia(*this, rest, body),
                                    root ? kPelvisFrequency : kJointFrequency);
  }
  pelvis_gains = critically_damped(mass_kg, kPelvisFrequency);
  for (Body body : motion::kBodies)
    laws[body].limit_stiffness = kLimitStiffnessRatio * gains[body].stiffness;
  if (is_waist_up) make_waist_up(*this);
  for_each_body(options.limp_joints, [&](Body body) { gains[body] = {}; });

  motion::PerBody<MovingShape> shapes;
  for (Body body : motion::kBodies) {
    shapes[body] = placed(outline[body], centre_of_mass(model, rest, body).cast<double>());
  }
  for (Body first : motion::kBodies) {
    for (Body second : motion::kBodies) {
      const bool jointed = parent_of(first) == second || parent_of(second) == first;
      if (first != second && !jointed && clearance(shapes[first], shapes[second]).gap > 0) {
        may_collide[first] |= set_of(second);
      }
    }
  }
  tree = tree_constants(*this);
}

Eigen::Vector3d sole_point(const MovingShape& foot, double forward, double left) {
  return foot.centre +
         foot.orientation * foot.half_extents.cwiseProduct(Eigen::Vector3d(forward, left, -1));
}

}  // namespace flinch::sim
