// SPDX-License-Identifier: MIT
#pragma once

namespace flinch::features {

// Functions whose results have the same bits on every processor. Those of glibc have not: it
// selects versions with fused multiply-add where the processor has that, and they round otherwise.
// Used where bits are promised; elsewhere the standard library is as good.

/// Returns e^x within 1.2 units in the last place; 0 for x below -708. `x` is at most 709.
double portable_exp(double x);

/// Returns the natural logarithm of a finite x above 0, within 3 units in the last place.
double portable_log(double x);

/// Returns cos(2 pi turns) within 2e-16, for turns in [0, 1].
double cos_of_turns(double turns);

}  // namespace flinch::features
