// SPDX-License-Identifier: MIT
#include "database/import/scene_motion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "database/import/frame_selection.h"
#include "database/import/role_map.h"
#include "motion/error.h"
#include "motion/rotation.h"

namespace flinch::database {
namespace {

using Eigen::Affine3d;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr std::size_t kMaxJoints = 4096;
constexpr double kSparse_s = 0.1;  // keys that are further apart were set by hand
constexpr double kSparseRate_hz = 30;

bool is_marked(const SceneNode& node) {
  return (node.is_bone || node.is_animated) && !node.is_helper;
}

/// The nodes that become joints, and those that become End Sites of a joint.
struct Figure {
  struct Joint {
    std::size_t node = 0;
    int parent = -1;  // index into joints
  };
  struct End {
    std::size_t node = 0;
    std::size_t joint = 0;
  };
  std::vector<Joint> joints;  // parents first
  std::vector<End> ends;
};

/// Finds the largest tree of marked nodes.
class FigureFinder {
 public:
  explicit FigureFinder(const Scene& scene) : nodes_(scene.nodes) {
    const std::size_t count = nodes_.size();
    marked_below_.resize(count);
    meshes_below_.resize(count);
    children_.resize(count);
    for (std::size_t i = count; i-- > 0;) {
      marked_below_[i] += is_marked(nodes_[i]) ? 1 : 0;
      meshes_below_[i] += nodes_[i].has_mesh ? 1 : 0;
      has_skin_ = has_skin_ || nodes_[i].is_bone;
      if (nodes_[i].parent < 0) continue;
      marked_below_[parent(i)] += marked_below_[i];
      meshes_below_[parent(i)] += meshes_below_[i];
      ++children_[parent(i)];
    }
  }

  /// Returns where the figure may begin, the likeliest first: at the topmost marked node with the
  /// most below, or, where no skin tells the bones, at a node above it without motion of its own.
  std::vector<std::size_t> roots(const std::string& path) const {
    std::vector<std::size_t> roots;
    std::size_t most = 1;  // marked nodes of the roots so far; a figure has more
    const auto consider = [&](std::size_t node) {
      if (nodes_[node].is_helper || marked_below_[node] <= most) return;
      roots.push_back(node);
      most = marked_below_[node];
    };
    std::size_t node = largest_root();
    consider(node);
    while (!has_skin_ && node > 0 && parent(node) > 0) {
      node = parent(node);
      consider(node);
    }
    if (roots.empty()) throw Error(path, "has no animated figure");
    return roots;
  }

  Figure figure(std::size_t root, const std::string& path) const {
    Figure figure;
    std::vector<int> joint_at(nodes_.size(), -1);  // the joint that a node is or is part of
    for (std::size_t i = root; i < nodes_.size(); ++i) {
      if (i != root && (i == 0 || joint_at[parent(i)] < 0)) continue;
      const int above = i == root ? -1 : joint_at[parent(i)];
      if (nodes_[i].is_helper) {
        joint_at[i] = above;
      } else if (marked_below_[i] > 0 || is_still_bone(i)) {
        joint_at[i] = static_cast<int>(figure.joints.size());
        figure.joints.push_back({i, above});
      } else if (children_[i] == 0 && !nodes_[i].has_mesh) {
        figure.ends.push_back({i, static_cast<std::size_t>(above)});
      }
    }
    if (figure.joints.size() > kMaxJoints) {
      throw Error(path, "has more than " + std::to_string(kMaxJoints) + " joints");
    }
    return figure;
  }

 private:
  std::size_t parent(std::size_t node) const {
    return static_cast<std::size_t>(nodes_[node].parent);
  }

  // Without a skin, a node without motion of its own, on the way to others.
  bool is_still_bone(std::size_t node) const {
    return !has_skin_ && children_[node] > 0 && meshes_below_[node] == 0;
  }

  // The topmost marked node with the most below; nodes without a mark above it only place it.
  std::size_t largest_root() const {
    std::size_t best = 0;
    std::size_t most = 0;
    std::vector<bool> is_inside(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      is_inside[i] = i > 0 && (is_inside[parent(i)] || is_marked(nodes_[parent(i)]));
      if (is_inside[i] || !is_marked(nodes_[i]) || marked_below_[i] <= most) continue;
      best = i;
      most = marked_below_[i];
    }
    return best;
  }

