// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "database/import/source_motion.h"
#include "motion/clip.h"
#include "motion/figure.h"

namespace flinch::database {

/// A raw recording, ready to be analysed: its motion on a figure with the source's proportions and
/// a stature of 1.75 m, so that every threshold of the analysis is a length on one human size.
struct Take {
  SourceReport source;
  motion::Figure figure;
  motion::Motion motion;  ///< at 60 Hz; Z up, the ground at 0, m
  double start_s = 0;     ///< of the motion's first pose, from the start of the file
};

/// Reads a take. Where the file begins with a pose that the body cannot leave so fast, as many
/// exporters put a T-pose before the recording, the motion begins after it.
///
/// Throws Error for a file that is no BVH, FBX or glTF file, holds no human figure or only one
/// frame.
Take read_take(const std::string& path, const SourceOptions& options = {});

}  // namespace flinch::database
