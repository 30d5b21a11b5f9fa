// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "models/selector.h"

namespace flinch::program {

/// JSON that keeps its keys in the order in which they were written.
using Json = nlohmann::ordered_json;

/// Prints the one document of --json.
void print(const Json& document);
/// Prints a document as one of several lines, and flushes it.
void print_line(const Json& document);

/// Converts radians to degrees, rounded to the millionth, which is as exact as floats are.
double rounded_degrees(double radians);

/// Returns the double with the fewest digits that equals this float, so that JSON shows 0.4 and not
/// 0.4000000059604645.
double shortest(float value);

/// Returns a clip's annotation as JSON; an empty object without an annotation.
Json to_json(const models::ClipSummary& clip);

}  // namespace flinch::program
