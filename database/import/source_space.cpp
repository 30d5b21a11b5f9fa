// SPDX-License-Identifier: MIT
#include "database/import/source_space.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "motion/enum_names.h"

namespace flinch::database {
namespace {

using motion::enum_named;
using motion::Role;

constexpr double kStandingHeadHeight = 1.5;  // m, of the head joint of a mean adult

constexpr motion::EnumArray<LengthUnit, std::string_view, 5> kUnitNames{"m", "cm", "mm", "inch",
                                                                        "cmu"};
constexpr motion::EnumArray<LengthUnit, double, 5> kMetres{1, 0.01, 0.001, 0.0254, 0.0254 / 0.45};
constexpr motion::EnumArray<UpAxis, std::string_view, 6> kUpNames{"x", "y", "z", "-x", "-y", "-z"};

}  // namespace

double metres_in(LengthUnit unit) {
  return kMetres[unit];
}

std::string_view name_of(LengthUnit unit) {
  return kUnitNames[unit];
}

std::optional<LengthUnit> length_unit_named(std::string_view name) {
  return enum_named(kUnitNames, name);
}

LengthUnit likeliest_unit(double head_height_in_units) {
  const auto distance = [&](double metres) {
    return std::abs(std::log(head_height_in_units * metres / kStandingHeadHeight));
  };
  const auto best = std::min_element(kMetres.begin(), kMetres.end(), [&](double one, double other) {
    return distance(one) < distance(other);
  });
  return static_cast<LengthUnit>(best - kMetres.begin());
}

Eigen::Vector3d direction_of(UpAxis up) {
  const int axis = static_cast<int>(up);
  return (axis < 3 ? 1 : -1) * Eigen::Vector3d::Unit(axis % 3);
}

std::string_view name_of(UpAxis up) {
  return kUpNames[up];
}

std::optional<UpAxis> up_axis_named(std::string_view name) {
  if (name.starts_with('+')) name.remove_prefix(1);
  return enum_named(kUpNames, name);
}

Eigen::Vector3d feet_to_head(const FigureFrame& frame) {
  const Eigen::Vector3d feet =
      0.5 * (frame.position[Role::left_foot] + frame.position[Role::right_foot]);
  return (frame.position[Role::head] - feet).normalized();
}

UpAxis nearest_axis(const Eigen::Vector3d& direction) {
  int axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return static_cast<UpAxis>(axis + (direction[axis] < 0 ? 3 : 0));
}

Eigen::Quaterniond to_world(const Eigen::Vector3d& up, const Eigen::Vector3d& forward) {
  const Eigen::Vector3d x = (forward - forward.dot(up) * up).normalized();
  Eigen::Matrix3d rows;
  rows.row(0) = x;
  rows.row(1) = up.cross(x);
  rows.row(2) = up;
  return Eigen::Quaterniond(rows);
}

Eigen::Quaterniond to_world(UpAxis up) {
  const Eigen::Vector3d direction = direction_of(up);
  const bool is_y = up == UpAxis::y || up == UpAxis::minus_y;
  return to_world(direction, is_y ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY());
}

}  // namespace flinch::database
