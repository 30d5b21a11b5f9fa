// SPDX-License-Identifier: MIT
#include "database/import/role_guess.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "database/import/limb_match.h"

namespace flinch::database {
namespace {

using motion::PerRole;
using motion::Role;

constexpr double kEqualReach = 1.2;  // a factor up to which two branches can be mirrored limbs
// Of the bone between the inner end of the clavicle and the shoulder to the upper arm.
constexpr double kClaviclePerUpperArm = 0.45;
constexpr double kPerJointSkipped = 0.05;  // in squared logarithms of ratios
constexpr double kWithoutClavicle = 0.1;
constexpr double kWithoutHand = 0.3;
constexpr std::size_t kMostBranches = 8;  // below one joint, the longest first
constexpr std::size_t kMostBranchPairs = 64;

// Two branches that begin below one joint, and are about equally long.
struct BranchPair {
  int fork = kNoJoint;
  std::array<int, 2> first{kNoJoint, kNoJoint};  ///< the first joint of each
  double reach = 0;                              ///< of the shorter, from the fork
};

class Guesser {
 public:
  Guesser(const JointTree& tree, const std::vector<PlainName>& names) : tree_(tree), names_(names) {
    reach_.resize(static_cast<std::size_t>(tree.count()));
    for (int joint = tree.count() - 1; joint >= 0; --joint) {
      double& reach = reach_[static_cast<std::size_t>(joint)];
      reach = std::max(reach, tree.end_site(joint).norm());
      const int above = tree.parent(joint);
      if (above == kNoJoint) continue;
      double& reach_above = reach_[static_cast<std::size_t>(above)];
      reach_above = std::max(reach_above, reach + tree.distance(above, joint));
    }
    for (Role role : motion::kRoles) roles_[role] = kNoJoint;
  }

  std::optional<PerRole<int>> guess() {
    if (!find_pairs()) return std::nullopt;
    roles_[Role::pelvis] = legs_.fork;
    find_head();
    std::array<LimbMatch, 2> legs;
    std::array<LimbMatch, 2> arms;
    for (std::size_t i = 0; i < 2; ++i) {
      legs[i] = leg(path(legs_.first[i]));
      arms[i] = arm(path(arms_.first[i]));
      if (!legs[i].found() || !arms[i].found()) return std::nullopt;
    }
    const std::size_t left_leg = left_of(legs_, legs, legs);
    const std::size_t left_arm = left_of(arms_, arms, legs);
    for (std::size_t i = 0; i < 4; ++i) {
      roles_[kLeftLeg[i]] = legs[left_leg].joint[i];
      roles_[kRightLeg[i]] = legs[1 - left_leg].joint[i];
      roles_[kLeftArm[i]] = arms[left_arm].joint[i];
      roles_[kRightArm[i]] = arms[1 - left_arm].joint[i];
    }
    return roles_;
  }

 private:
  double reach(int joint) const { return reach_[static_cast<std::size_t>(joint)]; }
  const PlainName& name(int joint) const { return names_[static_cast<std::size_t>(joint)]; }

  // The nearest joints below that have a length and are not named as helpers.
  std::vector<int> below(int joint) const {
    std::vector<int> all = tree_.next_below(joint);
    std::erase_if(all, [this](int child) { return name(child).is_helper && reach(child) <= 0; });
    return all;
  }

  // From a branch's first joint on, always the child that reaches farthest; without helpers.
  std::vector<int> path(int first) const {
    std::vector<int> joints;
    for (int at = first; at != kNoJoint;) {
      if (!name(at).is_helper) joints.push_back(at);
      int next = kNoJoint;
      double farthest = -1;
      for (int child : tree_.next_below(at)) {
        const double child_reach = tree_.distance(at, child) + reach(child);
        if (child_reach <= farthest) continue;
        farthest = child_reach;
        next = child;
      }
      at = next;
    }
    return joints;
  }

  std::vector<BranchPair> pairs() const {
    std::vector<BranchPair> found;
    for (int fork = 0; fork < tree_.count(); ++fork) {
      std::vector<int> branches = below(fork);
      const auto length = [this, fork](int branch) {
        return tree_.distance(fork, branch) + reach(branch);
      };
      std::ranges::stable_sort(branches, std::ranges::greater(), length);
      if (branches.size() > kMostBranches) branches.resize(kMostBranches);
      for (std::size_t i = 0; i < branches.size(); ++i) {
        for (std::size_t j = i + 1; j < branches.size(); ++j) {
          const double shorter = length(branches[j]);
          if (length(branches[i]) > kEqualReach * shorter) continue;
          found.push_back({fork, {branches[i], branches[j]}, shorter});
        }
      }
    }
    std::ranges::stable_sort(found, std::ranges::greater(), &BranchPair::reach);
    if (found.size() > kMostBranchPairs) found.resize(kMostBranchPairs);
    return found;
  }

  // The arms are above the legs: they branch off below a joint that is no part of a leg.
  bool can_be(const BranchPair& legs, const BranchPair& arms) const {
    if (!tree_.hangs_from(arms.fork, legs.fork)) return false;
    for (int leg : legs.first) {
      for (int arm : arms.first) {
        if (tree_.hangs_from(arm, leg)) return false;
      }
    }
    return path(legs.first[0]).size() >= 3 && path(arms.first[0]).size() >= 2;
  }

