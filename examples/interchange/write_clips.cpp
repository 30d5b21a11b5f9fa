// SPDX-License-Identifier: MIT
// Writes some clips of a selector as FOLDER/clips.glb, and as FOLDER/joints.json where Flinch's own
// kinematics have each joint, at keys and between them: write_clips SELECTOR FOLDER
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "database/export/clip_export.h"
#include "database/export/y_up.h"
#include "database/files/file_io.h"
#include "motion/error.h"
#include "runtime/library.h"

namespace {

using namespace flinch;
using Json = nlohmann::ordered_json;

constexpr std::size_t kEvery = 20;  // clips from one that is written to the next

Json joints_at(const motion::Skeleton& skeleton, const motion::Pose& pose) {
  const motion::JointFrames frames = forward_kinematics(skeleton, pose);
  Json joints;
  for (const motion::Role role : motion::kRoles) {
    const Eigen::Vector3f place = database::to_y_up(frames.position[role]);
    joints[std::string(motion::name_of(role))] = {place.x(), place.y(), place.z()};
  }
  return joints;
}

void write(const std::string& selector, const std::filesystem::path& folder) {
  runtime::Library library;
  if (library.load(selector) != database::LoadStatus::ok)
    throw Error(selector, "is no selector with clips");
  const motion::Physique& character = library.clip_library().character;
  std::vector<database::NamedMotion> clips;
  Json samples = Json::array();
  const std::vector<database::NamedMotion> all = database::exported_clips(library.clip_library());
  for (std::size_t i = 0; i < all.size(); i += kEvery) {
    const motion::Motion& motion = clips.emplace_back(all[i]).motion;
    for (const float share : {0.0F, 0.31F, 0.5F, 0.77F, 1.0F}) {
      const float time_s = share * motion.duration_s();
      samples.push_back({{"animation", all[i].name},
                         {"time_s", time_s},
                         {"joints", joints_at(character.skeleton, sample(motion, time_s))}});
    }
  }
  database::write_glb((folder / "clips.glb").string(), character, clips);
  database::write_file_atomically((folder / "joints.json").string(), samples.dump(1));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) {
    std::fprintf(stderr, "usage: write_clips SELECTOR FOLDER\n");
    return 2;
  }
  try {
    std::filesystem::create_directories(arguments[2]);
    write(arguments[1], arguments[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_clips: %s\n", error.what());
    return 1;
  }
  return 0;
}
