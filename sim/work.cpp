// SPDX-License-Identifier: MIT
#include "sim/work.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flinch::sim {
namespace {

constexpr double kCutoffHz = 12;

/// Positions of one or more points, one column per point, at a fixed rate, m.
template <class Positions>
using Path = std::vector<Positions>;
using CentresOfMass = Eigen::Matrix<double, 3, motion::kBodyCount>;

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

/// One pass, starting from rest at the first value.
template <class In, class Out>
void filter(const LowPass& pass, In begin, In end, Out out) {
  const auto* x1 = &*begin;
  const auto* x2 = x1;
  const auto* y1 = x1;
  const auto* y2 = x1;
  for (In x = begin; x != end; ++x, ++out) {
    *out = pass.b0 * *x + pass.b1 * *x1 + pass.b2 * *x2 - pass.a1 * *y1 - pass.a2 * *y2;
    x2 = x1;
    x1 = &*x;
    y2 = y1;
    y1 = &*out;
  }
}

// Reflecting each end about its value, 2 x_0 - x_k, preserves position and velocity there, so that
// the filter starts and ends without a transient.
template <class Positions>
Path<Positions> extended(const Path<Positions>& path, std::ptrdiff_t count) {
  Path<Positions> result;
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

template <class Positions>
Path<Positions> smoothed(const Path<Positions>& path, double rate_hz) {
  // The rate cannot carry frequencies above the cut-off.
  if (path.size() < 2 || rate_hz <= 2 * kCutoffHz) return path;
  const LowPass pass = butterworth(kCutoffHz, rate_hz);
  // Half a second is six periods of the cut-off, enough for transients to decay.
  const auto reach = std::min<std::ptrdiff_t>(std::lround(rate_hz / 2), std::ssize(path) - 1);
  Path<Positions> smooth = extended(path, reach);
  Path<Positions> forwards(smooth.size());
  filter(pass, smooth.begin(), smooth.end(), forwards.begin());
  filter(pass, forwards.rbegin(), forwards.rend(), smooth.rbegin());
  smooth.erase(smooth.end() - reach, smooth.end());
  smooth.erase(smooth.begin(), smooth.begin() + reach);
  return smooth;
}

/// W = sum |m a_k . ds_k| with ds_k = (x_(k+1) - x_(k-1)) / 2: the trapezoidal share of pose k.
double work_along(const Path<CentresOfMass>& path, Eigen::Index body, double mass_kg,
                  double rate_hz) {
  double work = 0;
  for (std::size_t k = 1; k + 1 < path.size(); ++k) {
    const Eigen::Vector3d before = path[k - 1].col(body);
    const Eigen::Vector3d after = path[k + 1].col(body);
    const Eigen::Vector3d acceleration =
        (after - 2 * path[k].col(body) + before) * rate_hz * rate_hz;
    work += std::abs(mass_kg * acceleration.dot(after - before) / 2);
  }
  return work;
}

}  // namespace

std::vector<Eigen::Vector3d> low_pass_filtered(const std::vector<Eigen::Vector3d>& path,
                                               double rate_hz) {
  return smoothed(path, rate_hz);
}

motion::PerBody<double> mechanical_work(const motion::Physique& character,
                                        const motion::Motion& motion) {
  motion::PerBody<double> work;
  if (motion.poses.size() < 4) return work;
  const motion::BodyModel model = motion::make_body_model(character);
  Path<CentresOfMass> path(motion.poses.size());  // all bodies at once: filtered side by side
  for (std::size_t k = 0; k < path.size(); ++k) {
    const motion::JointFrames frames =
        motion::forward_kinematics(character.skeleton, motion.poses[k]);
    for (motion::Body body : motion::kBodies) {
      path[k].col(static_cast<Eigen::Index>(body)) =
          motion::centre_of_mass(model, frames, body).cast<double>();
    }
  }
  const double rate_hz = motion.rate_hz;
  const Path<CentresOfMass> smooth = smoothed(path, rate_hz);
  for (motion::Body body : motion::kBodies) {
    work[body] = work_along(smooth, static_cast<Eigen::Index>(body),
                            static_cast<double>(model[body].mass_kg), rate_hz);
  }
  return work;
}

}  // namespace flinch::sim
