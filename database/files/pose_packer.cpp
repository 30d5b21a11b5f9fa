// SPDX-License-Identifier: MIT
#include "database/files/pose_packer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "database/library/packed_poses.h"
#include "database/library/pose_grid.h"

namespace flinch::database {
namespace {

using motion::Pose;
using motion::Role;

bool is_same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// Of a value on the grid and within the bounds of poses.
std::int32_t grid_number(float value, int bits) {
  return static_cast<std::int32_t>(value * steps_per_unit(bits));
}

float on_grid(float value, int bits) {
  return std::round(value * steps_per_unit(bits)) / steps_per_unit(bits) + 0.0F;  // never -0
}

/// The components other than the derived one, in ascending order.
std::array<float, 3> others_of(const Components& components, unsigned derived) {
  std::array<float, 3> others{};
  for (unsigned i = 0; i < 3; ++i) others[i] = components[i < derived ? i : i + 1];
  return others;
}

/// The nearest point of the grid with that component derived from the others.
Components snapped(Components components, unsigned code, int bits) {
  const auto [derived, is_negative] = derived_component(code);
  for (float& component : components) component = on_grid(component, bits);
  const auto [a, b, c] = others_of(components, derived);
  components[derived] = is_negative ? -derived_magnitude(a, b, c) : derived_magnitude(a, b, c);
  return components;
}

bool is_on_grid(const Components& components, unsigned code, int bits) {
  const Components there = snapped(components, code, bits);
  return std::equal(components.begin(), components.end(), there.begin(), is_same);
}

/// By which derived component the rotation is on the grid, or none.
std::optional<unsigned> code_on_grid(const Components& components, int bits) {
  for (unsigned code = 0; code < kDerivedCount; ++code)
    if (is_on_grid(components, code, bits)) return code;
  return std::nullopt;
}

/// The derived component of all poses, or else of each.
struct Codes {
  unsigned of_all = kDerivedPerPose;
  std::vector<unsigned> of_pose;  ///< only if it differs

  unsigned operator[](std::size_t pose) const {
    return of_all == kDerivedPerPose ? of_pose[pose] : of_all;
  }
};

using Rotations = std::vector<Components>;

/// By which derived components the rotations are on the grid, or none.
std::optional<Codes> codes_on_grid(const Rotations& rotations, int bits) {
  for (unsigned code = 0; code < kDerivedCount; ++code) {
    if (std::ranges::all_of(rotations,
                            [&](const Components& q) { return is_on_grid(q, code, bits); }))
      return Codes{code, {}};
  }
  Codes codes;
  for (const Components& rotation : rotations) {
    const std::optional<unsigned> code = code_on_grid(rotation, bits);
    if (!code) return std::nullopt;
    codes.of_pose.push_back(*code);
  }
  return codes;
}

unsigned code_of(const Components& components, unsigned derived) {
  return derived + (std::signbit(components[derived]) ? 4 : 0);
}

/// The component whose least magnitude is the largest, if that is at least 0.5 with one sign: an
/// error of the others then moves it by at most three times as much. Otherwise the largest of each
/// pose, which is at least 0.5.
Codes best_codes(const Rotations& rotations) {
  constexpr float kMinMagnitude = 0.5F;
  float best = kMinMagnitude;
  Codes codes;
  for (unsigned derived = 0; derived < 4; ++derived) {
    const unsigned code = code_of(rotations.front(), derived);
    float least = std::numeric_limits<float>::infinity();
    for (const Components& rotation : rotations) {
      const bool is_like_first = code_of(rotation, derived) == code;
      least = std::min(least, is_like_first ? std::abs(rotation[derived]) : 0);
    }
    if (least < best || (least == best && codes.of_all != kDerivedPerPose)) continue;
    best = least;
    codes.of_all = code;
  }
  if (codes.of_all != kDerivedPerPose) return codes;
  const auto less = [](float a, float b) { return std::abs(a) < std::abs(b); };
  for (const Components& rotation : rotations) {
    const auto largest = std::max_element(rotation.begin(), rotation.end(), less);
    codes.of_pose.push_back(code_of(rotation, static_cast<unsigned>(largest - rotation.begin())));
  }
  return codes;
}

Rotations rotations_of(const std::vector<Pose>& poses, Role role) {
  Rotations rotations;
  rotations.reserve(poses.size());
  for (const Pose& pose : poses) rotations.push_back(components_of(pose.rotation[role]));
  return rotations;
}

void normalise(Components& components) {
  double square = 0;
  for (const float component : components) square += double{component} * component;
  for (float& component : components) component = static_cast<float>(component / std::sqrt(square));
}

void snap_rotations(std::vector<Pose>& poses, Role role) {
  const int bits = kRotationBits[role];
  Rotations rotations = rotations_of(poses, role);
  if (codes_on_grid(rotations, bits)) return;
  std::ranges::for_each(rotations, normalise);
  const Codes codes = best_codes(rotations);
  for (std::size_t k = 0; k < poses.size(); ++k)
    poses[k].rotation[role] = rotation_of(snapped(rotations[k], codes[k], bits));
}

class BitWriter {
 public:
  void add(std::uint32_t value, unsigned width) {
    for (unsigned i = 0; i < width; ++i, ++count_) {
      if (count_ % 8 == 0) bytes_.push_back(0);
      bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | ((value >> i & 1U) << count_ % 8));
    }
  }
  const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t count_ = 0;
};

using Numbers = std::vector<std::int32_t>;

std::int64_t predicted(const Numbers& numbers, std::size_t k, unsigned order) {
  if (order == 0) return numbers.front();
  const std::int64_t last = numbers[k - 1];
  return order == 1 || k == 1 ? last : 2 * last - numbers[k - 2];
}

/// With the sign in the lowest bit.
std::uint32_t coded(std::int64_t residual) {
  const auto doubled = static_cast<std::uint64_t>(residual) << 1;
  return static_cast<std::uint32_t>(residual < 0 ? ~doubled : doubled);
}

std::vector<std::uint32_t> residuals_of(const Numbers& numbers, unsigned order) {
  std::vector<std::uint32_t> residuals;
  for (std::size_t k = 1; k < numbers.size(); ++k)
    residuals.push_back(coded(numbers[k] - predicted(numbers, k, order)));
  return residuals;
}

unsigned width_of(const std::vector<std::uint32_t>& residuals) {
  std::uint32_t any = 0;
  for (const std::uint32_t residual : residuals) any |= residual;
  return static_cast<unsigned>(std::bit_width(any));
}

class Packer {
 public:
  explicit Packer(std::size_t pose_count) { add_number(static_cast<std::uint32_t>(pose_count)); }

