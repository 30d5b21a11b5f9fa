// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "models/selector.h"

namespace flinch::program {

/// JSON with its keys in the order that they were written in.
using Json = nlohmann::ordered_json;

/// Writes the one document that --json prints.
void print(const Json& document);
/// Writes a document as one line of several, at once.
void print_line(const Json& document);

/// Degrees from radians, rounded to the millionth that floats leave sure.
double rounded_degrees(double radians);

/// The double with the fewest digits that is this float, so that JSON shows 0.4 and not
/// 0.4000000059604645.
double shortest(float value);

/// A clip's annotation with its keys as in the design; empty without an annotation.
Json to_json(const models::ClipSummary& clip);

}  // namespace flinch::program
