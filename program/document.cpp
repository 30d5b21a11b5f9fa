// SPDX-License-Identifier: MIT
#include "program/document.h"

#include <array>
#include <charconv>
#include <cmath>
#include <iostream>

#include "motion/rotation.h"

namespace flinch::program {

namespace {

// Paths may hold any bytes: what is not UTF-8 becomes U+FFFD.
std::string text_of(const Json& document, int indent) {
  return document.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

void print(const Json& document) {
  std::cout << text_of(document, 2) << '\n';
}

void print_line(const Json& document) {
  std::cout << text_of(document, -1) << std::endl;
}

double rounded_degrees(double radians) {
  return std::round(1e6 * motion::degrees(radians)) / 1e6;
}

double shortest(float value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double same = 0;
  std::from_chars(text.data(), end, same);
  return same;
}

Json to_json(const models::ClipSummary& clip) {
  if (!clip.annotation) return {};
  const motion::Annotation& annotation = *clip.annotation;
  return {{"target", motion::name_of(annotation.target)},
          {"direction_degrees", std::round(motion::degrees(double{annotation.direction}))},
          {"degree", motion::name_of(annotation.degree)},
          {"onset_s", shortest(annotation.onset_s)},
          {"peak_s", shortest(annotation.peak_s)},
          {"end_s", shortest(annotation.end_s)}};
}

}  // namespace flinch::program
