// SPDX-License-Identifier: MIT
#include "train/store/store_places.h"

#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "motion/error.h"

namespace flinch::train {

namespace {

constexpr std::size_t kBodyAt = sizeof(std::uint16_t);
constexpr std::size_t kImpulseAt = kBodyAt + sizeof(std::uint8_t);
constexpr std::size_t kPointAt = kImpulseAt + sizeof(float);
static_assert(kPlaceBytes == kPointAt + sizeof(HitPlace::point_mm));

}  // namespace

std::vector<std::byte> encode_places(std::span<const HitPlace> places) {
  std::vector<std::byte> bytes(places.size() * kPlaceBytes);
  std::byte* to = bytes.data();
  int before = 0;
  for (const HitPlace& place : places) {
    if (place.clip < before || place.clip > std::numeric_limits<std::uint16_t>::max())
      throw Error("", "a place of clip " + std::to_string(place.clip) +
                          " cannot be stored after one of clip " + std::to_string(before) +
                          "; clips must ascend, up to 65535");
    before = place.clip;
    const auto clip = static_cast<std::uint16_t>(place.clip);
    const auto body = static_cast<std::uint8_t>(place.body);
    std::memcpy(to, &clip, sizeof clip);
    std::memcpy(to + kBodyAt, &body, sizeof body);
    std::memcpy(to + kImpulseAt, &place.impulse_ns, sizeof place.impulse_ns);
    std::memcpy(to + kPointAt, place.point_mm.data(), sizeof place.point_mm);
    to += kPlaceBytes;
  }
  return bytes;
}

std::vector<HitPlace> decode_places(std::span<const std::byte> bytes) {
  const auto refuse = [] {
    throw Error("", "the places of a scenario are damaged; simulate it again");
  };
  if (bytes.size() % kPlaceBytes != 0) refuse();
  std::vector<HitPlace> places(bytes.size() / kPlaceBytes);
  const std::byte* from = bytes.data();
  int before = 0;
  for (HitPlace& place : places) {
    std::uint16_t clip = 0;
    std::uint8_t body = 0;
    std::memcpy(&clip, from, sizeof clip);
    std::memcpy(&body, from + kBodyAt, sizeof body);
    std::memcpy(&place.impulse_ns, from + kImpulseAt, sizeof place.impulse_ns);
    std::memcpy(place.point_mm.data(), from + kPointAt, sizeof place.point_mm);
    if (clip < before || body >= motion::kBodyCount) refuse();
    place.clip = before = clip;
    place.body = static_cast<motion::Body>(body);
    from += kPlaceBytes;
  }
  return places;
}

}  // namespace flinch::train