  const std::vector<SceneNode>& nodes_;
  std::vector<std::size_t> marked_below_;  // marked nodes of each tree, with its root
  std::vector<std::size_t> meshes_below_;
  bool has_skin_ = false;
  std::vector<std::size_t> children_;
};

/// Index of the last key that is not after a time, and how far the time is from it to the next.
struct KeyPlace {
  std::size_t index = 0;
  double weight = 0;
};

// A key less than `tolerance_s` away is taken as it is: Assimp inserts keys into FBX rotations that
// pass half a turn, between which they go the long way round.
KeyPlace place_of(const std::vector<double>& times_s, double time_s, double tolerance_s) {
  const auto after = std::upper_bound(times_s.begin(), times_s.end(), time_s + tolerance_s);
  if (after == times_s.begin()) return {};
  const auto index = static_cast<std::size_t>(after - times_s.begin()) - 1;
  if (after == times_s.end() || times_s[index] >= time_s - tolerance_s) return {index, 0};
  return {index, (time_s - times_s[index]) / (*after - times_s[index])};
}

Vector3d mixed(const std::vector<Vector3d>& keys, const KeyPlace& place) {
  if (place.weight == 0) return keys[place.index];
  return (1 - place.weight) * keys[place.index] + place.weight * keys[place.index + 1];
}

/// A node's own transform, split so that keys can replace each part.
struct LocalParts {
  Vector3d position;
  Quaterniond rotation;
  Vector3d scale;
};

Matrix3d nearest_rotation(const Matrix3d& linear) {
  Matrix3d rotation;
  rotation.col(0) = linear.col(0).normalized();
  rotation.col(2) = rotation.col(0).cross(linear.col(1)).normalized();
  rotation.col(1) = rotation.col(2).cross(rotation.col(0));
  return rotation.allFinite() && rotation.determinant() > 0.5 ? rotation
                                                              : Matrix3d(Matrix3d::Identity());
}

LocalParts parts_of(const Affine3d& local) {
  const Matrix3d linear = local.linear();
  Vector3d scale = linear.colwise().norm();
  if (linear.determinant() < 0) scale.z() = -scale.z();  // mirrored
  return {local.translation(), Quaterniond(nearest_rotation(linear)), scale};
}

Affine3d local_at(const SceneNode& node, const LocalParts& own, double time_s, double tolerance_s) {
  const SceneTrack& track = node.track;
  if (track.positions.empty() && track.rotations.empty() && track.scales.empty()) return node.local;
  Vector3d position = own.position;
  Quaterniond rotation = own.rotation;
  Vector3d scale = own.scale;
  if (!track.positions.empty()) {
    position = mixed(track.positions, place_of(track.position_times_s, time_s, tolerance_s));
  }
  if (!track.scales.empty())
    scale = mixed(track.scales, place_of(track.scale_times_s, time_s, tolerance_s));
  if (!track.rotations.empty()) {
    const KeyPlace place = place_of(track.rotation_times_s, time_s, tolerance_s);
    rotation = track.rotations[place.index];
    if (place.weight > 0) {
      rotation = rotation.slerp(place.weight, track.rotations[place.index + 1]);
    }
  }
  return Eigen::Translation3d(position) * rotation * Eigen::Scaling(scale);
}

/// When the frames are.
struct FrameTimes {
  double start_s = 0;
  double interval_s = 1 / kSparseRate_hz;
  int count = 1;
};

/// The longest time between two keys that differ; 0 for a constant.
template <class Value>
double longest_way_s(const std::vector<double>& times_s, const std::vector<Value>& values) {
  double longest_s = 0;
  for (std::size_t k = 1; k < times_s.size(); ++k) {
    if (values[k].isApprox(values[k - 1], 1e-6)) continue;
    longest_s = std::max(longest_s, times_s[k] - times_s[k - 1]);
  }
  return longest_s;
}

bool is_human(const Bvh& bvh) try {
  map_roles(bvh, {});
  return true;
} catch (const Error&) {
  return false;
}

class MotionMaker {
 public:
  MotionMaker(const Scene& scene, Figure figure) : scene_(scene), figure_(std::move(figure)) {
    for (const SceneNode& node : scene.nodes) own_.push_back(parts_of(node.local));
    for (const Affine3d& transform : global_transforms(nullptr)) rest_.push_back(transform);
  }

  Bvh motion() {
    const std::vector<bool> is_used = nodes_of_figure();
    const FrameTimes times = frame_times(is_used);
    tolerance_s_ = 1e-3 * times.interval_s;
    make_joints(times);
    warn_of_wide_gaps(is_used);
    for (int frame = 0; frame < times.count; ++frame) {
      add_frame(times.start_s + frame * times.interval_s);
    }
    keep_moving_positions();
    return std::move(bvh_);
  }

