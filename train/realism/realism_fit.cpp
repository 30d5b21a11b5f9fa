// SPDX-License-Identifier: MIT
#include "train/realism/realism_fit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "models/realism_query.h"
#include "motion/rotation.h"

namespace flinch::train {
namespace {

using models::kConfigurationComponents;
using models::kRealismFeatureCount;
using models::RealismModel;
template <std::size_t kCount>
using RowsOf = std::vector<std::array<float, kCount>>;
using Weights = std::array<float, kRealismFeatureCount>;
using Rows = RowsOf<kRealismFeatureCount>;

constexpr auto kSize = static_cast<std::size_t>(runtime::BodyConfiguration::RowsAtCompileTime);
constexpr std::size_t kAsked = kRealismAskedFeature;
constexpr std::size_t kTurn = kAsked + 3;

/// Features that share a factor: [begin, end).
struct Group {
  std::size_t begin;
  std::size_t end;
};
constexpr std::array kGroups{Group{0, kConfigurationComponents},
                             Group{kConfigurationComponents, 2 * kConfigurationComponents},
                             Group{kAsked - 4, kAsked - 3},
                             Group{kAsked - 3, kAsked},
                             Group{kAsked, kTurn},
                             Group{kTurn, kRealismFeatureCount}};
static_assert(kGroups.size() == RealismFactors().size());
constexpr std::array kFactors{0.0F, 0.25F, 0.5F, 1.0F, 2.0F};

/// Sets mean and basis: the components of greatest variance of all configurations.
void set_components(const LabelledConfigurations& all, RealismModel& model) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic>;
  const auto count = static_cast<Eigen::Index>(2 * all.labels.size());
  Matrix rows(count, static_cast<Eigen::Index>(kSize));
  for (std::size_t i = 0; i < all.labels.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(2 * i)) = all.character[i].cast<double>();
    rows.row(static_cast<Eigen::Index>(2 * i + 1)) = all.response[i].cast<double>();
  }
  const Eigen::VectorXd mean = rows.colwise().mean();
  rows.rowwise() -= mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(rows.transpose() * rows);
  model.mean.resize(kSize);
  model.basis.resize(kConfigurationComponents * kSize);
  for (std::size_t i = 0; i < kSize; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    model.mean[i] = static_cast<float>(mean(row));
    for (std::size_t k = 0; k < kConfigurationComponents; ++k) {
      const auto column = static_cast<Eigen::Index>(kSize - 1 - k);  // they ascend
      model.basis[k * kSize + i] = static_cast<float>(solver.eigenvectors()(row, column));
    }
  }
}

Rows rows_of(const RealismModel& model, const LabelledConfigurations& all) {
  Rows rows;
  for (std::size_t i = 0; i < all.labels.size(); ++i)
    rows.push_back(models::as_array(features_of(model, all, i)));
  return rows;
}

template <std::size_t kCount>
std::array<float, kCount> inverse_spreads(const RowsOf<kCount>& rows) {
  std::array<float, kCount> weights{};
  for (std::size_t k = 0; k < weights.size(); ++k) {
    double sum = 0;
    double squares = 0;
    for (const auto& row : rows) {
      sum += double{row[k]};
      squares += double{row[k]} * double{row[k]};
    }
    const double count = static_cast<double>(rows.size());
    const double variance = squares / count - sum / count * (sum / count);
    weights[k] = variance > 1e-10 ? static_cast<float>(1 / std::sqrt(variance)) : 0.0F;
  }
  return weights;
}

float squared_distance(const std::array<float, kRealismFeatureCount>& a,
                       const std::array<float, kRealismFeatureCount>& b, const Weights& weights) {
  float squared = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const float difference = weights[k] * (a[k] - b[k]);
    squared += difference * difference;
  }
  return squared;
}

/// Mean squared error of labels that are estimated from all others.
double left_out_error(const Rows& rows, const std::vector<Label>& labels, const Weights& weights) {
  double sum = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    models::NearestExamples nearest;
    for (std::size_t j = 0; j < rows.size(); ++j) {
      if (j != i) nearest.add(squared_distance(rows[i], rows[j], weights), labels[j].quality);
    }
    const double error = double{nearest.estimate(std::numeric_limits<float>::infinity())} -
                         double{labels[i].quality};
    sum += error * error;
  }
  return sum / static_cast<double>(rows.size());
}

Weights scaled(Weights weights, const Group& group, float factor) {
  for (std::size_t k = group.begin; k < group.end; ++k) weights[k] *= factor;
  return weights;
}

Weights weights_with(const Weights& unit, const RealismFactors& factors) {
  Weights weights = unit;
  for (std::size_t g = 0; g < factors.size(); ++g)
    weights = scaled(weights, kGroups[g], factors[g]);
  return weights;
}

