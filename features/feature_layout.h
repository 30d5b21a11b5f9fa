// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "features/feature_vector.h"
#include "features/geometry.h"
#include "features/stance_features.h"

namespace flinch::features {

/// Names and order of a feature vector's components; stored with a selector. Any subset of
/// kFeatureNames, kGeometryNames, "radius_m", "mass_kg", "log_impulse", of a rod "rod_axis_x",
/// "rod_axis_y", "rod_axis_z" and "rod_length_m", "kind_0" to "kind_15" (1 for the threat's
/// kind, 0 for others), and kStanceFeatureNames, each at most once.
class Layout {
 public:
  /// Makes an empty layout.
  Layout() = default;

  /// Returns the layout with these names. Returns nothing for a name that this build does not
  /// compute, a repeated name, or an empty list.
  static std::optional<Layout> of(std::span<const std::string> names) noexcept;

  int size() const { return size_; }
  std::string_view name(int component) const;
  std::vector<std::string> names() const;
  /// Returns whether it has a component that geometry_of() computes.
  bool has_geometry() const;
  /// Returns whether it has a component that stance_features() computes.
  bool has_stance() const;
  /// The kind of threat that features in this layout tell; 0 if they tell none.
  std::size_t kind_in(const FeatureVector& x) const;

  bool operator==(const Layout&) const = default;

 private:
  friend FeatureVector arranged(const Layout& layout, const Features& features,
                                const Geometry& geometry, const StanceFeatures& stance,
                                const Scenario& scenario);

  int size_ = 0;
  /// Indices into the names of all components; 0 beyond the size.
  std::array<std::uint8_t, kMaxFeatures> component_{};
};

/// A named layout.
struct FeatureSet {
  std::string_view name;
  std::string_view summary;  ///< what it contains, for people
  Layout layout;
};

/// Returns the named layouts: "paper", the features of Zordan et al.; "geometry", how the threat
/// meets the body; and "both". The first one is the default, chosen by the study in
/// docs/selectors.md.
std::span<const FeatureSet> feature_sets();
/// Returns the set with that name; null if there is none.
const FeatureSet* feature_set_named(std::string_view name);

/// Components that describe one thing together, such as the contact point. Ablation studies leave
/// out one group at a time.
struct FeatureGroup {
  std::string_view name;
  std::vector<std::string_view> components;
};
std::span<const FeatureGroup> feature_groups();
/// Returns the layout without the components of a group; unchanged if it has none of them.
Layout without(const Layout& layout, const FeatureGroup& group);

/// Returns the layout with the components that tell these kinds of threats apart, their sizes, and
/// their masses with the impulses that these can give, as far as they differ, and those of rods
/// where there are any; unchanged where all threats are alike.
Layout with_kinds(const Layout& layout, std::span<const KnownKind> kinds);

/// Returns the layout with the components that tell what a character's stance does.
Layout with_stances(const Layout& layout);

/// Returns the components of a scenario in the layout's order, 0 beyond its size. The bits are the
/// same in training and in the game. Takes a few microseconds at most; allocates nothing.
/// Components that overflow for extreme input are 0.
FeatureVector feature_vector(const Layout& layout, const Scenario& scenario,
                             const IdlingFigure& figure);

/// The same for a character that stands still at the origin, facing X, with these target centres.
/// For tools: allocates.
FeatureVector feature_vector(const Layout& layout, const Scenario& scenario,
                             const motion::PerTarget<Eigen::Vector3f>& centres);

}  // namespace flinch::features
