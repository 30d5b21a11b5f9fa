// SPDX-License-Identifier: MIT
#include "database/library/packed_poses.h"

#include <algorithm>
#include <array>
#include <bit>
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
    step_ = 1 / steps_per_unit(bits);
    BitReader residuals = unpacker.residuals(track);
    is_constant_ = track.width == 0;
    if (is_constant_) {
      std::ranges::fill(values_, value_of(track.first));
    } else if (track.order == 0) {
      accumulate(
          track.first, [&](std::uint32_t) { return track.first; }, residuals);
    } else if (track.order == 1) {
      accumulate(
          track.first, [](std::uint32_t last) { return last; }, residuals);
    } else {
      std::uint32_t before = track.first;
      accumulate(
          track.first,
          [&before](std::uint32_t last) {
            const std::uint32_t ahead = 2 * last - before;
            before = last;
            return ahead;
          },
          residuals);
    }
  }
  bool is_constant() const { return is_constant_; }
  float operator[](std::size_t pose) const { return values_[pose]; }

 private:
  float value_of(std::uint32_t number) const {
    return step_ * static_cast<float>(static_cast<std::int32_t>(number));
  }
  template <class Predict>
  void accumulate(std::uint32_t first, Predict predict, BitReader& residuals) {
    std::uint32_t number = first;
    values_[0] = value_of(number);
    for (std::size_t k = 1; k < values_.size(); ++k) {
      number = predict(number) + residual_of(residuals.next());
      values_[k] = value_of(number);
    }
  }

  std::vector<float>& values_;
  float step_ = 1;
  bool is_constant_ = false;
};

/// The rotation whose component of that code follows from the others, in ascending order.
Eigen::Quaternionf rotation_of(unsigned code, float a, float b, float c) {
  const auto [component, is_negative] = derived_component(code);
  const float magnitude = derived_magnitude(a, b, c);
  const float derived = is_negative ? -magnitude : magnitude;
  switch (component) {
    case 0:
      return {derived, a, b, c};
    case 1:
      return {a, derived, b, c};
    case 2:
      return {a, b, derived, c};
    default:
      return {a, b, c, derived};
  }
}

/// Unpacks all tracks of a clip; keeps the memory for one rotation's.
class ClipUnpacker {
 public:
  ClipUnpacker(std::span<const std::uint8_t> bytes, std::vector<motion::Pose>& poses)
      : unpacker_(bytes, poses.size()), poses_(poses) {}

  void read_root() {
    for (int i = 0; i < static_cast<int>(kRootTracks); ++i) {
      a_.read(unpacker_, kRootBits);
      for (std::size_t k = 0; k < poses_.size(); ++k) poses_[k].root_position[i] = a_[k];
    }
  }

  void read_rotations(motion::Role role) {
    const unsigned derived = unpacker_.byte();
    const bool is_per_pose = derived == kDerivedPerPose;
    BitReader codes = is_per_pose ? unpacker_.codes() : BitReader(nullptr, 0, 0);
    for (TrackValues* track : {&a_, &b_, &c_}) track->read(unpacker_, kRotationBits[role]);
    if (!is_per_pose && a_.is_constant() && b_.is_constant() && c_.is_constant()) {
      const Eigen::Quaternionf rotation = rotation_of(derived, a_[0], b_[0], c_[0]);
      for (motion::Pose& pose : poses_) pose.rotation[role] = rotation;
      return;
    }
    for (std::size_t k = 0; k < poses_.size(); ++k) {
      const unsigned code = is_per_pose ? codes.next() : derived;
      poses_[k].rotation[role] = rotation_of(code, a_[k], b_[k], c_[k]);
    }
  }

 private:
  Unpacker unpacker_;
  std::vector<motion::Pose>& poses_;
  std::array<std::vector<float>, kTracksPerRotation> memory_;
  TrackValues a_{poses_.size(), memory_[0]};
  TrackValues b_{poses_.size(), memory_[1]};
  TrackValues c_{poses_.size(), memory_[2]};
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
  clip.read_root();
  for (motion::Role role : motion::kRoles) clip.read_rotations(role);
  return true;
}

}  // namespace flinch::database