float distance_bound(const Rows& rows, const Weights& weights) {
  constexpr float kShare = 0.99F;
  constexpr float kSlack = 1.5F;
  std::vector<float> nearest(rows.size(), std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.size(); ++j) {
      if (j != i) nearest[i] = std::min(nearest[i], squared_distance(rows[i], rows[j], weights));
    }
  }
  std::ranges::sort(nearest);
  const auto at = static_cast<std::size_t>(kShare * static_cast<float>(nearest.size() - 1));
  return kSlack * std::sqrt(nearest[at]);
}

/// What the paper's F is the mean of. A response may be turned: in its own frame it is not, so
/// there push and theta are given.
models::ThetaExamples theta_examples(const RealismModel& model, const LabelledConfigurations& all) {
  models::ThetaExamples examples;
  RowsOf<models::kImpulseFeatureCount> rows;
  for (std::size_t i = 0; i < all.labels.size(); ++i) {
    const PushExample& example = all.labels[i].example;
    const Eigen::Quaternionf into_response =
        motion::rotation_about(Eigen::Vector3f::UnitZ(), -example.answer.turn);
    const auto components = models::components_of(model, std::span(all.response[i].data(), kSize));
    rows.push_back(models::as_array(runtime::impulse_features(
        components, all.response[i], example.place, into_response * example.asked)));
    const Eigen::Vector3f m = into_response * example.answer.deformation;
    examples.theta.insert(examples.theta.end(),
                          {std::log(example.answer.taper), m.x(), m.y(), m.z()});
  }
  examples.weight = inverse_spreads(rows);
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k)
      examples.points.push_back(examples.weight[k] * row[k]);
  }
  return examples;
}

}  // namespace

LabelledConfigurations configurations_of(const runtime::PushResponses& responses,
                                         std::vector<Label> labels) {
  LabelledConfigurations all{std::move(labels), {}, {}};
  const motion::Skeleton& skeleton = responses.library->skeleton();
  for (const Label& label : all.labels) {
    const PushedState state = state_of(responses, label.example);
    all.character.push_back(
        runtime::body_configuration(skeleton, state.before, state.now, state.dt_s));
    all.response.push_back(
        responses.responses[static_cast<std::size_t>(label.example.answer.response)].configuration);
  }
  return all;
}

LabelledConfigurations part_of(const LabelledConfigurations& all,
                               std::span<const std::size_t> indices) {
  LabelledConfigurations part;
  for (const std::size_t i : indices) {
    part.labels.push_back(all.labels[i]);
    part.character.push_back(all.character[i]);
    part.response.push_back(all.response[i]);
  }
  return part;
}

models::RealismFeatures features_of(const RealismModel& model, const LabelledConfigurations& all,
                                    std::size_t index) {
  const auto components = [&](const runtime::BodyConfiguration& configuration) {
    return models::components_of(model, std::span(configuration.data(), kSize));
  };
  const PushExample& example = all.labels[index].example;
  return runtime::realism_features(components(all.character[index]),
                                   components(all.response[index]), example.answer, example.asked);
}

RealismFactors fit_factors(const LabelledConfigurations& all) {
  constexpr int kRounds = 2;
  RealismModel model;
  set_components(all, model);
  const Rows rows = rows_of(model, all);
  const Weights unit = inverse_spreads(rows);
  RealismFactors factors;
  factors.fill(1);
  double least = left_out_error(rows, all.labels, unit);
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t g = 0; g < factors.size(); ++g) {
      for (const float factor : kFactors) {
        RealismFactors tried = factors;
        tried[g] = factor;
        const double error = left_out_error(rows, all.labels, weights_with(unit, tried));
        if (!(error < least)) continue;
        least = error;
        factors = tried;
      }
    }
  }
  return factors;
}

RealismModel fit_realism_with(const LabelledConfigurations& all, const RealismFactors& factors,
                              const std::string& judge) {
  RealismModel model;
  model.judge = judge;
  set_components(all, model);
  const Rows rows = rows_of(model, all);
  model.weight = weights_with(inverse_spreads(rows), factors);
  model.max_distance = distance_bound(rows, model.weight);
  for (std::size_t k = 0; k < kRealismFeatureCount; ++k) {
    for (const auto& row : rows) model.points.push_back(model.weight[k] * row[k]);
  }
  for (const Label& label : all.labels) model.quality.push_back(label.quality);
  return model;
}

RealismModel fit_realism(const LabelledConfigurations& all, RealismKind kind,
                         const std::string& judge) {
  if (kind == RealismKind::ours) return fit_realism_with(all, fit_factors(all), judge);
  constexpr RealismFactors kPaper{1, 1, 1, 1, 0, 0};  // does not see the asked push and the turn
  RealismModel model = fit_realism_with(all, kPaper, judge);
  model.theta = theta_examples(model, all);
  return model;
}

}  // namespace flinch::train
