// SPDX-License-Identifier: MIT
#include "tests/database/files/unpacked_slowly.h"

#include <cmath>

namespace flinch::tests {
namespace {

using motion::Role;

constexpr std::size_t kHeaderSize = 4 + 3 * 5 + 21 * (1 + 3 * 5);

class SlowReader {
 public:
  explicit SlowReader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  long header_number(int size) {
    long number = 0;
    for (int i = 0; i < size; ++i) number += long{bytes_.at(header_++)} << (8 * i);
    return number;
  }
  long bits(long width) {
    long number = 0;
    for (long i = 0; i < width; ++i, ++bit_) {
      const long byte = bytes_.at(kHeaderSize + bit_ / 8);
      number += ((byte >> (bit_ % 8)) & 1) << i;
    }
    return number;
  }

 private:
  const std::vector<std::uint8_t>& bytes_;
  std::size_t header_ = 0;
  std::size_t bit_ = 0;
};

std::vector<double> track(SlowReader& reader, std::size_t count, int bits) {
  const long unsigned_first = reader.header_number(4);
  const long shape = reader.header_number(1);
  std::vector<long> numbers{unsigned_first < (1L << 31) ? unsigned_first
                                                        : unsigned_first - (1L << 32)};
  while (numbers.size() < count) {
    const std::size_t k = numbers.size();
    const long code = reader.bits(shape % 32);
    const long residual = code % 2 == 0 ? code / 2 : -(code + 1) / 2;
    const long last = numbers[k - 1];
    const long line = k == 1 ? last : last + (last - numbers[k - 2]);
    const long predicted[] = {numbers[0], last, line};
    numbers.push_back(predicted[shape / 32] + residual);
  }
  std::vector<double> values;
  for (const long number : numbers)
    values.push_back(static_cast<double>(number) * std::exp2(-bits));
  return values;
}

int bits_of(Role role) {
  switch (role) {
    case Role::pelvis:
    case Role::abdomen:
    case Role::chest:
    case Role::left_clavicle:
    case Role::right_clavicle:
    case Role::left_thigh:
    case Role::right_thigh:
      return 16;
    case Role::head:
    case Role::left_hand:
    case Role::right_hand:
    case Role::left_foot:
    case Role::right_foot:
    case Role::left_toes:
    case Role::right_toes:
      return 14;
    default:
      return 15;
  }
}

}  // namespace

std::vector<motion::Pose> unpacked_slowly(const std::vector<std::uint8_t>& bytes) {
  SlowReader reader(bytes);
  const auto count = static_cast<std::size_t>(reader.header_number(4));
  std::vector<motion::Pose> poses(count);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> values = track(reader, count, 15);
    for (std::size_t k = 0; k < count; ++k)
      poses[k].root_position[axis] = static_cast<float>(values[k]);
  }
  for (const Role role : motion::kRoles) {
    std::vector<long> code(count, reader.header_number(1));
    if (code[0] == 8)
      for (long& own : code) own = reader.bits(3);
    const std::vector<double> a = track(reader, count, bits_of(role));
    const std::vector<double> b = track(reader, count, bits_of(role));
    const std::vector<double> c = track(reader, count, bits_of(role));
    for (std::size_t k = 0; k < count; ++k) {
      const double length = std::sqrt(1 - (a[k] * a[k] + b[k] * b[k] + c[k] * c[k]));
      std::vector<double> wxyz{a[k], b[k], c[k]};
      wxyz.insert(wxyz.begin() + code[k] % 4, code[k] < 4 ? length : -length);
      poses[k].rotation[role] =
          Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).cast<float>();
    }
  }
  return poses;
}

}  // namespace flinch::tests
