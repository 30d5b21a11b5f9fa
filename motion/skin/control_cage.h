// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "motion/role.h"
#include "motion/skin/covering.h"

namespace flinch::motion {

/// How much of each joint's movement a point takes part in; the weights add up to 1.
using JointWeights = PerRole<float>;

/// Returns these weights, and 0 for all other joints.
JointWeights joint_weights(std::initializer_list<std::pair<Role, float>> weights);

/// A coarse closed surface whose subdivision is a smooth one.
struct ControlCage {
  struct Vertex {
    Eigen::Vector3f position;  ///< m
    JointWeights weights;
  };
  struct Face {
    std::vector<std::uint32_t> corners;  ///< three or more vertices, counter-clockwise from outside
    Covering covering = Covering::skin;
  };
  std::vector<Vertex> vertices;
  std::vector<Face> faces;
};

/// Refines a cage once (Catmull and Clark 1978, "Recursively generated B-spline surfaces on
/// arbitrary topological meshes", Computer-Aided Design 10(6)); weights are refined like positions.
/// Every edge must have exactly two faces, which pass it in opposite directions.
ControlCage subdivided(const ControlCage& cage);

/// Vertices that form a closed curve.
using Ring = std::vector<std::uint32_t>;

/// Builds a cage from rings. Faces of a mirrored part are turned over, so that the same rings make
/// the left and the right half of a figure.
class CageBuilder {
 public:
  std::uint32_t add(const Eigen::Vector3f& position, const JointWeights& weights);
  Ring add(std::span<const Eigen::Vector3f> positions, const JointWeights& weights);

  void face(std::vector<std::uint32_t> corners, Covering covering, bool is_mirrored);
  /// Joins two rings of the same size by quadrilaterals. Seen from outside, with `from` below `to`,
  /// the rings run to the right.
  void join(const Ring& from, const Ring& to, Covering covering, bool is_mirrored);

  const Eigen::Vector3f& position(std::uint32_t vertex) const {
    return cage_.vertices[vertex].position;
  }
  ControlCage cage() && { return std::move(cage_); }

 private:
  ControlCage cage_;
};

}  // namespace flinch::motion
