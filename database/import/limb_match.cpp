// SPDX-License-Identifier: MIT
#include "database/import/limb_match.h"

#include <algorithm>
#include <cmath>

namespace flinch::database {
namespace {

using motion::Role;

// Scores are in units of NameFit.
constexpr double kGivenByUser = 4;
constexpr double kUnnamed = 0.25;         // a joint without a known name, rather than none
constexpr double kPerJointBetween = 0.5;  // subtracted
constexpr double kNamedDifferently = 1;   // subtracted, per role of two mirrored limbs
constexpr double kOnOneSideOnly = 2;      // subtracted, per role of two mirrored limbs
constexpr double kLengthWeight = 4;       // times the squared logarithm of the ratio's excess
constexpr double kFreeRatio = 1.8;        // a factor up to which lengths say nothing
constexpr double kWorstRatio = 4;
constexpr double kSameLength = 1.5;     // a factor up to which mirrored bones count as equal
constexpr double kApart = 0.02;         // of the limb's length: the least between mirrored limbs
constexpr std::size_t kMostPairs = 24;  // chains of a side that are compared with the other's

bool is_limb_name(const PlainName& name) {
  for (const LimbRoles& roles : {kLeftArm, kRightArm, kLeftLeg, kRightLeg}) {
    for (Role role : roles) {
      if (fit_of(name, role) != NameFit::none) return true;
    }
  }
  return false;
}

// A joint that continues another: "upperarm02" below "upperarm01", "thigh.L.001" below "thigh.L".
bool continues(const NamedTree& figure, int joint) {
  const PlainName& name = figure.names[static_cast<std::size_t>(joint)];
  for (int above = figure.tree.parent(joint); above != kNoJoint;
       above = figure.tree.parent(above)) {
    const PlainName& other = figure.names[static_cast<std::size_t>(above)];
    if (other.side == name.side && other.stem == name.stem && !other.is_helper) return true;
  }
  return false;
}

class ChainFinder {
 public:
  ChainFinder(const NamedTree& figure, const LimbRoles& roles) : figure_(figure), roles_(roles) {
    for (int joint = 0; joint < figure.tree.count(); ++joint) {
      for (std::size_t i = 0; i < roles.size(); ++i) {
        const NameFit fit = fit_of(name(joint), roles[i]);
        if (fit == NameFit::none || continues(figure, joint)) continue;
        // "leg" is not the thigh below an "upleg".
        if (fit == NameFit::likely && hangs_from_exact(joint, roles[i])) continue;
        named_[i].push_back({joint, fit});
      }
    }
  }

  // The chains, the best first.
  std::vector<LimbMatch> chains() {
    extend({}, 0, 0, true);
    std::ranges::stable_sort(found_, std::ranges::greater(), &LimbMatch::score);
    if (found_.size() > kMostPairs) found_.resize(kMostPairs);
    return found_;
  }

 private:
  struct Named {
    int joint;
    NameFit fit;
  };

  const PlainName& name(int joint) const { return figure_.names[static_cast<std::size_t>(joint)]; }

  bool hangs_from_exact(int joint, Role role) const {
    for (int above = figure_.tree.parent(joint); above != kNoJoint;
         above = figure_.tree.parent(above)) {
      if (fit_of(name(above), role) == NameFit::exact) return true;
    }
    return false;
  }

  // Takes a joint for each role from `i` on; `above` is the index of the last role that has one.
  // `is_certain` is false while the last joint is one of several without a known name.
  void extend(const LimbMatch& chain, std::size_t i, std::size_t above, bool is_certain) {
    if (i == roles_.size()) {
      if (is_certain) finish(chain);
      return;
    }
    const Role role = roles_[i];
    if (figure_.given[role] != kNoJoint) {
      take(chain, i, above, figure_.given[role], RoleSource::override_, kGivenByUser, true);
      return;
    }
    const int last = chain.joint[above];
    const bool below_unnamed = last != kNoJoint && chain.source[above] == RoleSource::topology &&
                               !is_limb_name(name(last));
    for (const Named& named : named_[i]) {
      const bool by_name = named.fit != NameFit::possible;
      // Nothing but a name that fits says which joint an unnamed one above it is.
      if (!by_name && below_unnamed) continue;
      take(chain, i, above, named.joint, by_name ? RoleSource::name : RoleSource::topology,
           static_cast<double>(named.fit), true);
    }
    if (chain.joint[above] != kNoJoint) take_unnamed(chain, i, above, is_certain);
    if (!is_required(role)) extend(chain, i + 1, above, is_certain);
  }

