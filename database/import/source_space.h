// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "database/import/source_figure.h"

namespace flinch::database {

/// What a file's lengths may be in. `cmu` is the unit of the CMU database: 0.0254 / 0.45 m.
enum class LengthUnit : std::uint8_t { metre, centimetre, millimetre, inch, cmu };
double metres_in(LengthUnit unit);
std::string_view name_of(LengthUnit unit);  ///< "m", "cm", "mm", "inch" or "cmu"
std::optional<LengthUnit> length_unit_named(std::string_view name);

/// The unit in which a standing head joint is nearest, by ratio, to 1.5 m above the ground.
LengthUnit likeliest_unit(double head_height_in_units);

/// Which way is up in a file.
enum class UpAxis : std::uint8_t { x, y, z, minus_x, minus_y, minus_z };
Eigen::Vector3d direction_of(UpAxis up);
std::string_view name_of(UpAxis up);  ///< "x", "y", "z", "-x", "-y" or "-z"
std::optional<UpAxis> up_axis_named(std::string_view name);

/// From the mean of the feet to the head, unit.
Eigen::Vector3d feet_to_head(const FigureFrame& frame);

/// The axis that is nearest to a direction.
UpAxis nearest_axis(const Eigen::Vector3d& direction);

/// Up as the motion has it: the axis nearest to the mean of feet_to_head over the frames.
/// `certainty` is that mean's component along it, 0 to 1.
struct UpEstimate {
  UpAxis up = UpAxis::y;
  double certainty = 0;
};
UpEstimate estimate_up(const Bvh& bvh, const SourceFigure& figure);

/// The rotation that brings a file's `up` to Z and, with it, `forward` (made level) to X.
Eigen::Quaterniond to_world(const Eigen::Vector3d& up, const Eigen::Vector3d& forward);

/// The same with the forward that files with this up axis mostly have; a motion's facing is found
/// later.
Eigen::Quaterniond to_world(UpAxis up);

}  // namespace flinch::database
