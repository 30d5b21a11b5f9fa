// SPDX-License-Identifier: MIT
#include "features/feature_layout.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace flinch::features {
namespace {

static_assert(sizeof(Features) == sizeof(float) * kFeatureCount);
static_assert(sizeof(Geometry) == sizeof(float) * kGeometryCount);

constexpr auto kPaperCount = static_cast<std::size_t>(kFeatureCount);

constexpr std::array<std::string_view, kMaxFeatures> kAllNames = [] {
  std::array<std::string_view, kMaxFeatures> names;
  std::copy(kFeatureNames.begin(), kFeatureNames.end(), names.begin());
  std::copy(kGeometryNames.begin(), kGeometryNames.end(), names.begin() + kFeatureCount);
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
  return std::any_of(component_.begin(), component_.begin() + size_,
                     [](std::uint8_t place) { return place >= kPaperCount; });
}

std::span<const FeatureSet> feature_sets() {
  static const std::array<FeatureSet, 3> kSets{
      {{"geometry", "how the threat meets the body",
        layout_of(joined(kGeometryNames, kTimeAndTarget))},
       {"paper", "the threat at perception, and the character ahead", layout_of(kFeatureNames)},
       {"both", "all that either has", layout_of(kAllNames)}}};
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
        "miss_pelvis_up", "miss_legs_side", "miss_legs_up"}}};
  return kGroups;
}

Layout without(const Layout& layout, const FeatureGroup& group) {
  std::vector<std::string> kept = layout.names();
  std::erase_if(kept, [&](const std::string& name) {
    return std::ranges::find(group.components, name) != group.components.end();
  });
  return Layout::of(kept).value_or(Layout{});
}

FeatureVector arranged(const Layout& layout, const Features& features, const Geometry& geometry) {
  const auto paper = std::bit_cast<std::array<float, kFeatureCount>>(features);
  const auto ours = std::bit_cast<std::array<float, kGeometryCount>>(geometry);
  FeatureVector vector{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(layout.size()); ++i) {
    const std::size_t place = layout.component_[i];
    const float value = place < kPaperCount ? paper[place] : ours[place - kPaperCount];
    vector[i] = std::isfinite(value) ? value : 0;
  }
  return vector;
}

FeatureVector feature_vector(const Layout& layout, const Scenario& scenario,
                             const IdlingFigure& figure) {
  const Features features = features_of(scenario, *figure.idle);
  Geometry geometry{};
  if (layout.has_geometry()) {
    geometry =
        geometry_of(scenario, predict_character(figure, scenario.state, scenario.time_to_impact_s));
  }
  return arranged(layout, features, geometry);
}

FeatureVector feature_vector(const Layout& layout, const Scenario& scenario,
                             const motion::PerTarget<Eigen::Vector3f>& centres) {
  motion::Motion still;
  still.poses.emplace_back();
  const PredictedCharacter ahead{Eigen::Vector3f::Zero(), centres};
  return arranged(layout, features_of(scenario, still), geometry_of(scenario, ahead));
}

}  // namespace flinch::features
