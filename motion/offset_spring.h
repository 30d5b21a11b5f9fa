// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace flinch::motion {

/// The spring that takes an offset to zero (Arikan, Forsyth and O'Brien 2005, equation 1):
///
///     x'' = K_s x + K_d x',   K_s = -50 1/s^2,   K_d = -10 1/s,
///
/// in closed form. The roots are -5 +- 5i 1/s, so with a = 5 1/s
///
///     x(t) = e^(-a t) (x_0 cos a t + (v_0 + a x_0) / a sin a t),
///     v(t) = e^(-a t) (v_0 cos a t - (v_0 + 2 a x_0) sin a t).
///
/// x(t) is x_0 times `position` plus v_0 times `velocity`; `rate` has the same for v(t).
struct OffsetSpring {
  float position = 1;
  float velocity = 0;
  struct Rate {
    float position = 0;
    float velocity = 1;
  } rate;
};

/// a, 1/s.
inline constexpr float kOffsetSpringRate = 5;

/// The factors `time_s` after the offset was x_0 with the velocity v_0; `time_s` is at least 0.
inline OffsetSpring offset_spring(float time_s) {
  const float a = kOffsetSpringRate;
  const float decay = std::exp(-a * time_s);
  const float cosine = decay * std::cos(a * time_s);
  const float sine = decay * std::sin(a * time_s);
  return {cosine + sine, sine / a, {-2 * a * sine, cosine - sine}};
}

}  // namespace flinch::motion
