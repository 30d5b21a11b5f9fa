// SPDX-License-Identifier: MIT
#include "sim/tree/tree_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#include "sim/tree/joint_tree.h"
#include "tests/sim/tree/random_step.h"

namespace flinch::sim {
namespace {

/// What a step of one figure starts from.
struct Start {
  motion::PerBody<BodyState> now;
  ReferenceState target;
  double step_s = 0;
  Drive drive;
  motion::PerBody<Twist> impulses;
};

/// All numbers of one lane, those that are read too.
template <std::size_t kLanes>
std::vector<double> lane_of(const TreeLanes<kLanes>& lanes, std::size_t lane) {
  static_assert(sizeof lanes % sizeof(typename TreeLanes<kLanes>::Values) == 0);
  const auto* all = reinterpret_cast<const double*>(&lanes);
  std::vector<double> numbers;
  for (std::size_t i = lane; i < sizeof lanes / sizeof(double); i += kLanes) {
    numbers.push_back(all[i]);
  }
  return numbers;
}

class TreeLanesTest : public testing::TestWithParam<FigureKind> {
 protected:
  /// Steps of figures that are driven in all the ways there are.
  std::vector<Start> starts(std::size_t count, unsigned seed) const {
    RandomStep random(figure_model_, seed);
    std::vector<Start> result;
    for (std::size_t i = 0; i < count; ++i) {
      Start start;
      start.target = random.state(random.uniform(0, 1.5));
      start.now = random.disturbed(start.target).body;
      start.step_s = random.uniform(1e-5, 1.0 / 30);
      start.drive.strength.joints = random.uniform(0.1, 1);
      start.drive.foot_hold = i % 3 == 0 ? 1 : 0;
      start.drive.is_falling = i % 5 == 0;
      for (Twist& impulse : start.impulses) impulse = {random.vector(1), random.vector(1)};
      result.push_back(start);
    }
    return result;
  }

  template <std::size_t kLanes>
  void put(const Start& start, TreeLanes<kLanes>& lanes, std::size_t lane) const {
    JointTree(figure_model_)
        .put_step(
            {start.now, start.target, start.step_s, 9.81, start.drive, kAllBodies, start.impulses},
            lanes, lane);
  }

  std::vector<double> step_alone(const Start& start) const {
    auto lanes = std::make_unique<TreeLanes<1>>();
    put(start, *lanes, 0);
    factor_trees(figure_model_.tree, *lanes);
    move_figures(figure_model_.tree, *lanes);
    return lane_of(*lanes, 0);
  }

  /// Steps all starts, kLanes at a time, and passes each one's numbers to `check`.
  template <std::size_t kLanes, class Check>
  void step_side_by_side(const std::vector<Start>& starts, Check check) const {
    auto lanes = std::make_unique<TreeLanes<kLanes>>();
    for (std::size_t first = 0; first + kLanes <= starts.size(); first += kLanes) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) put(starts[first + lane], *lanes, lane);
      factor_trees(figure_model_.tree, *lanes);
      move_figures(figure_model_.tree, *lanes);
      for (std::size_t lane = 0; lane < kLanes; ++lane) check(first + lane, lane_of(*lanes, lane));
    }
  }

  /// The same for each number of lanes that this processor has.
  template <class Check>
  void step_in_all_widths(const std::vector<Start>& starts, Check check) const {
    step_side_by_side<2>(starts, check);
#ifdef __x86_64__
    if (widest_lanes() >= 4) step_side_by_side<4>(starts, check);
    if (widest_lanes() >= 8) step_side_by_side<8>(starts, check);
#endif
  }

  FigureModel figure_model_{
      motion::default_character(),
      {.figure = GetParam(), .limp_joints = set_of(motion::Body::right_upper_arm)}};
};

bool is_finite(const std::vector<double>& numbers) {
  // The softness of springs that are not there is infinite.
  return std::ranges::none_of(numbers, [](double number) { return std::isnan(number); });
}

bool has_same_bits(const std::vector<double>& first, const std::vector<double>& second) {
  return first.size() == second.size() &&
         std::memcmp(first.data(), second.data(), first.size() * sizeof(double)) == 0;
}

TEST_P(TreeLanesTest, EachLaneHasTheBitsOfAFigureAlone) {
  const std::vector<Start> all = starts(400, 21);
  std::vector<std::vector<double>> expected;
  for (const Start& start : all) {
    expected.push_back(step_alone(start));
    EXPECT_TRUE(is_finite(expected.back()));
  }
  std::size_t compared = 0;
  step_in_all_widths(all, [&](std::size_t i, const std::vector<double>& found) {
    ASSERT_TRUE(has_same_bits(found, expected[i])) << i;
    ++compared;
  });
  EXPECT_GE(compared, all.size());
}

// Every second figure has numbers that no simulation gives.
TEST_P(TreeLanesTest, BadNumbersStayInTheirLane) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::vector<Start> all = starts(80, 22);
  for (std::size_t i = 1; i < all.size(); i += 2) {
    Start& bad = all[i];
    switch (i / 2 % 6) {
      case 0:
        bad.now[motion::Body::chest].velocity.x() = kNan;
        break;
      case 1:
        bad.now[motion::Body::left_hand].position.z() = kInfinity;
        break;
      case 2:
        bad.target.body[motion::Body::head].orientation.coeffs().setConstant(kNan);
        break;
      case 3:
        for (BodyState& body : bad.now) body.position *= 1e12;
        break;
      case 4:
        bad.step_s = 0;
        break;
      default:
        bad.step_s = 1;
    }
  }
  int bad_lanes = 0;
  step_in_all_widths(all, [&](std::size_t i, const std::vector<double>& found) {
    if (i % 2 == 1) {
      bad_lanes += !is_finite(found);
    } else {
      ASSERT_TRUE(has_same_bits(found, step_alone(all[i]))) << i;
    }
  });
  EXPECT_GT(bad_lanes, 20);
}

INSTANTIATE_TEST_SUITE_P(Figures, TreeLanesTest,
                         testing::Values(FigureKind::people, FigureKind::waist_up));

}  // namespace
}  // namespace flinch::sim