  void take(LimbMatch chain, std::size_t i, std::size_t above, int joint, RoleSource source,
            double score, bool is_certain) {
    const int upper = chain.joint[above];
    if (upper != kNoJoint) {
      if (joint == upper || !figure_.tree.hangs_from(joint, upper)) return;
      const bool both_given =
          source == RoleSource::override_ && chain.source[above] == RoleSource::override_;
      for (int between : figure_.tree.between(upper, joint)) {
        if (figure_.tree.coincide(between, upper) || figure_.tree.coincide(between, joint))
          continue;
        if (!both_given &&
            !needs_no_role(figure_, between, {roles_[above], upper}, {roles_[i], joint}))
          return;
        score -= kPerJointBetween;
      }
    }
    chain.joint[i] = joint;
    chain.source[i] = source;
    chain.score += score;
    extend(chain, i + 1, i, is_certain);
  }

  // Whether a joint below this one has a name for the role `i`: then this one has another role.
  bool has_named_below(std::size_t i, int joint) const {
    return std::ranges::any_of(named_[i], [&](const Named& named) {
      return named.fit != NameFit::possible && figure_.tree.hangs_from(named.joint, joint);
    });
  }

  void take_unnamed(const LimbMatch& chain, std::size_t i, std::size_t above, bool is_certain) {
    std::vector<int> below = figure_.tree.next_below(chain.joint[above]);
    for (std::size_t at = 0; at < below.size();) {
      if (!name(below[at]).is_helper) {
        ++at;
        continue;
      }
      const std::vector<int> next = figure_.tree.next_below(below[at]);
      below.erase(below.begin() + static_cast<std::ptrdiff_t>(at));
      below.insert(below.end(), next.begin(), next.end());
    }
    for (int joint : below) {
      const NameSide side = name(joint).side;
      if (is_limb_name(name(joint)) || (side != NameSide::none && side != side_of(roles_[i]))) {
        continue;
      }
      if (has_named_below(i, joint)) continue;
      take(chain, i, above, joint, RoleSource::topology, kUnnamed, is_certain && below.size() == 1);
    }
  }

  // The length of the bone of the role `i`, to the next role's joint; nothing without either.
  double length(const LimbMatch& chain, std::size_t i) const {
    if (chain.joint[i] == kNoJoint || chain.joint[i + 1] == kNoJoint) return 0;
    return figure_.tree.distance(chain.joint[i], chain.joint[i + 1]);
  }

  void finish(LimbMatch chain) {
    const bool is_given =
        std::ranges::find(chain.source, RoleSource::override_) != chain.source.end();
    const bool is_leg = roles_[0] == Role::left_thigh || roles_[0] == Role::right_thigh;
    const double upper = length(chain, is_leg ? 0 : 1);
    const double lower = length(chain, is_leg ? 1 : 2);
    const double expected = is_leg ? kThighPerShin : kUpperArmPerForearm;
    const bool has_lower = chain.joint[is_leg ? 2 : 3] != kNoJoint;
    if (!is_given) {
      if (has_lower && !is_human_ratio(upper, lower, expected)) return;
      // The ball of the foot is nearer to the ankle than the knee is.
      if (is_leg && length(chain, 2) > lower) return;
    }
    if (has_lower && upper > 0 && lower > 0) {
      const double excess = std::abs(std::log(upper / lower / expected)) - std::log(kFreeRatio);
      chain.score -= kLengthWeight * std::pow(std::max(excess, 0.0), 2);
    }
    found_.push_back(chain);
  }

