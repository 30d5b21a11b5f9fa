// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

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

  /// The state `time_s` after perception, at least 0; the time is faster to ask for the nearer it
  /// is to the last.
  sim::ReferenceState at(double time_s);
  /// The position of the pelvis joint at the frame before that time, world, m.
  Eigen::Vector3d pelvis_at(double time_s);

 private:
  struct Frame {
    std::size_t number = kNone;
    motion::Pose pose;
    sim::ReferenceState at_rest;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr std::size_t kFrames = 8;  ///< that are kept; at() takes four neighbours

  const Frame& frame(std::size_t k);
  /// The bodies with their velocities at frame `k`.
  motion::PerBody<sim::BodyState> bodies_at(std::size_t k);

  const sim::FigureModel& figure_model_;
  runtime::Response response_;
  float rate_hz_ = 1;
  std::array<Frame, kFrames> frames_;  ///< frame k is in element k modulo kFrames
};

}  // namespace flinch::lookahead