  void add_track(const Numbers& numbers) {
    unsigned best_order = 0;
    for (unsigned order = 1; order <= kMaxOrder; ++order) {
      if (width_of(residuals_of(numbers, order)) < width_of(residuals_of(numbers, best_order)))
        best_order = order;
    }
    const std::vector<std::uint32_t> residuals = residuals_of(numbers, best_order);
    const unsigned width = width_of(residuals);
    add_number(static_cast<std::uint32_t>(numbers.front()));
    header_.push_back(static_cast<std::uint8_t>(width | best_order << kWidthBits));
    for (const std::uint32_t residual : residuals) bits_.add(residual, width);
  }
  void add_codes(const Codes& codes) {
    header_.push_back(static_cast<std::uint8_t>(codes.of_all));
    for (const unsigned code : codes.of_pose) bits_.add(code, kDerivedBits);
  }
  std::vector<std::uint8_t> bytes() const {
    std::vector<std::uint8_t> bytes = header_;
    bytes.insert(bytes.end(), bits_.bytes().begin(), bits_.bytes().end());
    bytes.insert(bytes.end(), kPaddingBytes, 0);
    return bytes;
  }

 private:
  void add_number(std::uint32_t number) {
    for (unsigned i = 0; i < 4; ++i) header_.push_back(static_cast<std::uint8_t>(number >> 8 * i));
  }

  std::vector<std::uint8_t> header_;
  BitWriter bits_;
};

bool pack_rotations(const std::vector<Pose>& poses, Role role, Packer& packer) {
  const int bits = kRotationBits[role];
  const Rotations rotations = rotations_of(poses, role);
  const std::optional<Codes> codes = codes_on_grid(rotations, bits);
  if (!codes) return false;
  packer.add_codes(*codes);
  std::array<Numbers, kTracksPerRotation> tracks;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    const auto others = others_of(rotations[k], derived_component((*codes)[k]).component);
    for (std::size_t i = 0; i < tracks.size(); ++i)
      tracks[i].push_back(grid_number(others[i], bits));
  }
  for (const Numbers& track : tracks) packer.add_track(track);
  return true;
}

}  // namespace

void snap(motion::Motion& motion) {
  for (Pose& pose : motion.poses) {
    make_zeros_positive(pose);
    for (float& coordinate : pose.root_position) coordinate = on_grid(coordinate, kRootBits);
  }
  for (const Role role : motion::kRoles) snap_rotations(motion.poses, role);
}

void snap(ClipLibrary& library) {
  for (motion::Clip& clip : library.clips) snap(clip.motion);
}

std::optional<std::vector<std::uint8_t>> pack_poses(const std::vector<Pose>& poses) {
  if (poses.empty()) return std::nullopt;
  Packer packer(poses.size());
  for (int i = 0; i < static_cast<int>(kRootTracks); ++i) {
    Numbers track;
    for (const Pose& pose : poses) {
      const float coordinate = pose.root_position[i];
      if (!is_same(coordinate, on_grid(coordinate, kRootBits))) return std::nullopt;
      track.push_back(grid_number(coordinate, kRootBits));
    }
    packer.add_track(track);
  }
  for (const Role role : motion::kRoles) {
    if (!pack_rotations(poses, role, packer)) return std::nullopt;
  }
  return packer.bytes();
}

}  // namespace flinch::database