  const NamedTree& figure_;
  const LimbRoles& roles_;
  std::array<std::vector<Named>, 4> named_;
  std::vector<LimbMatch> found_;
};

bool is_same_length(double one, double other) {
  return std::max(one, other) <= kSameLength * std::min(one, other);
}

// What the score of two limbs loses because they are not mirror images.
double asymmetry(const NamedTree& figure, const LimbMatch& left, const LimbMatch& right) {
  double lost = 0;
  for (std::size_t i = 0; i < left.joint.size(); ++i) {
    const bool both = left.joint[i] != kNoJoint && right.joint[i] != kNoJoint;
    if (!both) {
      if (left.joint[i] != right.joint[i]) lost += kOnOneSideOnly;
      continue;
    }
    const auto one = static_cast<std::size_t>(left.joint[i]);
    const auto other = static_cast<std::size_t>(right.joint[i]);
    if (figure.names[one].stem != figure.names[other].stem) lost += kNamedDifferently;
    if (i == 0 || left.joint[i - 1] == kNoJoint || right.joint[i - 1] == kNoJoint) continue;
    if (!is_same_length(figure.tree.distance(left.joint[i - 1], left.joint[i]),
                        figure.tree.distance(right.joint[i - 1], right.joint[i]))) {
      lost += kOnOneSideOnly;
    }
  }
  return lost;
}

// Two hips, or two shoulders, cannot be at one place: such joints are above the limbs.
bool begin_apart(const NamedTree& figure, const LimbRoles& roles, const LimbMatch& left,
                 const LimbMatch& right) {
  const std::size_t first = roles[0] == Role::left_thigh ? 0 : 1;
  if (left.source[first] == RoleSource::override_ || right.source[first] == RoleSource::override_) {
    return true;
  }
  const double length = figure.tree.distance(left.joint[first], left.joint[first + 1]);
  return figure.tree.distance(left.joint[first], right.joint[first]) > kApart * length;
}

}  // namespace

bool is_human_ratio(double upper, double lower, double expected) {
  if (upper <= 0 || lower <= 0) return false;
  return std::abs(std::log(upper / lower / expected)) <= std::log(kWorstRatio);
}

bool needs_no_role(const NamedTree& figure, int joint, const RoleJoint& upper,
                   const RoleJoint& lower) {
  const auto named = [&figure](int one) { return figure.names[static_cast<std::size_t>(one)]; };
  if (figure.tree.coincide(joint, upper.joint) || figure.tree.coincide(joint, lower.joint)) {
    return true;
  }
  const PlainName name = named(joint);
  const PlainName above = named(upper.joint);
  if (name.is_helper || (name.side == above.side && name.stem == above.stem)) return true;
  const NameFit fit = fit_of(name, upper.role);
  return fit >= NameFit::likely && fit >= fit_of(name, lower.role) &&
         fit_of(above, upper.role) >= NameFit::likely;
}

std::pair<LimbMatch, LimbMatch> match_limbs(const NamedTree& figure, const LimbRoles& left,
                                            const LimbRoles& right) {
  const std::vector<LimbMatch> lefts = ChainFinder(figure, left).chains();
  const std::vector<LimbMatch> rights = ChainFinder(figure, right).chains();
  std::pair<LimbMatch, LimbMatch> best;
  double best_score = 0;
  for (const LimbMatch& one : lefts) {
    for (const LimbMatch& other : rights) {
      const double score = one.score + other.score - asymmetry(figure, one, other);
      if (best.first.found() && score <= best_score) continue;
      if (!begin_apart(figure, left, one, other)) continue;
      best = {one, other};
      best_score = score;
    }
  }
  if (rights.empty() && !lefts.empty()) best.first = lefts.front();
  if (lefts.empty() && !rights.empty()) best.second = rights.front();
  return best;
}

}  // namespace flinch::database
