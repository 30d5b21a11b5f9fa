// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "features/feature_vector.h"
#include "features/geometry.h"

namespace flinch::features {

/// Which components a vector has, in its order: what travels with a selector by their names. Any
/// of those in kFeatureNames and kGeometryNames, none of them twice.
class Layout {
 public:
  /// Empty.
  Layout() = default;

  /// The layout with these names. None for a name that this build does not compute, one that is
  /// there twice, or no name at all.
  static std::optional<Layout> of(std::span<const std::string> names) noexcept;

  int size() const { return size_; }
  std::string_view name(int component) const;
  std::vector<std::string> names() const;
  /// Whether it has a component that geometry_of() computes.
  bool has_geometry() const;

  bool operator==(const Layout&) const = default;

 private:
  friend FeatureVector arranged(const Layout& layout, const Features& features,
                                const Geometry& geometry);

  int size_ = 0;
  /// Places in kFeatureNames followed by kGeometryNames; 0 beyond the size.
  std::array<std::uint8_t, kMaxFeatures> component_{};
};

/// A layout that has a name of its own.
struct FeatureSet {
  std::string_view name;
  std::string_view summary;  ///< what it states, for people
  Layout layout;
};

/// "paper": Zordan et al.'s; "geometry": how the threat meets the body; "both". The first is the
/// default, chosen by the study in docs/selectors.md.
std::span<const FeatureSet> feature_sets();
/// Null for a name that no set has.
const FeatureSet* feature_set_named(std::string_view name);

/// Components that say one thing together, such as where the contact is: what a study leaves out
/// one at a time.
struct FeatureGroup {
  std::string_view name;
  std::vector<std::string_view> components;
};
std::span<const FeatureGroup> feature_groups();
/// A layout without the components of a group; the same if it has none of them.
Layout without(const Layout& layout, const FeatureGroup& group);

/// The components of a scenario in a layout's order, 0 beyond its size. The same bits in training
/// and in the game. At most a few microseconds; allocates nothing. What overflows for absurd
/// numbers is 0.
FeatureVector feature_vector(const Layout& layout, const Scenario& scenario,
                             const IdlingFigure& figure);

/// The same of a character that stands still at the origin, facing X, with its targets there. For
/// tools: allocates.
FeatureVector feature_vector(const Layout& layout, const Scenario& scenario,
                             const TargetCentres& centres);

}  // namespace flinch::features