  bool find_pairs() {
    double longest = 0;
    const std::vector<BranchPair> all = pairs();
    for (const BranchPair& legs : all) {
      for (const BranchPair& arms : all) {
        if (legs.reach + arms.reach <= longest || !can_be(legs, arms)) continue;
        legs_ = legs;
        arms_ = arms;
        longest = legs.reach + arms.reach;
      }
    }
    return longest > 0;
  }

  // Neck and head run upwards from the arms' fork without a fork; the head is where that ends.
  void find_head() {
    int head = kNoJoint;
    for (int branch : below(arms_.fork)) {
      const bool is_other = branch != arms_.first[0] && branch != arms_.first[1] &&
                            !tree_.hangs_from(legs_.first[0], branch);
      if (is_other && (head == kNoJoint || reach(branch) > reach(head))) head = branch;
    }
    while (head != kNoJoint) {
      const std::vector<int> next = below(head);
      if (next.size() != 1 || name(next.front()).is_helper) break;
      head = next.front();
    }
    roles_[Role::head] = head;
  }

  LimbMatch leg(const std::vector<int>& joints) const {
    LimbMatch best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 2 < joints.size(); ++i) {
      const double cost =
          misfit(joints[i], joints[i + 1], joints[i + 2], kThighPerShin) + skipped(i);
      if (cost >= least) continue;
      least = cost;
      const int toes = i + 3 < joints.size() ? joints[i + 3] : kNoJoint;
      best.joint = {joints[i], joints[i + 1], joints[i + 2], toes};
    }
    return best;
  }

  LimbMatch arm(const std::vector<int>& joints) const {
    LimbMatch best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {  // i: the upper arm
      const bool has_hand = i + 2 < joints.size();
      const double lengths =
          has_hand ? misfit(joints[i], joints[i + 1], joints[i + 2], kUpperArmPerForearm)
                   : kWithoutHand;
      const int hand = has_hand ? joints[i + 2] : kNoJoint;
      if (const double cost = lengths + kWithoutClavicle + skipped(i); cost < least) {
        least = cost;
        best.joint = {kNoJoint, joints[i], joints[i + 1], hand};
      }
      if (i == 0) continue;
      const double cost = lengths + skipped(i - 1) +
                          misfit(joints[i - 1], joints[i], joints[i + 1], kClaviclePerUpperArm);
      if (cost >= least) continue;
      least = cost;
      best.joint = {joints[i - 1], joints[i], joints[i + 1], hand};
    }
    return best;
  }

  static double skipped(std::size_t joints) {
    return kPerJointSkipped * static_cast<double>(joints);
  }

  double misfit(int one, int two, int three, double expected) const {
    const double ratio = tree_.distance(one, two) / tree_.distance(two, three);
    return std::pow(std::log(ratio / expected), 2);
  }

  // Which of two mirrored branches is the left one: 0 or 1.
  std::size_t left_of(const BranchPair& pair, const std::array<LimbMatch, 2>& limbs,
                      const std::array<LimbMatch, 2>& legs) const {
    const int by_name = left_votes(pair.first[0]) - left_votes(pair.first[1]);
    if (by_name != 0) return by_name > 0 ? 0 : 1;
    const Eigen::Vector3d across =
        tree_.position(limbs[0].joint[1]) - tree_.position(limbs[1].joint[1]);
    return across.dot(leftward(legs)) >= 0 ? 0 : 1;
  }

  int left_votes(int branch) const {
    int votes = 0;
    for (int joint = branch; joint < tree_.count(); ++joint) {
      if (!tree_.hangs_from(joint, branch)) continue;
      if (name(joint).side == NameSide::left) ++votes;
      if (name(joint).side == NameSide::right) --votes;
    }
    return votes;
  }

  // left = up x forward
  Eigen::Vector3d leftward(const std::array<LimbMatch, 2>& legs) const {
    const int head = roles_[Role::head] == kNoJoint ? arms_.fork : roles_[Role::head];
    const Eigen::Vector3d up = tree_.position(head) - tree_.position(legs_.fork);
    Eigen::Vector3d forward = Eigen::Vector3d::Zero();
    for (const LimbMatch& limb : legs) {
      const int foot = limb.joint[2];
      const int toes = limb.joint[3];
      forward += toes == kNoJoint ? tree_.end_site(foot)
                                  : Eigen::Vector3d(tree_.position(toes) - tree_.position(foot));
    }
    return up.cross(forward);
  }

  const JointTree& tree_;
  const std::vector<PlainName>& names_;
  std::vector<double> reach_;  ///< per joint, the length of the longest path below it
  BranchPair legs_;
  BranchPair arms_;
  PerRole<int> roles_;
};

}  // namespace

std::optional<PerRole<int>> guess_roles(const JointTree& tree,
                                        const std::vector<PlainName>& names) {
  return Guesser(tree, names).guess();
}

}  // namespace flinch::database
