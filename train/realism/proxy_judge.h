// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "motion/figure.h"
#include "train/realism/label_file.h"

namespace flinch::train {

/// Who judges where no one has: what files and reports call it.
inline constexpr std::string_view kProxyJudge = "proxy: measured bounds, not people";

/// What the proxy measures of a motion.
struct ProxyMeasures {
  float limit_excess_deg = 0;   ///< of joints beyond their human limits
  float support_drift_m = 0;    ///< slip of the support foot
  float below_ground_m = 0;     ///< deepest point of a sole
  float speed_share = 0;        ///< of joints, of their human peak speeds
  float acceleration_mps2 = 0;  ///< of any body's centre of mass
  float out_of_balance_m = 0;   ///< extrapolated centre of mass outside the soles (Hof et al. 2005)
};

/// Judges pushed motions by measures instead of people. Each measure costs nothing up to what the
/// recorded response itself has (or the bound of `flinch info --quality`, where that is more), and
/// everything where it exceeds that by 20 degrees, 30 mm, 20 mm, one human peak speed, the same
/// acceleration again, or 150 mm. In between Q falls linearly; the worst measure decides.
///
/// It proves nothing about what people see: it knows no style, no timing and no faces.
class ProxyJudge {
 public:
  /// Measures every response of the library, which must outlive this.
  explicit ProxyJudge(const runtime::PushResponses& responses);

  /// Q of an example, 0 to 1.
  float quality_of(const PushExample& example) const;
  /// What each measure alone would give, in the order of ProxyMeasures, 0 to 1.
  std::array<float, 6> scores_of(const PushExample& example) const;

 private:
  ProxyMeasures measured(const motion::Motion& motion) const;

  const runtime::PushResponses& responses_;
  motion::Figure figure_;
  std::vector<ProxyMeasures> recorded_;  // per response
};

/// Draws `count` examples and has the proxy judge them, in ten sittings of equal length: "proxy
/// SEED.0" to "proxy SEED.9". The same seed draws the same examples.
std::vector<Label> proxy_labels(const runtime::PushResponses& responses, const ProxyJudge& judge,
                                std::size_t count, std::uint64_t seed);

}  // namespace flinch::train
