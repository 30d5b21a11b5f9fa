// SPDX-License-Identifier: MIT
// Writes .glb files of all kinds into one folder and broken ones into another, for the validator:
// make_glb_samples SOUND BROKEN
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "database/export/clip_export.h"
#include "database/export/gltf_writer.h"
#include "database/files/file_io.h"
#include "motion/error.h"
#include "tests/bench/study.h"
#include "tests/scenes/synthetic_library.h"

namespace {

using namespace flinch;

// A ball that arrives, hits in the middle of the motion and is gone before its end.
database::BallTrack thrown_ball(const motion::Motion& motion) {
  database::BallTrack ball;
  const std::size_t count = motion.poses.size();
  for (std::size_t k = 0; k < count; ++k) {
    const bool is_there = 8 * k >= count && 8 * k < 7 * count;
    const float s = static_cast<float>(k) / motion.rate_hz;
    ball.positions.push_back(is_there ? std::optional(Eigen::Vector3f(4 - 5 * s, 0.1F, 1.5F))
                                      : std::nullopt);
  }
  return ball;
}

void write_samples(const std::string& folder) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const motion::Physique& character = library.character;
  for (const motion::Clip& clip : library.clips) {
    database::write_glb(folder + "/" + clip.name + ".glb", character, clip.motion,
                        thrown_ball(clip.motion));
  }
  const motion::Motion& idle = library.clips.front().motion;
  database::write_glb(folder + "/no_ball.glb", character, idle);

  motion::Motion still = idle;
  still.poses.resize(1);
  database::write_glb(folder + "/one_pose.glb", character, still);
  database::write_glb(folder + "/unseen_ball.glb", character, still,
                      database::BallTrack{0.2F, {std::nullopt}});

  database::write_glb(folder + "/all_clips.glb", character, database::exported_clips(library));

  motion::Physique child = character;
  child.mass_kg = 20;
  for (Eigen::Vector3f& offset : child.skeleton.offset) offset *= 0.6F;
  for (Eigen::Vector3f& tip : child.skeleton.tip) tip *= 0.6F;
  database::write_glb(folder + "/child.glb", child, idle);
}

// Returns the file with other numbers at the end of its data.
std::string with_last_numbers(std::string bytes, const std::vector<float>& numbers) {
  const std::size_t size = numbers.size() * sizeof(float);
  std::memcpy(bytes.data() + bytes.size() - size, numbers.data(), size);
  return bytes;
}

std::string replaced(std::string bytes, const std::string& what, const std::string& with) {
  const std::size_t place = bytes.find(what);
  if (place == std::string::npos || what.size() != with.size()) {
    throw Error("", "nothing to replace: " + what);
  }
  return bytes.replace(place, what.size(), with);
}

// Writes files with the mistakes that a writer easily makes.
void write_broken(const std::string& folder) {
  const database::ClipLibrary library = scenes::synthetic_library();
  const motion::Motion& idle = library.clips.front().motion;
  const std::vector<std::byte> glb = database::make_glb(library.character, idle, thrown_ball(idle));
  const std::string sound(reinterpret_cast<const char*>(glb.data()), glb.size());
  const auto write = [&](const std::string& name, const std::string& bytes) {
    database::write_file_atomically(folder + "/" + name + ".glb", bytes);
  };
  write("cut_short", sound.substr(0, sound.size() - 4));
  write("not_finite", with_last_numbers(sound, {std::nanf("")}));
  write("unknown_component_type", replaced(sound, "5126", "5124"));
  write("wrong_element", replaced(sound, "VEC4", "VEC3"));
  write("wrong_bound", replaced(sound, "\"max\":[0.", "\"max\":[9."));
  write("rotation_of_three_numbers", replaced(sound, "\"translation\":[", "\"rotation\":   ["));
  write("joint_twice", replaced(sound, "\"joints\":[1,2,", "\"joints\":[1,1,"));
}

}  // namespace

int main(int count, char** arguments) {
  return flinch::bench::study_main(count, arguments, {"make_glb_samples SOUND BROKEN", 2, 2},
                                   [](const flinch::bench::StudyArguments& folders) {
                                     for (std::size_t i = 0; i < 2; ++i)
                                       std::filesystem::create_directories(folders.text(i));
                                     write_samples(folders.text(0));
                                     write_broken(folders.text(1));
                                   });
}
