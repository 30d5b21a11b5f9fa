// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace flinch::models {

/// Numbers that a body configuration is reduced to by principal components.
inline constexpr std::size_t kConfigurationComponents = 5;

/// A pushed motion before it is made, as G sees it (Arikan et al. 2005, equation 3): components of
/// C_t and C^i, and theta; beside these what push is asked, and by how much the response is turned.
/// Vectors are in the frame of the character's facing.
struct RealismFeatures {
  std::array<float, kConfigurationComponents> character{};  ///< C_t
  std::array<float, kConfigurationComponents> response{};   ///< C^i
  float log_taper = 0;                                      ///< ln w, w in 1/m^2
  std::array<float, 3> deformation{};                       ///< m, m/s
  std::array<float, 3> asked{};                             ///< velocity of the pushed joint, m/s
  float turn = 0;                                           ///< radians
};
/// Their number.
inline constexpr std::size_t kRealismFeatureCount = 2 * kConfigurationComponents + 8;
/// The features in the order of the declaration.
std::array<float, kRealismFeatureCount> as_array(const RealismFeatures& features);

/// The input of the paper's F (equation 2): which push a recorded response shall answer. Vectors
/// are in the frame of the response's facing.
struct ImpulseFeatures {
  std::array<float, kConfigurationComponents> response{};  ///< components of C^i
  std::array<float, 3> place{};                            ///< of the pushed joint in C^i, m
  std::array<float, 3> velocity{};                         ///< that it shall reach, m/s
};
/// Their number.
inline constexpr std::size_t kImpulseFeatureCount = kConfigurationComponents + 6;
/// The features in the order of the declaration.
std::array<float, kImpulseFeatureCount> as_array(const ImpulseFeatures& features);

/// Numbers of theta: ln w, w in 1/m^2, then m, in the frame of the response's facing, m/s.
inline constexpr std::size_t kThetaSize = 4;
using Theta = std::array<float, kThetaSize>;

/// The examples whose mean is the paper's F: pushes, and the deformation that answered each.
struct ThetaExamples {
  std::array<float, kImpulseFeatureCount> weight{};
  std::vector<float> points;  ///< weighted features of one example after the other
  std::vector<float> theta;   ///< of one example after the other
};

/// The number of examples that an estimate is made from, as in the paper.
inline constexpr std::size_t kRealismNeighbours = 10;
/// The most examples that a model may have.
inline constexpr std::size_t kMaxRealismExamples = 20'000;

/// Estimates Q, how much a pushed motion looks like a recording, from judged examples (G of the
/// paper). Distances are taken after each feature is multiplied by its weight.
struct RealismModel {
  std::string judge;         ///< who judged the examples: "people", or "proxy: " and what it is
  std::vector<float> mean;   ///< of the examples' body configurations
  std::vector<float> basis;  ///< kConfigurationComponents rows of as many numbers as `mean`
  std::array<float, kRealismFeatureCount> weight{};  ///< 0: a feature that G does not see
  std::vector<float> points;   ///< weighted features of all examples, one feature after the other
  std::vector<float> quality;  ///< Q of each example, 0 to 1
  float max_distance = 0;      ///< farther than this from every example, Q is 0
  /// The examples of the paper's F. Without them, F is exact (runtime::deformed_candidate()).
  std::optional<ThetaExamples> theta;

  /// The number of examples.
  std::size_t size() const { return quality.size(); }
};

/// Whether sizes agree, all numbers are finite, and there are as many examples as an estimate needs
/// and no more than kMaxRealismExamples.
bool is_sound(const RealismModel& model);

/// The components of a configuration, which has as many numbers as the model's mean.
std::array<float, kConfigurationComponents> components_of(const RealismModel& model,
                                                          std::span<const float> configuration);

/// The mean of the nearest examples' Q, weighted by the inverse of their distances; 0 where the
/// nearest is farther than max_distance. Compares with every example. The model is sound.
float estimate_realism(const RealismModel& model, const RealismFeatures& features);

/// Returns the mean theta of the kRealismNeighbours nearest examples, each weighted by the inverse
/// of its distance. Of equally near examples the first are taken. There must be at least as many
/// examples. Allocates nothing.
Theta estimate_theta(const ThetaExamples& examples, const ImpulseFeatures& features);

}  // namespace flinch::models
