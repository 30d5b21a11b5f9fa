// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <span>

#include "models/realism_query.h"
#include "runtime/push/push_motion.h"
#include "runtime/push/push_responses.h"

namespace flinch::runtime {

/// The widths of deformations that are tried, w in 1/m^2.
inline constexpr std::array kTapers{1.0F, 3.0F, 10.0F, 30.0F, 100.0F};

/// The largest turn of a response, radians: 30 degrees.
inline constexpr float kMaxResponseTurn = 0.5235988F;

/// Which changes to responses are allowed.
struct SearchOptions {
  bool deforms = true;  ///< else m is 0
  bool turns = true;    ///< else responses keep to the character's facing
};

/// F (Arikan et al. 2005, equation 2), exact: the deformation by which the pushed joint reaches the
/// asked velocity (in the frame of the facing) at the peak of the response's own push, after the
/// turn that takes its direction nearest to the asked one. Both count as
/// seen from above: pushed bodies sink while they take a step. Sets everything except `realism` and
/// `taper`.
PushCandidate deformed_candidate(const PushResponses& responses, std::size_t response,
                                 motion::Role place, const Eigen::Vector3f& asked,
                                 const SearchOptions& options = {}) noexcept;

/// Returns the input of the paper's F. `components` are those of the configuration `response`;
/// `velocity` is what the pushed joint shall reach, in the frame of the response's facing, m/s.
models::ImpulseFeatures impulse_features(
    const std::array<float, models::kConfigurationComponents>& components,
    const BodyConfiguration& response, motion::Role place,
    const Eigen::Vector3f& velocity) noexcept;

/// What G sees of a candidate. `character` and `response` are components of their configurations.
models::RealismFeatures realism_features(
    const std::array<float, models::kConfigurationComponents>& character,
    const std::array<float, models::kConfigurationComponents>& response,
    const PushCandidate& candidate, const Eigen::Vector3f& asked) noexcept;

/// The responses of a library with the components of their configurations.
struct PushModel {
  const models::RealismModel* realism = nullptr;  ///< null: pushes cannot be answered
  std::optional<models::RealismIndex> index;      ///< of it
  std::vector<std::array<float, models::kConfigurationComponents>> components;  ///< per response
  std::size_t memory_bytes = 0;  ///< that a search needs
};
/// Prepares the search with a sound model; with none, the result has no model. Allocates.
PushModel prepare_push_model(const PushResponses& responses, const models::RealismModel* realism);

/// The paper's F: the deformation is the mean of those of the nearest examples, and the response is
/// not turned. Sets everything except `realism`. The model must have such examples
/// (RealismModel::theta).
PushCandidate averaged_candidate(const PushResponses& responses, const PushModel& model,
                                 std::size_t response, motion::Role place,
                                 const Eigen::Vector3f& asked) noexcept;

/// Asks F and G for every response and every width, and writes the best width of each of the best
/// responses to `best`, best first, as many as there are or as it holds. Returns their number. The
/// paper's F gives one width per response and ignores `options`. `configuration` is the
/// character's, `asked` in the frame of its facing, `memory` of PushModel::memory_bytes. Allocates
/// nothing.
std::size_t search_push(const PushResponses& responses, const PushModel& model,
                        const BodyConfiguration& configuration, motion::Role place,
                        const Eigen::Vector3f& asked, const SearchOptions& options,
                        std::span<std::byte> memory, std::span<PushCandidate> best) noexcept;

}  // namespace flinch::runtime
