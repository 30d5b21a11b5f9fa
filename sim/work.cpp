// SPDX-License-Identifier: MIT
#include "sim/work.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flinch::sim {
namespace {

constexpr double kCutoffHz = 12;

/// Positions of one point at a fixed rate, m.
using Path = std::vector<Eigen::Vector3d>;

/// A second-order low-pass, y_k = b0 x_k + b1 x_(k-1) + b2 x_(k-2) - a1 y_(k-1) - a2 y_(k-2).
struct LowPass {
  double b0, b1, b2, a1, a2;
};

// Butterworth by the bilinear transform: with K = tan(pi fc / fs) and the poles' 1/Q = sqrt(2),
//
//   n = 1 + sqrt(2) K + K^2,  b = K^2/n (1, 2, 1),  a1 = 2 (K^2 - 1)/n,  a2 = (1 - sqrt(2) K +
//   K^2)/n
LowPass butterworth(double cutoff_hz, double rate_hz) {
  const double k = std::tan(std::numbers::pi * cutoff_hz / rate_hz);
  const double n = 1 + std::numbers::sqrt2 * k + k * k;
  const double b = k * k / n;
  return {b, 2 * b, b, 2 * (k * k - 1) / n, (1 - std::numbers::sqrt2 * k + k * k) / n};
}

/// One pass in place, from the state of having rested at the first value for ever.
template <class Iterator>
void filter(const LowPass& pass, Iterator begin, Iterator end) {
  Eigen::Vector3d x1 = *begin;
  Eigen::Vector3d x2 = x1;
  Eigen::Vector3d y1 = x1;
  Eigen::Vector3d y2 = x1;
  for (Iterator value = begin; value != end; ++value) {
    const Eigen::Vector3d x = *value;
    const Eigen::Vector3d y =
        pass.b0 * x + pass.b1 * x1 + pass.b2 * x2 - pass.a1 * y1 - pass.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    *value = y;
  }
}

// Reflecting each end about its value, 2 x_0 - x_k, keeps position and velocity there, so that the
// filter starts and ends without a transient.
Path extended(const Path& path, std::ptrdiff_t count) {
  Path result;
  result.reserve(path.size() + 2 * static_cast<std::size_t>(count));
  for (std::ptrdiff_t k = count; k > 0; --k) {
    result.push_back(2 * path.front() - path[static_cast<std::size_t>(k)]);
  }
  result.insert(result.end(), path.begin(), path.end());
  for (std::ptrdiff_t k = 1; k <= count; ++k) {
    result.push_back(2 * path.back() - *(path.end() - 1 - k));
  }
  return result;
}

/// W = sum |m a_k . ds_k| with ds_k = (x_(k+1) - x_(k-1)) / 2: the trapezoidal share of pose k.
double work_along(const Path& path, double mass_kg, double rate_hz) {
  double work = 0;
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    const Eigen::Vector3d acceleration =
        (path[k + 1] - 2 * path[k] + path[k - 1]) * rate_hz * rate_hz;
    work += std::abs(mass_kg * acceleration.dot(path[k + 1] - path[k - 1]) / 2);
  }
  return work;
}

}  // namespace

std::vector<Eigen::Vector3d> low_passed(const std::vector<Eigen::Vector3d>& path, double rate_hz) {
  if (path.size() < 2 || rate_hz <= 2 * kCutoffHz) return path;  // nothing above the cut-off
  const LowPass pass = butterworth(kCutoffHz, rate_hz);
  // Half a second is six periods of the cut-off: transients are gone.
  const auto reach = std::min<std::ptrdiff_t>(std::lround(rate_hz / 2), std::ssize(path) - 1);
  Path smooth = extended(path, reach);
  filter(pass, smooth.begin(), smooth.end());
  filter(pass, smooth.rbegin(), smooth.rend());
  return {smooth.begin() + reach, smooth.end() - reach};
}

motion::PerBody<double> mechanical_work(const motion::Character& character,
                                        const motion::Motion& motion) {
  motion::PerBody<double> work;
  if (motion.poses.size() < 4) return work;
  const motion::BodyModel model = motion::make_body_model(character);
  motion::PerBody<Path> paths;
  for (const motion::Pose& pose : motion.poses) {
    const motion::JointFrames frames = motion::forward_kinematics(character.skeleton, pose);
    for (motion::Body body : motion::kBodies) {
      paths[body].push_back(motion::centre_of_mass(model, frames, body).cast<double>());
    }
  }
  const double rate_hz = motion.rate_hz;
  for (motion::Body body : motion::kBodies) {
    work[body] = work_along(low_passed(paths[body], rate_hz),
                            static_cast<double>(model[body].mass_kg), rate_hz);
  }
  return work;
}

}  // namespace flinch::sim
