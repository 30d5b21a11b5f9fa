// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "database/import/source_figure.h"

namespace flinch::database {

/// Unit of a file's lengths. `cmu` is the unit of the CMU database: 0.0254 / 0.45 m.
enum class LengthUnit : std::uint8_t { metre, centimetre, millimetre, inch, cmu };
double metres_in(LengthUnit unit);
std::string_view name_of(LengthUnit unit);  ///< "m", "cm", "mm", "inch" or "cmu"
std::optional<LengthUnit> length_unit_named(std::string_view name);

/// Returns the unit in which a standing head joint's height is nearest, by ratio, to 1.5 m.
LengthUnit likeliest_unit(double head_height_in_units);

/// The up direction of a file.
enum class UpAxis : std::uint8_t { x, y, z, minus_x, minus_y, minus_z };
Eigen::Vector3d direction_of(UpAxis up);
std::string_view name_of(UpAxis up);  ///< "x", "y", "z", "-x", "-y" or "-z"
std::optional<UpAxis> up_axis_named(std::string_view name);

/// Direction from the midpoint of the feet to the head, unit.
Eigen::Vector3d feet_to_head(const FigureFrame& frame);

/// Returns the axis nearest to a direction.
UpAxis nearest_axis(const Eigen::Vector3d& direction);

/// Returns the rotation that takes a file's `up` to Z and its `forward`, made horizontal, to X.
Eigen::Quaterniond to_world(const Eigen::Vector3d& up, const Eigen::Vector3d& forward);

/// The same with the forward direction that most files with this up axis have; a motion's facing is
/// found later.
Eigen::Quaterniond to_world(UpAxis up);

}  // namespace flinch::database
