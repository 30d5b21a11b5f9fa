// SPDX-License-Identifier: MIT
#include "database/library/packed_poses.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "database/library/library_bounds.h"
#include "database/library/pose_grid.h"

namespace flinch::database {
namespace {

static_assert(std::endian::native == std::endian::little, "packed poses are read in place");

template <class T>
T number_at(const std::uint8_t* bytes) {
  T number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

/// Values of one width, one after the other. Reads up to seven bytes beyond the last one.
class BitReader {
 public:
  BitReader(const std::uint8_t* bits, std::size_t begin, unsigned width)
      : bits_(bits), next_(begin), width_(width), mask_((std::uint32_t{1} << width) - 1) {}

  std::uint32_t next() {
    const auto word = number_at<std::uint64_t>(bits_ + next_ / 8);
    const auto value = static_cast<std::uint32_t>(word >> (next_ % 8)) & mask_;
    next_ += width_;
    return value;
  }

 private:
  const std::uint8_t* bits_;
  std::size_t next_;
  unsigned width_;
  std::uint32_t mask_;
};

struct Track {
  std::uint32_t first = 0;
  unsigned width = 0;
  unsigned order = 0;
};

/// Reads the header from the front on, and hands out each track's place among the bits.
class Unpacker {
 public:
  Unpacker(std::span<const std::uint8_t> bytes, std::size_t pose_count)
      : header_(bytes.data() + 4), bits_(bytes.data() + kPackedHeaderBytes), count_(pose_count) {}

  std::uint8_t byte() { return *header_++; }
  Track track() {
    const Track track{number_at<std::uint32_t>(header_), header_[4] & ((1U << kWidthBits) - 1),
                      static_cast<unsigned>(header_[4]) >> kWidthBits};
    header_ += kTrackHeaderBytes;
    return track;
  }
  BitReader residuals(const Track& track) {
    return {bits_, claimed((count_ - 1) * track.width), track.width};
  }
  BitReader codes() { return {bits_, claimed(count_ * kDerivedBits), kDerivedBits}; }
  std::size_t bit_count() const { return bit_count_; }
  /// Counts the bits of a track, or of codes, without reading them.
  std::size_t claimed(std::size_t bits) {
    const std::size_t begin = bit_count_;
    bit_count_ += bits;
    return begin;
  }

 private:
  const std::uint8_t* header_;
  const std::uint8_t* bits_;
  std::size_t count_;
  std::size_t bit_count_ = 0;
};

bool is_track(Unpacker& unpacker, std::size_t pose_count) {
  const Track track = unpacker.track();
  unpacker.claimed((pose_count - 1) * track.width);
  return track.order <= kMaxOrder;
}

/// Whether the header is one, and the bytes have the size that it asks for.
bool is_packed(std::span<const std::uint8_t> bytes, std::size_t pose_count) {
  Unpacker unpacker(bytes, pose_count);
  for (std::size_t i = 0; i < kRootTracks; ++i) {
    if (!is_track(unpacker, pose_count)) return false;
  }
  for (int role = 0; role < motion::kRoleCount; ++role) {
    const unsigned derived = unpacker.byte();
    if (derived > kDerivedPerPose) return false;
    if (derived == kDerivedPerPose) unpacker.claimed(pose_count * kDerivedBits);
    for (std::size_t i = 0; i < kTracksPerRotation; ++i) {
      if (!is_track(unpacker, pose_count)) return false;
    }
  }
  return bytes.size() == kPackedHeaderBytes + (unpacker.bit_count() + 7) / 8 + kPaddingBytes;
}

/// The residual that has its sign in the lowest bit.
std::uint32_t residual_of(std::uint32_t coded) {
  return (coded >> 1) ^ (0U - (coded & 1U));
}

/// The values of one track, one per pose. Sums of numbers wrap around, so that no forged file makes
/// them undefined.
class TrackValues {
 public:
  TrackValues(std::size_t pose_count, std::vector<float>& values) : values_(values) {
    values_.resize(pose_count);
  }

  void read(Unpacker& unpacker, int bits) {
    const Track track = unpacker.track();
    const float step = 1 / steps_per_unit(bits);
    BitReader residuals = unpacker.residuals(track);
    is_constant_ = track.width == 0;
    if (is_constant_) {
      std::ranges::fill(values_, value_of(track.first, step));
    } else if (track.order == 0) {
      accumulate(
          track.first, step, [&](std::uint32_t) { return track.first; }, residuals);
    } else if (track.order == 1) {
      accumulate(
          track.first, step, [](std::uint32_t last) { return last; }, residuals);
    } else {
      std::uint32_t before = track.first;
      accumulate(
          track.first, step,
          [&before](std::uint32_t last) {
            const std::uint32_t ahead = 2 * last - before;
            before = last;
            return ahead;
          },
          residuals);
    }
  }
  bool is_constant() const { return is_constant_; }
  bool is_within(float max) const {
    return std::ranges::all_of(values_, [max](float value) { return std::abs(value) <= max; });
  }
  float operator[](std::size_t pose) const { return values_[pose]; }

 private:
  static float value_of(std::uint32_t number, float step) {
    return step * static_cast<float>(static_cast<std::int32_t>(number));
  }
  // By value and through no member, so that everything but the values stays in registers.
  template <class Predict>
  void accumulate(std::uint32_t first, float step, Predict predict, BitReader residuals) {
    std::uint32_t number = first;
    float* value = values_.data();
    float* const end = value + values_.size();
    *value = value_of(number, step);
    while (++value != end) {
      number = predict(number) + residual_of(residuals.next());
      *value = value_of(number, step);
    }
  }

  std::vector<float>& values_;
  bool is_constant_ = false;
};

/// The rotation with these components, in ascending order, and the derived one of that code.
Eigen::Quaternionf rotation_with(unsigned code, float magnitude,
                                 const std::array<float, 3>& others) {
  const auto [derived, is_negative] = derived_component(code);
  Components components{};
  for (unsigned i = 0, next = 0; i < components.size(); ++i)
    components[i] = i != derived ? others[next++] : is_negative ? -magnitude : magnitude;
  return rotation_of(components);
}

/// derived_magnitude() of each element, to the same bits.
void find_derived_magnitudes(const std::vector<float>& a, const std::vector<float>& b,
                             const std::vector<float>& c, Eigen::ArrayXd& magnitudes) {
  magnitudes.resize(static_cast<Eigen::Index>(a.size()));
  for (std::size_t k = 0; k < a.size(); ++k)
    magnitudes[static_cast<Eigen::Index>(k)] = derived_square(a[k], b[k], c[k]);
  magnitudes = magnitudes.sqrt();  // all square roots at once take half the time
}

/// Unpacks all tracks of a clip; keeps the memory for one rotation's.
class ClipUnpacker {
 public:
  ClipUnpacker(std::span<const std::uint8_t> bytes, std::vector<motion::Pose>& poses)
      : unpacker_(bytes, poses.size()), poses_(poses) {}

  /// Returns false if a root is out of bounds.
  bool read_root() {
    bool is_near = true;
    for (int i = 0; i < static_cast<int>(kRootTracks); ++i) {
      a_.read(unpacker_, kRootBits);
      is_near = is_near && a_.is_within(kMaxDistance_m);
      for (std::size_t k = 0; k < poses_.size(); ++k) poses_[k].root_position[i] = a_[k];
    }
    return is_near;
  }

  /// Returns false if a rotation is not a unit one.
  bool read_rotations(motion::Role role) {
    const unsigned derived = unpacker_.byte();
    const bool is_per_pose = derived == kDerivedPerPose;
    BitReader codes = is_per_pose ? unpacker_.codes() : BitReader(nullptr, 0, 0);
    for (TrackValues* track : {&a_, &b_, &c_}) track->read(unpacker_, kRotationBits[role]);
    if (!is_per_pose && a_.is_constant() && b_.is_constant() && c_.is_constant()) {
      const float magnitude = derived_magnitude(a_[0], b_[0], c_[0]);
      const Eigen::Quaternionf rotation = rotation_with(derived, magnitude, {a_[0], b_[0], c_[0]});
      for (motion::Pose& pose : poses_) pose.rotation[role] = rotation;
      return !std::isnan(magnitude);
    }
    find_derived_magnitudes(memory_[0], memory_[1], memory_[2], magnitudes_);
    if (is_per_pose) {
      for (std::size_t k = 0; k < poses_.size(); ++k)
        poses_[k].rotation[role] = rotation_with(codes.next(), magnitude(k), {a_[k], b_[k], c_[k]});
    } else {
      write_rotations(role, derived);
    }
    return !magnitudes_.isNaN().any();
  }

 private:
  float magnitude(std::size_t pose) const {
    return static_cast<float>(magnitudes_[static_cast<Eigen::Index>(pose)]);
  }
  /// Those that all have the derived component of that code.
  void write_rotations(motion::Role role, unsigned code) {
    const auto [component, is_negative] = derived_component(code);
    derived_.resize(poses_.size());
    for (std::size_t k = 0; k < poses_.size(); ++k)
      derived_[k] = is_negative ? -magnitude(k) : magnitude(k);
    std::array<const float*, 4> tracks{};  // w x y z
    for (unsigned i = 0, next = 0; i < tracks.size(); ++i)
      tracks[i] = i == component ? derived_.data() : memory_[next++].data();
    const auto [w, x, y, z] = tracks;
    for (std::size_t k = 0; k < poses_.size(); ++k)
      poses_[k].rotation[role].coeffs() = Eigen::Vector4f(x[k], y[k], z[k], w[k]);
  }

  Unpacker unpacker_;
  std::vector<motion::Pose>& poses_;
  std::array<std::vector<float>, kTracksPerRotation> memory_;
  TrackValues a_{poses_.size(), memory_[0]};
  TrackValues b_{poses_.size(), memory_[1]};
  TrackValues c_{poses_.size(), memory_[2]};
  Eigen::ArrayXd magnitudes_;
  std::vector<float> derived_;
};

}  // namespace

std::optional<std::size_t> packed_pose_count(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kPackedHeaderBytes + kPaddingBytes) return std::nullopt;
  return number_at<std::uint32_t>(bytes.data());
}

bool unpack_poses(std::span<const std::uint8_t> bytes, std::vector<motion::Pose>& poses) {
  const std::optional<std::size_t> count = packed_pose_count(bytes);
  if (!count || *count == 0 || *count > kMaxPoses || !is_packed(bytes, *count)) return false;
  poses.resize(*count);
  ClipUnpacker clip(bytes, poses);
  return clip.read_root() && std::ranges::all_of(motion::kRoles, [&](motion::Role role) {
           return clip.read_rotations(role);
         });
}

}  // namespace flinch::database
