// SPDX-License-Identifier: MIT
// The library's reader. An input is a library's content; the target seals it.
#include "database/library/library_file.h"
#include "motion/interpolation.h"
#include "motion/skeleton.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flinch;
  const std::string file = tests::sealed(database::kLibraryFormat, tests::text_of(data, size));
  database::ClipLibrary library;
  if (read_library(database::bytes_of(file), library) != database::LoadStatus::ok) return 0;
  tests::require(!fault_of(library), "an accepted library has no fault");
  for (const motion::Clip& clip : library.clips) {
    const motion::Pose pose = sample(clip.motion, 0.5F * clip.motion.duration_s());
    const motion::JointFrames frames = forward_kinematics(library.character.skeleton, pose);
    for (const Eigen::Vector3f& position : frames.position)
      tests::require(position.allFinite(), "joints of an accepted library are somewhere");
  }
  return 0;
}
