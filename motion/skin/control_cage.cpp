// SPDX-License-Identifier: MIT
#include "motion/skin/control_cage.h"

#include <algorithm>
#include <map>

namespace flinch::motion {
namespace {

using Vertex = ControlCage::Vertex;
using Face = ControlCage::Face;

void accumulate(const Vertex& vertex, float share, Vertex& sum) {
  sum.position += share * vertex.position;
  for (const Role role : kRoles) sum.weights[role] += share * vertex.weights[role];
}

Vertex zero() {
  return {Eigen::Vector3f::Zero(), joint_weights({})};
}

struct Edge {
  std::uint32_t index = 0;
  std::uint32_t ends[2] = {};
  std::vector<std::uint32_t> faces = {};
};

// The edges in the order in which the faces first pass them.
class Edges {
 public:
  explicit Edges(const ControlCage& cage) {
    for (std::uint32_t f = 0; f < cage.faces.size(); ++f) {
      const std::vector<std::uint32_t>& corners = cage.faces[f].corners;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::uint32_t a = corners[i];
        const std::uint32_t b = corners[(i + 1) % corners.size()];
        const auto [place, is_new] = index_.try_emplace(std::minmax(a, b), edges_.size());
        if (is_new) edges_.push_back({place->second, {a, b}});
        edges_[place->second].faces.push_back(f);
      }
    }
  }

  const std::vector<Edge>& all() const { return edges_; }
  std::uint32_t between(std::uint32_t a, std::uint32_t b) const {
    return index_.at(std::minmax(a, b));
  }

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> index_;
  std::vector<Edge> edges_;
};

}  // namespace

JointWeights joint_weights(std::initializer_list<std::pair<Role, float>> weights) {
  JointWeights all;
  for (float& weight : all) weight = 0;
  for (const auto& [role, weight] : weights) all[role] += weight;
  return all;
}

// With face points f (means of corners), edge points e, and a vertex v of n edges:
//   e = (v_1 + v_2 + f_1 + f_2) / 4
//   v' = (mean f + 2 mean (midpoints of edges) + (n - 3) v) / n
// The new vertices are those of the cage, then one per edge, then one per face.
ControlCage subdivided(const ControlCage& cage) {
  const Edges edges(cage);
  std::vector<Vertex> face_points(cage.faces.size(), zero());
  std::vector<Vertex> face_sums(cage.vertices.size(), zero());
  for (std::size_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<std::uint32_t>& corners = cage.faces[f].corners;
    const float share = 1 / static_cast<float>(corners.size());
    for (const std::uint32_t corner : corners) {
      accumulate(cage.vertices[corner], share, face_points[f]);
    }
    for (const std::uint32_t corner : corners) accumulate(face_points[f], 1, face_sums[corner]);
  }

  std::vector<Vertex> edge_points(edges.all().size(), zero());
  std::vector<Vertex> end_sums(cage.vertices.size(), zero());  // of midpoints, twice
  std::vector<int> edge_counts(cage.vertices.size(), 0);
  for (const Edge& edge : edges.all()) {
    for (const std::uint32_t end : edge.ends) {
      accumulate(cage.vertices[end], 0.25F, edge_points[edge.index]);
      for (const std::uint32_t one : edge.ends) accumulate(cage.vertices[one], 1, end_sums[end]);
      ++edge_counts[end];
    }
    for (const std::uint32_t f : edge.faces) {
      accumulate(face_points[f], 0.25F, edge_points[edge.index]);
    }
  }

  ControlCage refined;
  refined.vertices.reserve(cage.vertices.size() + edge_points.size() + face_points.size());
  for (std::size_t v = 0; v < cage.vertices.size(); ++v) {
    const auto n = static_cast<float>(edge_counts[v]);
    Vertex vertex = zero();
    accumulate(face_sums[v], 1 / (n * n), vertex);
    accumulate(end_sums[v], 1 / (n * n), vertex);
    accumulate(cage.vertices[v], (n - 3) / n, vertex);
    refined.vertices.push_back(vertex);
  }
  refined.vertices.insert(refined.vertices.end(), edge_points.begin(), edge_points.end());
  refined.vertices.insert(refined.vertices.end(), face_points.begin(), face_points.end());

  const auto first_edge = static_cast<std::uint32_t>(cage.vertices.size());
  const auto first_face = static_cast<std::uint32_t>(first_edge + edge_points.size());
  for (std::uint32_t f = 0; f < cage.faces.size(); ++f) {
    const std::vector<std::uint32_t>& corners = cage.faces[f].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::uint32_t before = corners[(i + corners.size() - 1) % corners.size()];
      const std::uint32_t after = corners[(i + 1) % corners.size()];
      refined.faces.push_back({{corners[i], first_edge + edges.between(corners[i], after),
                                first_face + f, first_edge + edges.between(before, corners[i])},
                               cage.faces[f].covering});
    }
  }
  return refined;
}

std::uint32_t CageBuilder::add(const Eigen::Vector3f& position, const JointWeights& weights) {
  cage_.vertices.push_back({position, weights});
  return static_cast<std::uint32_t>(cage_.vertices.size() - 1);
}

Ring CageBuilder::add(std::span<const Eigen::Vector3f> positions, const JointWeights& weights) {
  Ring ring;
  for (const Eigen::Vector3f& position : positions) ring.push_back(add(position, weights));
  return ring;
}

void CageBuilder::face(std::vector<std::uint32_t> corners, Covering covering, bool is_mirrored) {
  if (is_mirrored) std::reverse(corners.begin(), corners.end());
  cage_.faces.push_back({std::move(corners), covering});
}

void CageBuilder::join(const Ring& from, const Ring& to, Covering covering, bool is_mirrored) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t next = (i + 1) % from.size();
    face({from[i], from[next], to[next], to[i]}, covering, is_mirrored);
  }
}

}  // namespace flinch::motion
