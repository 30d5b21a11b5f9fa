// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "models/realism.h"
#include "train/realism/label_file.h"

namespace flinch::train {

/// The first of the features that the paper's G does not see.
inline constexpr std::size_t kRealismAskedFeature = 2 * models::kConfigurationComponents + 4;

/// Which F and G are fitted.
enum class RealismKind : std::uint8_t {
  ours,   ///< F is exact; G also sees the asked push and the turn; features weigh as labels say
  paper,  ///< F is the mean of examples; G sees C_t, C^i and theta, each to unit spread (Arikan et
          ///< al. 2005, section 5)
};

/// Labels with the body configurations of their characters and responses, which no fit changes.
struct LabelledConfigurations {
  std::vector<Label> labels;
  std::vector<runtime::BodyConfiguration> character;  ///< C_t, one per label
  std::vector<runtime::BodyConfiguration> response;   ///< C^i, one per label
};
LabelledConfigurations configurations_of(const runtime::PushResponses& responses,
                                         std::vector<Label> labels);

/// The part of the labels with these indices.
LabelledConfigurations part_of(const LabelledConfigurations& all,
                               std::span<const std::size_t> indices);

/// The features of one label as the model sees them.
models::RealismFeatures features_of(const models::RealismModel& model,
                                    const LabelledConfigurations& all, std::size_t index);

/// How much each of six groups of features counts: character, response, width, deformation, asked
/// push, turn.
using RealismFactors = std::array<float, 6>;

/// The factors of {0, 1/4, 1/2, 1, 2} that give the least squared error of labels estimated from
/// all others, one group after the other, twice round. Takes 60 comparisons of all labels with all.
RealismFactors fit_factors(const LabelledConfigurations& all);

/// Fits G with given factors: a few comparisons of all labels with all.
models::RealismModel fit_realism_with(const LabelledConfigurations& all,
                                      const RealismFactors& factors, const std::string& judge);

/// Fits F and G. Configurations are reduced by their principal components; every feature is scaled
/// to unit spread; ours then multiplies groups by fit_factors(). `judge` becomes the model's. An
/// estimate is 0 beyond 1.5 times the distance that 99 % of labels have to their nearest. There
/// must be more than models::kRealismNeighbours labels.
models::RealismModel fit_realism(const LabelledConfigurations& all, RealismKind kind,
                                 const std::string& judge);

}  // namespace flinch::train
