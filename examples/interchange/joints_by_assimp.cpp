// SPDX-License-Identifier: MIT
// Prints where Assimp has the joints of FOLDER/clips.glb at the times of FOLDER/joints.json, as a
// JSON array with an object per sample: joints_by_assimp FOLDER
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace {

using Json = nlohmann::ordered_json;

// The value at a time between keys, blended by `blend(a, b, share)`.
template <class Key, class Blend>
auto value_at(const Key* keys, unsigned count, double time, Blend blend) {
  const Key* const next =
      std::find_if(keys, keys + count, [&](const Key& key) { return key.mTime > time; });
  if (next == keys) return keys->mValue;
  const Key* const before = next - 1;
  if (next == keys + count) return before->mValue;
  const double share = (time - before->mTime) / (next->mTime - before->mTime);
  return blend(before->mValue, next->mValue, static_cast<float>(share));
}

aiMatrix4x4 local_at(const aiNode& node, const aiAnimation& animation, double time) {
  for (unsigned i = 0; i < animation.mNumChannels; ++i) {
    const aiNodeAnim& channel = *animation.mChannels[i];
    if (channel.mNodeName != node.mName) continue;
    const aiVector3D place = value_at(
        channel.mPositionKeys, channel.mNumPositionKeys, time,
        [](const aiVector3D& a, const aiVector3D& b, float share) { return a + (b - a) * share; });
    const aiQuaternion turn =
        value_at(channel.mRotationKeys, channel.mNumRotationKeys, time,
                 [](const aiQuaternion& a, const aiQuaternion& b, float share) {
                   aiQuaternion between;
                   aiQuaternion::Interpolate(between, a, b, share);
                   return between;
                 });
    return {aiVector3D(1, 1, 1), turn, place};
  }
  return node.mTransformation;
}

void add_joints(const aiNode& node, const aiMatrix4x4& parent, const aiAnimation& animation,
                double time, Json& joints) {
  const aiMatrix4x4 world = parent * local_at(node, animation, time);
  joints[node.mName.C_Str()] = {world.a4, world.b4, world.c4};
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    add_joints(*node.mChildren[i], world, animation, time, joints);
}

const aiAnimation& animation_named(const aiScene& scene, const std::string& name) {
  const auto end = scene.mAnimations + scene.mNumAnimations;
  const auto found = std::find_if(scene.mAnimations, end, [&](const aiAnimation* animation) {
    return name == animation->mName.C_Str();
  });
  if (found == end) throw std::runtime_error("no animation " + name);
  return **found;
}

void print_joints(const std::string& folder) {
  Assimp::Importer importer;
  const aiScene* const scene = importer.ReadFile(folder + "/clips.glb", 0);
  if (scene == nullptr) throw std::runtime_error(importer.GetErrorString());
  std::ifstream file(folder + "/joints.json");
  Json result = Json::array();
  for (const Json& sample : Json::parse(file)) {
    const aiAnimation& animation = animation_named(*scene, sample.at("animation"));
    const double time = sample.at("time_s").get<double>() * animation.mTicksPerSecond;
    Json joints;
    add_joints(*scene->mRootNode, aiMatrix4x4(), animation, time, joints);
    result.push_back(std::move(joints));
  }
  std::printf("%s\n", result.dump().c_str());
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: joints_by_assimp FOLDER\n");
    return 2;
  }
  try {
    print_joints(arguments[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "joints_by_assimp: %s\n", error.what());
    return 1;
  }
  return 0;
}
