// SPDX-License-Identifier: MIT
#include "database/import/source_figure.h"

#include <algorithm>
#include <vector>

namespace flinch::database {
namespace {

using motion::kRoles;
using motion::Role;

constexpr double kNoLength = 1e-6;  // file units: an End Site nearer than this is ignored

std::optional<Role> next_in_limb(Role role) {
  switch (role) {
    case Role::left_clavicle:
      return Role::left_upper_arm;
    case Role::left_upper_arm:
      return Role::left_forearm;
    case Role::left_forearm:
      return Role::left_hand;
    case Role::right_clavicle:
      return Role::right_upper_arm;
    case Role::right_upper_arm:
      return Role::right_forearm;
    case Role::right_forearm:
      return Role::right_hand;
    case Role::left_thigh:
      return Role::left_shin;
    case Role::left_shin:
      return Role::left_foot;
    case Role::left_foot:
      return Role::left_toes;
    case Role::right_thigh:
      return Role::right_shin;
    case Role::right_shin:
      return Role::right_foot;
    case Role::right_foot:
      return Role::right_toes;
    default:
      return std::nullopt;
  }
}

// Returns the joint's own End Site that is farthest from it.
std::optional<Landmark> own_end(const Bvh& bvh, int joint) {
  std::optional<Landmark> best;
  for (const Eigen::Vector3d& site : bvh.joints[static_cast<std::size_t>(joint)].end_sites) {
    if (site.norm() <= kNoLength || (best && site.norm() <= best->offset.norm())) continue;
    best = Landmark{joint, site};
  }
  return best;
}

// Returns the joint or End Site below a joint that is farthest from it when all rotations are zero.
std::optional<Landmark> farthest_end(const Bvh& bvh, int joint) {
  std::vector<Eigen::Vector3d> place(bvh.joints.size(), Eigen::Vector3d::Zero());
  std::vector<bool> below(bvh.joints.size(), false);
  below[static_cast<std::size_t>(joint)] = true;
  std::optional<Landmark> best;
  double farthest = kNoLength;
  for (std::size_t i = static_cast<std::size_t>(joint); i < bvh.joints.size(); ++i) {
    const BvhJoint& at = bvh.joints[i];
    if (static_cast<int>(i) != joint) {
      const auto parent = static_cast<std::size_t>(std::max(at.parent, 0));
      if (at.parent < 0 || !below[parent]) continue;
      below[i] = true;
      place[i] = place[parent] + at.offset;
      if (place[i].norm() > farthest) {
        farthest = place[i].norm();
        best = Landmark{static_cast<int>(i), Eigen::Vector3d::Zero()};
      }
    }
    for (const Eigen::Vector3d& site : at.end_sites) {
      if ((place[i] + site).norm() <= farthest) continue;
      farthest = (place[i] + site).norm();
      best = Landmark{static_cast<int>(i), site};
    }
  }
  return best;
}

std::optional<Landmark> end_of(const Bvh& bvh, const SourceFigure& figure, Role role) {
  if (!figure.has(role)) return std::nullopt;
  const std::optional<Role> next = next_in_limb(role);
  if (next && figure.has(*next)) return Landmark{figure.joint[*next], Eigen::Vector3d::Zero()};
  switch (role) {
    case Role::head:
      return own_end(bvh, figure.joint[role]);
    case Role::left_forearm:
    case Role::right_forearm:
    case Role::left_hand:
    case Role::right_hand:
    case Role::left_foot:
    case Role::right_foot:
    case Role::left_toes:
    case Role::right_toes:
      return farthest_end(bvh, figure.joint[role]);
    default:
      return std::nullopt;
  }
}

}  // namespace

SourceFigure source_figure(const Bvh& bvh, const RoleMap& roles) {
  SourceFigure figure;
  figure.joint = roles.joint;
  figure.carrier = roles.joint;
  for (Role role : kRoles) figure.end[role] = end_of(bvh, figure, role);
  return figure;
}

FigureFrame figure_frame(const SourceFigure& figure, const BvhFrame& frame,
                         const Eigen::Quaterniond& turn) {
  FigureFrame result;
  for (Role role : kRoles) {
    result.position[role].setZero();
    result.orientation[role].setIdentity();
    result.end[role].setZero();
    if (!figure.has(role)) continue;
    const auto joint = static_cast<std::size_t>(figure.joint[role]);
    result.position[role] = turn * frame.position[joint];
    const auto carried_by = static_cast<std::size_t>(figure.carrier[role]);
    result.orientation[role] = turn * frame.orientation[carried_by];
    if (!figure.end[role]) continue;
    const Landmark& end = *figure.end[role];
    const auto fixed_to = static_cast<std::size_t>(end.joint);
    result.end[role] = turn * (frame.position[fixed_to] + frame.orientation[fixed_to] * end.offset);
  }
  return result;
}

double leg_length(const FigureFrame& frame) {
  double sum = 0;
  for (Role role : {Role::left_thigh, Role::left_shin, Role::right_thigh, Role::right_shin}) {
    sum += (frame.end[role] - frame.position[role]).norm();
  }
  return 0.5 * sum;
}

Eigen::Vector3d hip_centre(const FigureFrame& frame) {
  return 0.5 * (frame.position[Role::left_thigh] + frame.position[Role::right_thigh]);
}

Eigen::Vector3d leftward(const FigureFrame& frame) {
  const Eigen::Vector3d hips = frame.position[Role::left_thigh] - frame.position[Role::right_thigh];
  const Eigen::Vector3d shoulders =
      frame.position[Role::left_upper_arm] - frame.position[Role::right_upper_arm];
  return (hips.normalized() + shoulders.normalized()).normalized();
}

std::optional<Role> parent_in(const SourceFigure& figure, Role role) {
  for (std::optional<Role> above = motion::parent_of(role); above;
       above = motion::parent_of(*above)) {
    if (figure.has(*above)) return above;
  }
  return std::nullopt;
}

}  // namespace flinch::database
