// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <optional>

#include "evolve/genetic/evolution.h"
#include "evolve/pain/pain.h"
#include "evolve/trial/move_time.h"
#include "evolve/trial/pose_genes.h"
#include "evolve/trial/rehearsed_pose.h"
#include "evolve/trial/threat_grid.h"
#include "sim/rehearsal/simulator.h"

namespace flinch::evolve {

/// What a pose should look like beside hurting little.
enum class Style : std::uint8_t {
  free,   ///< whatever hurts least
  hands,  ///< the ball passes through the arms, so hands block (section 5.2.2)
  near,   ///< blocks near the middle of the aimed part
  far,    ///< blocks far from it
};
inline constexpr std::array kStyles{Style::free, Style::hands, Style::near, Style::far};
/// The name in options.
std::string_view name_of(Style style);

/// Which shoulders ignore the pose (section 4.1.3): they stay as they were, or hang limp.
enum class JointFailure : std::uint8_t { none, right_shoulder, left_shoulder, both_shoulders };
inline constexpr std::array kJointFailures{JointFailure::none, JointFailure::right_shoulder,
                                           JointFailure::left_shoulder,
                                           JointFailure::both_shoulders};

/// The test that every pose goes through (figure 4.1).
struct TrialOptions {
  AimedThrow thrown;
  ThreatGrid grid;
  Style style = Style::free;
  PainMap pain = thesis_pain();
  GeneMap gene_map = GeneMap::limits;
  bool fails_joints = true;  ///< all of kJointFailures, or none alone
  bool are_limp = false;     ///< whether failed shoulders have no torque, or stay as they were
  /// Terms that the thesis leaves to future work (sections 6.2.1 and 6.2.2), off by default: what a
  /// radian second beyond the limits of the struck joints costs, in shares of the pain of standing
  /// still, and how much more energy a torque takes that pulls the back of a hand.
  double limit_weight_per_rads = 0;
  double extension_weight = 0;
  double delay_s = 0.22;  ///< until the pose begins, t_delay: a human's reaction time
  double tail_s = 0.3;    ///< simulated time after the impact
  sim::SimulationOptions simulation;
  std::uint64_t seed = 1;
};

/// What a pose costs on average over its balls. Less is better.
struct PoseScore {
  double pain = 0;      ///< equation 4.2, N·s
  double energy = 0;    ///< equation 4.3, weighted, N·s
  double distance = 0;  ///< equation 4.4, weighted, N·s: negative for Style::far
  double overlap = 0;   ///< penalty for arms inside the body or each other, N·s
  double limits = 0;    ///< penalty for joints that a blow drives beyond their limits, N·s

  /// Equation 4.1, and the penalty: the thesis' boxes cannot overlap.
  double fitness() const { return pain + energy + distance + overlap + limits; }
};

/// Tests poses of one character against one throw. Immutable: several threads may use it.
class PoseTrial {
 public:
  /// Throws Error for a throw that the character cannot answer: slower than 5 m/s, or nearer in
  /// time than the delay.
  PoseTrial(const motion::Physique& character, const motion::Motion& idle,
            const TrialOptions& options);

  /// Tests chromosomes on the balls of draw `draw`, the same for all. Independent of `threads` and
  /// of what is remembered to the last bit. Returns nothing if `stop` became true first. With
  /// `remembered`, which may come from earlier tests of this trial, poses in it are not rehearsed
  /// again, and the others join it.
  std::optional<std::vector<PoseScore>> test(std::span<const Chromosome> chromosomes,
                                             std::uint64_t draw, int threads,
                                             const std::atomic<bool>* stop = nullptr,
                                             RehearsedPoses* remembered = nullptr) const;
  /// The same for standing still.
  PoseScore test_idle(std::uint64_t draw) const;
  /// Simulates balls of one failure of a pose.
  std::vector<sim::SimulationResult> simulate(const Chromosome& chromosome, JointFailure failure,
                                              std::span<const features::Ball> balls) const;
  /// The same with the reference simulation, from the start on for each ball.
  std::vector<sim::SimulationResult> simulate_by_reference(
      const Chromosome& chromosome, JointFailure failure,
      std::span<const features::Ball> balls) const;
  /// Mean pain of simulated balls, N·s.
  double mean_pain(std::span<const sim::SimulationResult> results) const;

  /// The balls of a draw.
  std::array<features::Ball, kGridCells> balls(std::uint64_t draw) const;
  motion::Pose pose(const Chromosome& chromosome) const;
  /// The degrees of freedom of a pose: pose_genes(), or those of FigureKind::waist_up.
  std::span<const PoseGene> genes() const;
  /// The motion of a test: idle until the delay, then eased to the pose, within human joint speeds.
  motion::Motion motion_to(const motion::Pose& pose, JointFailure failure) const;

  const motion::Figure& figure() const { return figure_; }
  const motion::Pose& start() const { return start_; }
  const TrialOptions& options() const { return options_; }
  /// Of figures without failures.
  const sim::Simulator& simulator() const { return simulators_.front(); }
  double duration_s() const { return options_.thrown.time_to_impact_s + options_.tail_s; }
  /// The pain of standing still, mean of the first draws, N·s: the unit of the other terms.
  double idle_pain() const { return idle_pain_; }

 private:
  using SharedPoses = std::vector<std::shared_ptr<const RehearsedPose>>;

  SharedPoses rehearse(std::span<const Chromosome> chromosomes) const;
  /// Those that are remembered, and the others rehearsed.
  SharedPoses rehearsed(std::span<const Chromosome> chromosomes,
                        const RehearsedPoses* remembered) const;
  /// Throws each ball at each failure of each pose.
  std::vector<PoseScore> test_batch(const SharedPoses& poses,
                                    std::span<const features::Ball> balls) const;
  void add_result(const sim::SimulationResult& result, PoseScore& score) const;
  std::span<const JointFailure> failures() const;
  /// The failures in groups that share a simulator.
  std::vector<std::span<const JointFailure>> failure_groups() const;
  const sim::Simulator& simulator_of(JointFailure failure) const;
  double effort_of(const sim::Rehearsal& rehearsal) const;
  std::vector<sim::SimulationResult> thrown_at(const motion::Motion& motion, JointFailure failure,
                                               std::span<const features::Ball> balls) const;
  double effort_of(const motion::Pose& pose) const;
  double overlap_penalty(const motion::Pose& pose) const;

  motion::Figure figure_;
  motion::Motion idle_;
  TrialOptions options_;
  std::vector<sim::Simulator>
      simulators_;              ///< one, or one for each failure that leaves joints limp
  motion::Pose start_;          ///< when the pose begins
  double energy_weight_ = 0;    ///< c_t, 1/s
  double distance_weight_ = 0;  ///< c_d, N s/m
  double idle_pain_ = 0;
};

/// Depth by which hands and forearms are inside head, neck and trunk, or those of the other arm, or
/// nearer to them than 5 mm, m; summed over the pairs.
double overlap_depth_m(const motion::Figure& figure, const motion::Pose& pose);

/// Returns the throw at the middle of a target of a character that idles.
AimedThrow throw_at(const motion::Physique& character, const motion::Motion& idle,
                    motion::Target target, double azimuth, double elevation, double speed_mps,
                    double time_to_impact_s);

}  // namespace flinch::evolve
