// SPDX-License-Identifier: MIT
#include "database/import/joint_tree.h"

#include <algorithm>

namespace flinch::database {
namespace {

// fraction of the figure's size: joints nearer than this coincide
constexpr double kCoincide = 1e-6;

Eigen::Vector3d from_parent(const Bvh& bvh, const BvhJoint& joint) {
  if (joint.parent == kNoJoint || bvh.frame_count == 0) return joint.offset;
  Eigen::Vector3d moved = joint.offset;
  for (std::size_t i = 0; i < joint.channels.size(); ++i) {
    const int axis = static_cast<int>(joint.channels[i]);
    if (axis < 3) moved[axis] = bvh.values[static_cast<std::size_t>(joint.first_channel) + i];
  }
  return moved.norm() > joint.offset.norm() ? moved : joint.offset;
}

Eigen::Vector3d farthest(const std::vector<Eigen::Vector3d>& end_sites) {
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& site : end_sites) {
    if (site.norm() > best.norm()) best = site;
  }
  return best;
}

}  // namespace

JointTree::JointTree(const Bvh& bvh) : children_(bvh.joints.size()) {
  double size = 0;
  for (const BvhJoint& joint : bvh.joints) {
    const int own = count();
    parent_.push_back(joint.parent);
    position_.push_back(from_parent(bvh, joint));
    end_site_.push_back(farthest(joint.end_sites));
    if (joint.parent == kNoJoint) continue;
    children_[index(joint.parent)].push_back(own);
    position_.back() += position(joint.parent);
    size = std::max(size, distance(own, 0));
  }
  no_length_ = kCoincide * size;
}

bool JointTree::hangs_from(int joint, int ancestor) const {
  while (joint != kNoJoint && joint != ancestor) joint = parent(joint);
  return joint == ancestor;
}

std::vector<int> JointTree::between(int upper, int lower) const {
  if (!hangs_from(lower, upper) || lower == upper) return {};
  std::vector<int> path;
  for (int at = parent(lower); at != upper; at = parent(at)) path.push_back(at);
  std::reverse(path.begin(), path.end());
  return path;
}

int JointTree::common_ancestor(int one, int other) const {
  while (one != kNoJoint && !hangs_from(other, one)) one = parent(one);
  return one;
}

std::vector<int> JointTree::next_below(int joint) const {
  std::vector<int> open = children(joint);
  std::vector<int> found;
  for (std::size_t i = 0; i < open.size(); ++i) {
    const int at = open[i];
    if (!coincide(at, joint)) {
      found.push_back(at);
    } else {
      open.insert(open.end(), children(at).begin(), children(at).end());
    }
  }
  return found;
}

}  // namespace flinch::database
