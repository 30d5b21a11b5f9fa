// SPDX-License-Identifier: MIT
// The library's reader. An input is a library's content; the target seals it, as of the format
// that it was written in and as of the one with packed poses.
#include "database/library/library_file.h"
#include "motion/interpolation.h"
#include "motion/skeleton.h"
#include "tests/fuzz/fuzz.h"

namespace flinch::tests {
namespace {

void read(std::uint8_t version, std::string_view content) {
  database::FileFormat format = database::kLibraryFormat;
  format.version = version;
  const std::string file = sealed(format, content);
  database::ClipLibrary library;
  if (read_library(database::bytes_of(file), library) != database::LoadStatus::ok) return;
  require(!fault_of(library), "an accepted library has no fault");
  for (const motion::Clip& clip : library.clips) {
    const motion::Pose pose = sample(clip.motion, 0.5F * clip.motion.duration_s());
    const motion::JointFrames frames = forward_kinematics(library.character.skeleton, pose);
    for (const Eigen::Vector3f& position : frames.position)
      require(position.allFinite(), "joints of an accepted library are somewhere");
  }
}

}  // namespace
}  // namespace flinch::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace flinch;
  for (const std::uint8_t version : {database::kLibraryFormat.version, database::kPackedVersion})
    tests::read(version, tests::text_of(data, size));
  return 0;
}
