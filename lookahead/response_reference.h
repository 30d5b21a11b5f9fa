// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "runtime/response/response.h"
#include "sim/figure/figure_model.h"
#include "sim/figure/reference.h"

namespace flinch::lookahead {

/// The motion of a response as the figure follows it: what sim::Reference gives for the response's
/// poses at the library's rate, but evaluated only where it is asked for. Allocates nothing.
class ResponseReference {
 public:
  /// `figure_model` must outlive this.
  explicit ResponseReference(const sim::FigureModel& figure_model) : figure_model_(figure_model) {}

  /// Follows another response, which must be valid. `rate_hz` is the library's.
  void follow(const runtime::Response& response, float rate_hz);

  double rate_hz() const { return double{rate_hz_}; }
  /// Until when the response certainly does what idling does, s after perception.
  double idles_until_s() const {
    return response_.inertialization.is_zero ? double{response_.first_motion_s} : 0;
  }
  /// The state `time_s` after perception, at least 0; the time is faster to ask for the nearer it
  /// is to the last.
  sim::ReferenceState at(double time_s);
  /// The bodies then; their velocities mean nothing.
  motion::PerBody<sim::BodyState> places_at(double time_s);
  /// The same at frame `k`. Valid until another frame is asked for that is kFrames - 2 or more
  /// away.
  const motion::PerBody<sim::BodyState>& places_at_frame(std::size_t k) {
    return placed(k).state.body;
  }
  /// A body at frame `k`, with the velocity that takes it straight to where it is at the next
  /// frame; and the angular velocity that does, which is dearer to find.
  sim::BodyState moving_part(std::size_t k, motion::Body body);
  Eigen::Vector3d turn_rate(std::size_t k, motion::Body body);
  /// The position of the pelvis joint at frame `k`, world, m.
  Eigen::Vector3d pelvis_at(std::size_t k) { return frame(k).pose.root_position.cast<double>(); }

  static constexpr std::size_t kFrames = 24;  ///< that are kept

 private:
  struct Frame {
    std::size_t number = kNone;
    bool has_places = false;
    bool has_velocities = false;
    motion::Pose pose;
    sim::ReferenceState state;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// Frame `k` with its pose; with its bodies' places; with their velocities too.
  Frame& frame(std::size_t k);
  Frame& placed(std::size_t k);
  const sim::ReferenceState& moving_at(std::size_t k);
  /// The frame at that time, if there is one.
  std::optional<std::size_t> frame_at(double time_s) const;

  const sim::FigureModel& figure_model_;
  runtime::Response response_;
  float rate_hz_ = 1;
  std::array<Frame, kFrames> frames_;  ///< frame k is in element k modulo kFrames
};

}  // namespace flinch::lookahead