 private:
  static constexpr int kPositions = 3;
  static constexpr int kWidth = 6;  // X, Y and Z positions; Z, X and Y rotations

  // Global transforms of all nodes, at a time or, without one, at rest.
  std::vector<Affine3d> global_transforms(const double* time_s) const {
    std::vector<Affine3d> global;
    global.reserve(scene_.nodes.size());
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      const SceneNode& node = scene_.nodes[i];
      const Affine3d local =
          time_s != nullptr ? local_at(node, own_[i], *time_s, tolerance_s_) : node.local;
      global.push_back(node.parent < 0 ? local
                                       : global[static_cast<std::size_t>(node.parent)] * local);
    }
    return global;
  }

  // Whether each node moves the figure: its joints and what is above them.
  std::vector<bool> nodes_of_figure() const {
    std::vector<bool> is_used(scene_.nodes.size());
    for (const Figure::Joint& joint : figure_.joints) {
      for (int i = static_cast<int>(joint.node); i >= 0;) {
        const auto node = static_cast<std::size_t>(i);
        if (is_used[node]) break;
        is_used[node] = true;
        i = scene_.nodes[node].parent;
      }
    }
    return is_used;
  }

  void warn_of_wide_gaps(const std::vector<bool>& is_used) {
    double longest_s = 0;
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      if (!is_used[i]) continue;
      const SceneTrack& track = scene_.nodes[i].track;
      longest_s = std::max({longest_s, longest_way_s(track.position_times_s, track.positions),
                            longest_way_s(track.rotation_times_s, track.rotations)});
    }
    if (longest_s <= kSparse_s) return;
    char text[160];
    std::snprintf(text, sizeof text,
                  "keys are up to %.2f s apart, and the motion between them is straight, whatever "
                  "curves the file has; save it with one key per frame",
                  longest_s);
    bvh_.warnings.emplace_back(text);
  }

