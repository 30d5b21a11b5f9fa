// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

#include "database/import/bvh.h"

namespace flinch::database {

/// The index that stands for no joint.
inline constexpr int kNoJoint = -1;

/// A file's joints as a tree with lengths: what mapping roles asks of them. Joints are given by
/// their index into Bvh::joints.
class JointTree {
 public:
  /// Where the first frame's position channels put a joint farther from its parent than its OFFSET
  /// does, they count: exporters that write both may leave the OFFSETs at zero.
  explicit JointTree(const Bvh& bvh);

  int count() const { return static_cast<int>(parent_.size()); }
  int parent(int joint) const { return parent_[index(joint)]; }
  const std::vector<int>& children(int joint) const { return children_[index(joint)]; }

  /// Where the joint is with all rotations zero, in the file's units and axes.
  const Eigen::Vector3d& position(int joint) const { return position_[index(joint)]; }

  /// The End Site that is farthest from the joint, relative to it; zero without any.
  const Eigen::Vector3d& end_site(int joint) const { return end_site_[index(joint)]; }

  double distance(int one, int other) const { return (position(one) - position(other)).norm(); }

  /// Whether two joints are at one position: nearer than 1e-6 of the figure's size.
  bool coincide(int one, int other) const { return distance(one, other) <= no_length_; }

  /// Whether `joint` is `ancestor` or below it.
  bool hangs_from(int joint, int ancestor) const;

  /// The joints between `upper` and `lower`, from `upper` downwards, without either. Nothing where
  /// `lower` is not below `upper`.
  std::vector<int> between(int upper, int lower) const;

  /// The lowest joint from which both hang; kNoJoint if there is none.
  int common_ancestor(int one, int other) const;

  /// The nearest joints below that are not at the joint's own position.
  std::vector<int> next_below(int joint) const;

 private:
  static std::size_t index(int joint) { return static_cast<std::size_t>(joint); }

  std::vector<int> parent_;
  std::vector<std::vector<int>> children_;
  std::vector<Eigen::Vector3d> position_;
  std::vector<Eigen::Vector3d> end_site_;
  double no_length_ = 0;
};

}  // namespace flinch::database
