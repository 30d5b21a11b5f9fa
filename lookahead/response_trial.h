// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>

#include "lookahead/figure_lag.h"
#include "lookahead/response_reference.h"
#include "sim/encounter/encounter.h"

namespace flinch::lookahead {

/// What a ball does to a character that plays a response.
struct TrialResult {
  motion::PerBody<double> impulse;  ///< as in sim::SimulationResult, N·s
  double damage_ns = 0;
  /// Time of the first contact, s after perception; infinite if there is none.
  double first_contact_s = std::numeric_limits<double>::infinity();
  int steps = 0;        ///< simulated; 0 where it passes at a distance, or is cut before
  bool is_cut = false;  ///< stopped because the damage exceeded what was asked for
};

/// Simulates balls against responses, each from shortly before it may touch, with the figure, the
/// steps and the laws of training. What training takes from an undisturbed run of the whole
/// response is approximated here: the figure starts kSettlingSteps before the contact where it is
/// if it has followed the response for a while (FigureLag), and its motors settle in these steps.
/// Where more than one body is hit, it starts kLongSettlingSteps before.
///
/// Allocates when it is made and never after. A trial leaves nothing behind: equal calls give equal
/// bits.
class ResponseTrial {
 public:
  /// `figure_model` must outlive this. `reach_m` is features::CollisionFigure::reach_m.
  ResponseTrial(const sim::FigureModel& figure_model, double reach_m);

  /// Makes the character play `response`, which must be valid; `rate_hz` is the library's.
  void follow(const runtime::Response& response, float rate_hz) {
    reference_.follow(response, rate_hz);
  }

  /// Simulates `ball`, as it is at perception, until `until_s` after perception. Stops as soon as
  /// the damage exceeds `max_damage_ns`, and does not begin if the first hit must
  /// (least_first_hit); the result's damage is then a lower bound. `vulnerability` is v_b.
  TrialResult meet(const features::Ball& ball, double until_s,
                   const motion::PerBody<double>& vulnerability,
                   double max_damage_ns = std::numeric_limits<double>::infinity());

  static constexpr int kSettlingSteps = 2;
  static constexpr int kLongSettlingSteps = 10;

 private:
  struct Conditions {
    const features::Ball& ball;  ///< at perception
    double until_s = 0;
    const motion::PerBody<double>& vulnerability;
    double max_damage_ns = 0;
  };
  struct Clear {
    std::size_t frames = 0;
    sim::BodySet threatened = 0;  ///< the parts that a ball may come near before the next frame
  };

  std::optional<std::size_t> find_near(const features::Ball& ball, double until_s);
  bool stays_clear(const features::Ball& ball, double now_s, double time_s, double until_s);
  std::size_t clear_frames(const features::Ball& ball, std::size_t frame, double since_s,
                           double distance_m);
  Clear clear_of_parts(const features::Ball& ball, std::size_t frame, double since_s,
                       double distance_m);
  bool comes_near(const features::Ball& ball, std::size_t frame, double since_s, double distance_m,
                  sim::BodySet bodies);
  motion::PerBody<sim::BodyState> start_at(double time_s, const sim::ReferenceState& now);
  void settle(int near_step, int steps);
  TrialResult run(int near_step, int settling, const Conditions& conditions, bool first_hit);

  sim::SimulationOptions options_;
  const sim::FigureModel& figure_model_;
  double reach_m_;
  ResponseReference reference_;
  FigureLag lag_;
  sim::Encounter<sim::TreeScene> encounter_;
};

}  // namespace flinch::lookahead