  FrameTimes frame_times(const std::vector<bool>& is_used) const {
    double first_s = 0;
    double last_s = 0;
    std::size_t keys = 0;
    std::vector<double> intervals_s;
    for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
      if (!is_used[i]) continue;
      const SceneNode& node = scene_.nodes[i];
      for (const std::vector<double>* times :
           {&node.track.position_times_s, &node.track.rotation_times_s}) {
        if (times->size() < 2) continue;  // a single key is a constant
        first_s = keys == 0 ? times->front() : std::min(first_s, times->front());
        last_s = keys == 0 ? times->back() : std::max(last_s, times->back());
        keys += times->size();
        for (std::size_t k = 1; k < times->size(); ++k) {
          if ((*times)[k] > (*times)[k - 1]) intervals_s.push_back((*times)[k] - (*times)[k - 1]);
        }
      }
    }
    FrameTimes frames{.start_s = first_s};
    if (intervals_s.empty()) return frames;
    const auto middle = intervals_s.begin() + static_cast<std::ptrdiff_t>(intervals_s.size() / 2);
    std::nth_element(intervals_s.begin(), middle, intervals_s.end());
    if (*middle <= kSparse_s) frames.interval_s = *middle;
    // Between sparse keys there are more frames than keys, but the file bounds them all the same.
    const double count = std::round((last_s - first_s) / frames.interval_s) + 1;
    const double most =
        (4e6 + 16 * static_cast<double>(keys)) / static_cast<double>(figure_.joints.size());
    if (count > std::min<double>(most, kMaxFrames)) {
      throw Error(scene_.path, "its few keys make " + std::to_string(std::llround(count)) +
                                   " frames, which is too many; save it with one key per frame");
    }
    frames.count = static_cast<int>(count);
    // Times in files are rounded: the whole duration gives the interval more exactly.
    if (frames.count > 1) frames.interval_s = (last_s - first_s) / (count - 1);
    return frames;
  }

  const SceneNode& node_of(const Figure::Joint& joint) const { return scene_.nodes[joint.node]; }

  // From the parent, in the world's axes: the joints have these at rest.
  Vector3d rest_offset(std::size_t node, std::size_t parent) const {
    return rest_[node].translation() - rest_[parent].translation();
  }

  void make_joints(const FrameTimes& times) {
    bvh_.path = scene_.path;
    bvh_.warnings = scene_.warnings;
    bvh_.is_metres_y_up = true;
    bvh_.frame_time_s = times.interval_s;
    bvh_.frame_count = times.count;
    for (const Figure::Joint& from : figure_.joints) {
      BvhJoint joint;
      joint.name = node_of(from).name;
      joint.parent = from.parent;
      joint.offset = from.parent < 0 ? rest_[from.node].translation()
                                     : rest_offset(from.node, node_at(from.parent));
      joint.channels = {BvhChannel::x_position, BvhChannel::y_position, BvhChannel::z_position,
                        BvhChannel::z_rotation, BvhChannel::x_rotation, BvhChannel::y_rotation};
      joint.first_channel = bvh_.channel_count;
      bvh_.channel_count += kWidth;
      bvh_.joints.push_back(std::move(joint));
      rest_inverse_.push_back(inverse_of(rest_[from.node].linear()));
    }
    for (const Figure::End& end : figure_.ends) {
      bvh_.joints[end.joint].end_sites.push_back(
          rest_offset(end.node, figure_.joints[end.joint].node));
    }
    bvh_.values.reserve(static_cast<std::size_t>(bvh_.channel_count) *
                        static_cast<std::size_t>(times.count));
  }

  std::size_t node_at(int joint) const {
    return figure_.joints[static_cast<std::size_t>(joint)].node;
  }

  static Matrix3d inverse_of(const Matrix3d& linear) {
    const Matrix3d inverse = linear.inverse();
    return inverse.allFinite() ? inverse : Matrix3d(Matrix3d::Identity());
  }

  void add_frame(double time_s) {
    const std::vector<Affine3d> global = global_transforms(&time_s);
    std::vector<Quaterniond> orientation;
    for (std::size_t j = 0; j < figure_.joints.size(); ++j) {
      const Figure::Joint& joint = figure_.joints[j];
      orientation.emplace_back(nearest_rotation(global[joint.node].linear() * rest_inverse_[j]));
      Quaterniond rotation = orientation.back();
      Vector3d position = global[joint.node].translation();
      if (joint.parent >= 0) {
        const Quaterniond to_parent =
            orientation[static_cast<std::size_t>(joint.parent)].conjugate();
        rotation = to_parent * rotation;
        position = to_parent * (position - global[node_at(joint.parent)].translation());
      }
      // R = Rz Rx Ry
      const Vector3d angles = rotation.toRotationMatrix().eulerAngles(2, 0, 1);
      bvh_.values.insert(bvh_.values.end(), position.begin(), position.end());
      for (const double angle : angles) bvh_.values.push_back(motion::degrees(angle));
    }
  }

  // Most joints only turn. Their position channels go, so that they are bones.
  void keep_moving_positions() {
    std::vector<bool> keeps(bvh_.joints.size(), false);
    keeps[0] = true;
    const auto width = static_cast<std::size_t>(bvh_.channel_count);
    for (std::size_t j = 1; j < bvh_.joints.size(); ++j) {
      const BvhJoint& joint = bvh_.joints[j];
      const double tolerance = 1e-4 * std::max(joint.offset.norm(), 1e-3);
      for (std::size_t at = static_cast<std::size_t>(joint.first_channel);
           at < bvh_.values.size() && !keeps[j]; at += width) {
        const Vector3d position(bvh_.values[at], bvh_.values[at + 1], bvh_.values[at + 2]);
        keeps[j] = (position - joint.offset).norm() > tolerance;
      }
    }
    std::size_t to = 0;
    for (std::size_t from = 0; from < bvh_.values.size(); ++from) {
      const std::size_t column = from % width;
      if (column % kWidth < kPositions && !keeps[column / kWidth]) continue;
      bvh_.values[to++] = bvh_.values[from];
    }
    bvh_.values.resize(to);
    bvh_.channel_count = 0;
    for (std::size_t j = 0; j < bvh_.joints.size(); ++j) {
      BvhJoint& joint = bvh_.joints[j];
      if (!keeps[j])
        joint.channels.erase(joint.channels.begin(), joint.channels.begin() + kPositions);
      joint.first_channel = bvh_.channel_count;
      bvh_.channel_count += static_cast<int>(joint.channels.size());
    }
  }

  const Scene& scene_;
  Figure figure_;
  double tolerance_s_ = 0;  // see place_of
  std::vector<LocalParts> own_;
  std::vector<Affine3d> rest_;
  std::vector<Matrix3d> rest_inverse_;  // of each joint's linear part
  Bvh bvh_;
};

}  // namespace

Bvh scene_motion(const Scene& scene) {
  const FigureFinder finder(scene);
  std::vector<Bvh> motions;
  for (const std::size_t root : finder.roots(scene.path)) {
    motions.push_back(MotionMaker(scene, finder.figure(root, scene.path)).motion());
    if (is_human(motions.back())) return std::move(motions.back());
  }
  return std::move(motions.front());
}

}  // namespace flinch::database
