// SPDX-License-Identifier: MIT
#include "features/feature_layout.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "features/portable_math.h"

namespace flinch::features {
namespace {

static_assert(sizeof(Features) == sizeof(float) * kFeatureCount);
static_assert(sizeof(Geometry) == sizeof(float) * kGeometryCount);
static_assert(sizeof(StanceFeatures) == sizeof(float) * kStanceFeatureCount);

constexpr auto kPaperCount = static_cast<std::size_t>(kFeatureCount);

constexpr std::size_t kThreatPlace = kPaperCount + static_cast<std::size_t>(kGeometryCount);
/// The axis of a rod at the impact, in the character's frame, and how long it is.
constexpr std::size_t kRodPlace = kThreatPlace + 3;
constexpr std::size_t kKindPlace = kRodPlace + 4;

constexpr std::array<std::string_view, kKindPlace - kThreatPlace + kMaxThreatKinds> kThreatNames{
    "radius_m",     "mass_kg", "log_impulse", "rod_axis_x", "rod_axis_y", "rod_axis_z",
    "rod_length_m", "kind_0",  "kind_1",      "kind_2",     "kind_3",     "kind_4",
    "kind_5",       "kind_6",  "kind_7",      "kind_8",     "kind_9",     "kind_10",
    "kind_11",      "kind_12", "kind_13",     "kind_14",    "kind_15"};

constexpr std::size_t kStancePlace = kKindPlace + kMaxThreatKinds;
static_assert(kStancePlace + kStanceFeatureCount == kMaxFeatures);

constexpr std::array<std::string_view, kMaxFeatures> kAllNames = [] {
  std::array<std::string_view, kMaxFeatures> names;
  std::copy(kFeatureNames.begin(), kFeatureNames.end(), names.begin());
  std::copy(kGeometryNames.begin(), kGeometryNames.end(), names.begin() + kFeatureCount);
  std::copy(kThreatNames.begin(), kThreatNames.end(), names.begin() + kThreatPlace);
  std::copy(kStanceFeatureNames.begin(), kStanceFeatureNames.end(), names.begin() + kStancePlace);
  return names;
}();

Layout layout_of(std::span<const std::string_view> names) {
  const std::vector<std::string> copies(names.begin(), names.end());
  return Layout::of(copies).value();
}

template <class... Parts>
std::vector<std::string_view> joined(const Parts&... parts) {
  std::vector<std::string_view> names;
  (names.insert(names.end(), parts.begin(), parts.end()), ...);
  return names;
}

constexpr std::array<std::string_view, 5> kTimeAndTarget{
    "time_to_impact_s", "target_head", "target_trunk", "target_pelvis", "target_legs"};

}  // namespace

std::optional<Layout> Layout::of(std::span<const std::string> names) noexcept {
  Layout layout;
  if (names.empty() || names.size() > kAllNames.size()) return std::nullopt;
  for (const std::string& name : names) {
    const auto found = std::find(kAllNames.begin(), kAllNames.end(), name);
    const auto place = static_cast<std::uint8_t>(found - kAllNames.begin());
    const auto end = layout.component_.begin() + layout.size_;
    if (found == kAllNames.end() || std::find(layout.component_.begin(), end, place) != end) {
      return std::nullopt;
    }
    *end = place;
    ++layout.size_;
  }
  return layout;
}

std::string_view Layout::name(int component) const {
  return kAllNames[component_[static_cast<std::size_t>(component)]];
}

std::vector<std::string> Layout::names() const {
  std::vector<std::string> names;
  for (int i = 0; i < size_; ++i) names.emplace_back(name(i));
  return names;
}

bool Layout::has_geometry() const {
  return std::any_of(component_.begin(), component_.begin() + size_, [](std::uint8_t place) {
    return place >= kPaperCount && place < kThreatPlace;
  });
}

bool Layout::has_stance() const {
  return std::any_of(component_.begin(), component_.begin() + size_,
                     [](std::uint8_t place) { return place >= kStancePlace; });
}

std::size_t Layout::kind_in(const FeatureVector& x) const {
  for (std::size_t i = 0; i < static_cast<std::size_t>(size_); ++i)
    if (component_[i] >= kKindPlace && component_[i] < kStancePlace && x[i] == 1)
      return component_[i] - kKindPlace;
  return 0;
}

std::span<const FeatureSet> feature_sets() {
  static const std::array<FeatureSet, 3> kSets{
      {{"geometry", "how the threat meets the body",
        layout_of(joined(kGeometryNames, kTimeAndTarget))},
       {"paper", "the threat at perception, and the character ahead", layout_of(kFeatureNames)},
       {"both", "all that either has", layout_of(joined(kFeatureNames, kGeometryNames))}}};
  return kSets;
}

const FeatureSet* feature_set_named(std::string_view name) {
  for (const FeatureSet& set : feature_sets())
    if (set.name == name) return &set;
  return nullptr;
}

std::span<const FeatureGroup> feature_groups() {
  static const std::vector<FeatureGroup> kGroups{
      {"position", {"position_x", "position_y", "position_z"}},
      {"heading", {"heading_x", "heading_y", "heading_z"}},
      {"speed", {"speed_mps", "impact_speed_mps"}},
      {"time", {"time_to_impact_s"}},
      {"target", {"target_head", "target_trunk", "target_pelvis", "target_legs"}},
      {"ahead", {"ahead_x", "ahead_y", "ahead_facing_sin", "ahead_facing_cos"}},
      {"contact", {"contact_x", "contact_y", "contact_z"}},
      {"approach", {"approach_x", "approach_y", "approach_z"}},
      {"offset", {"offset_side", "offset_up"}},
      {"miss",
       {"miss_head_side", "miss_head_up", "miss_trunk_side", "miss_trunk_up", "miss_pelvis_side",
        "miss_pelvis_up", "miss_legs_side", "miss_legs_up"}},
      {"velocity", {"velocity_x", "velocity_y"}},
      {"turn", {"turn_rate"}},
      {"weight", {"weight_left"}},
      {"hands",
       {"left_hand_x", "left_hand_y", "left_hand_z", "right_hand_x", "right_hand_y",
        "right_hand_z"}}};
  return kGroups;
}

Layout without(const Layout& layout, const FeatureGroup& group) {
  std::vector<std::string> kept = layout.names();
  std::erase_if(kept, [&](const std::string& name) {
    return std::ranges::find(group.components, name) != group.components.end();
  });
  return Layout::of(kept).value_or(Layout{});
}

Layout with_kinds(const Layout& layout, std::span<const KnownKind> kinds) {
  std::vector<std::string> names = layout.names();
  const auto varies = [&](ValueRange KnownKind::*range) {
    return std::ranges::any_of(kinds, [&](const KnownKind& kind) {
      return (kind.*range).max != (kinds.front().*range).min ||
             (kind.*range).min != (kinds.front().*range).min;
    });
  };
  if (varies(&KnownKind::radius_m)) names.emplace_back(kThreatNames[0]);
  if (varies(&KnownKind::mass_kg)) {
    names.emplace_back(kThreatNames[1]);
    names.emplace_back(kThreatNames[2]);
  }
  if (std::ranges::find(kinds, ThreatShape::rod, &KnownKind::shape) != kinds.end())
    for (std::size_t i = kRodPlace; i < kKindPlace; ++i)
      names.emplace_back(kThreatNames[i - kThreatPlace]);
  for (std::size_t i = 0; kinds.size() > 1 && i < kinds.size(); ++i)
    names.emplace_back(kThreatNames[kKindPlace - kThreatPlace + i]);
  return Layout::of(names).value_or(layout);
}

Layout with_stances(const Layout& layout) {
  std::vector<std::string> names = layout.names();
  names.insert(names.end(), kStanceFeatureNames.begin(), kStanceFeatureNames.end());
  return Layout::of(names).value_or(layout);
}

namespace {

/// Radius, mass, or the natural logarithm of the largest impulse, N s, that the threat can give.
/// The kinds' largest differ by a factor, so in the logarithm by a number that goes with the kind.
float threat_component(const Scenario& scenario, std::size_t component) {
  const Threat& threat = scenario.threat;
  if (component == 0) return threat.radius;
  if (component == 1) return threat.mass_kg;
  // Of a rod, where its tip would strike: that depends on nothing but the rod.
  const Threat then = advanced(threat, scenario.time_to_impact_s);
  const Eigen::Vector3f tip =
      then.rod ? Eigen::Vector3f(then.position + then.rod->to_tip_m * then.rod->axis)
               : then.position;
  const StrikingPoint strikes = striking_point(then, 0, tip);
  const auto speed_mps = double{strikes.velocity.norm()};
  const double impulse_ns = (1 + threat.bounce.restitution) * double{strikes.mass_kg} * speed_mps;
  return impulse_ns > 0 ? static_cast<float>(portable_log(impulse_ns)) : 0.0F;
}

/// The component of a rod's axis at the impact, seen along the character's facing, or its length; 0
/// of other threats.
float rod_component(const Scenario& scenario, std::size_t component) {
  const Threat then = advanced(scenario.threat, scenario.time_to_impact_s);
  if (!then.rod) return 0;
  if (component == 3) return then.rod->to_butt_m + then.rod->to_tip_m + 2 * then.radius;
  const Eigen::Quaternionf to_character(
      Eigen::AngleAxisf(-scenario.state.facing, Eigen::Vector3f::UnitZ()));
  return (to_character * then.rod->axis)[static_cast<Eigen::Index>(component)];
}

}  // namespace

FeatureVector arranged(const Layout& layout, const Features& features, const Geometry& geometry,
                       const StanceFeatures& stance, const Scenario& scenario) {
  const Threat& threat = scenario.threat;
  const auto paper = std::bit_cast<std::array<float, kFeatureCount>>(features);
  const auto ours = std::bit_cast<std::array<float, kGeometryCount>>(geometry);
  const auto going_on = std::bit_cast<std::array<float, kStanceFeatureCount>>(stance);
  FeatureVector vector{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(layout.size()); ++i) {
    const std::size_t place = layout.component_[i];
    float value = 0;
    if (place < kPaperCount) {
      value = paper[place];
    } else if (place < kThreatPlace) {
      value = ours[place - kPaperCount];
    } else if (place >= kRodPlace && place < kKindPlace) {
      value = rod_component(scenario, place - kRodPlace);
    } else if (place < kRodPlace) {
      value = threat_component(scenario, place - kThreatPlace);
    } else if (place >= kStancePlace) {
      value = going_on[place - kStancePlace];
    } else if (place - kKindPlace == static_cast<std::size_t>(threat.kind)) {
      value = 1;
    }
    vector[i] = std::isfinite(value) ? value : 0;
  }
  return vector;
}

FeatureVector feature_vector(const Layout& layout, const Scenario& scenario,
                             const IdlingFigure& figure) {
  const Features features = features_of(scenario, figure.stance);
  Geometry geometry{};
  if (layout.has_geometry()) {
    geometry =
        geometry_of(scenario, predict_character(figure, scenario.state, scenario.time_to_impact_s));
  }
  StanceFeatures stance{};
  if (layout.has_stance())
    stance = stance_features(figure, scenario.state, scenario.time_to_impact_s);
  return arranged(layout, features, geometry, stance, scenario);
}

FeatureVector feature_vector(const Layout& layout, const Scenario& scenario,
                             const motion::PerTarget<Eigen::Vector3f>& centres) {
  motion::Motion still;
  still.poses.emplace_back();
  const PredictedCharacter ahead{Eigen::Vector3f::Zero(), centres};
  return arranged(layout, features_of(scenario, still), geometry_of(scenario, ahead), {}, scenario);
}

}  // namespace flinch::features
