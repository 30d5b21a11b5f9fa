// SPDX-License-Identifier: MIT
#include "database/import/scene.h"

#include <assimp/BaseImporter.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "database/files/file_io.h"
#include "database/files/file_kind.h"
#include "database/files/text_encoding.h"
#include "database/import/fbx_bytes.h"
#include "motion/error.h"

namespace flinch::database {
namespace {

namespace fs = std::filesystem;

// Assimp needs several times as much memory as the files have bytes.
constexpr std::size_t kMaxBytes = std::size_t{256} << 20;
constexpr std::size_t kMaxNodes = 65'536;

/// Bytes that it owns.
class OwnedStream : public Assimp::MemoryIOStream {
 public:
  explicit OwnedStream(std::unique_ptr<std::string> bytes)
      : MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes->data()), bytes->size()),
        bytes_(std::move(bytes)) {}

 private:
  std::unique_ptr<std::string> bytes_;
};

/// Lets Assimp read a file and what lies in its folder or below, and nothing else: a scene of
/// unknown origin may name any path.
class FolderSystem : public Assimp::IOSystem {
 public:
  explicit FolderSystem(const std::string& path)
      : folder_(fs::weakly_canonical(fs::absolute(path).parent_path())) {}

  bool Exists(const char* path) const override { return allowed(path).has_value(); }
  char getOsSeparator() const override { return '/'; }

  Assimp::IOStream* Open(const char* path, const char* mode) override {
    const std::optional<fs::path> file = allowed(path);
    if (!file || std::string_view(mode).find('w') != std::string_view::npos) return nullptr;
    bytes_left_ -= std::min(bytes_left_, static_cast<std::size_t>(fs::file_size(*file)));
    if (bytes_left_ == 0) throw Error(file->string(), "is too large with what it refers to");
    return new OwnedStream(std::make_unique<std::string>(read_file(file->string())));
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::optional<fs::path> allowed(const char* path) const {
    std::error_code ignored;
    const fs::path file = fs::weakly_canonical(fs::absolute(path), ignored);
    const auto [end, at] = std::mismatch(folder_.begin(), folder_.end(), file.begin(), file.end());
    if (end != folder_.end() || !fs::is_regular_file(file, ignored)) return std::nullopt;
    return file;
  }

  fs::path folder_;
  std::size_t bytes_left_ = kMaxBytes;
};

bool is_wanted(const Assimp::BaseImporter& reader) {
  const std::string_view extensions = reader.GetInfo()->mFileExtensions;
  return extensions.find("fbx") != std::string_view::npos ||
         extensions.find("gltf") != std::string_view::npos;
}

// The readers of forty other formats would be tried on files that only look like FBX or glTF.
void remove_other_readers(Assimp::Importer& importer) {
  std::vector<Assimp::BaseImporter*> others;
  for (std::size_t i = 0; i < importer.GetImporterCount(); ++i) {
    if (!is_wanted(*importer.GetImporter(i))) others.push_back(importer.GetImporter(i));
  }
  for (Assimp::BaseImporter* reader : others) {
    importer.UnregisterLoader(reader);
    delete reader;
  }
}

// What is not needed is not read. Without pivots Assimp 5.2.5 composes FBX transforms itself, but
// does not invert post-rotations.
void set_options(Assimp::Importer& importer) {
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_FBX_PRESERVE_PIVOTS, true);
  for (const char* unused :
       {AI_CONFIG_IMPORT_FBX_READ_ALL_GEOMETRY_LAYERS, AI_CONFIG_IMPORT_FBX_READ_ALL_MATERIALS,
        AI_CONFIG_IMPORT_FBX_READ_MATERIALS, AI_CONFIG_IMPORT_FBX_READ_TEXTURES,
        AI_CONFIG_IMPORT_FBX_READ_CAMERAS, AI_CONFIG_IMPORT_FBX_READ_LIGHTS}) {
    importer.SetPropertyBool(unused, false);
  }
}

// --- From Assimp's types to ours ---

constexpr std::string_view kHelper = "_$AssimpFbx$_";

Eigen::Vector3d vector_of(const aiVector3D& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Eigen::Affine3d transform_of(const aiMatrix4x4& m) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  for (unsigned row = 0; row < 3; ++row) {
    for (unsigned column = 0; column < 4; ++column) {
      transform.matrix()(row, column) = static_cast<double>(m[row][column]);
    }
  }
  return transform;
}

std::string_view view_of(const aiString& text) {
  return {text.data, text.length};
}

class SceneMaker {
 public:
  SceneMaker(const aiScene& from, const std::string& path) : from_(from) { scene_.path = path; }

  Scene scene() {
    add_nodes();
    mark_bones();
    add_animation();
    resolve_helpers();
    remove_geometric_helpers();
    check_numbers();
    return std::move(scene_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw Error(scene_.path, what); }

  void add_nodes() {
    SceneNode world;  // above the file's root, which may be animated
    world.local = to_metres_y_up();
    scene_.nodes.push_back(world);
    std::vector<std::pair<const aiNode*, int>> waiting{{from_.mRootNode, 0}};
    while (!waiting.empty()) {
      const auto [from, parent] = waiting.back();
      waiting.pop_back();
      if (scene_.nodes.size() == kMaxNodes) {
        fail("has more than " + std::to_string(kMaxNodes) + " nodes");
      }
      const std::string_view name = view_of(from->mName);
      SceneNode node;
      node.name = printable_text(name);
      if (!is_utf8(name)) warn_of_encoding();
      node.parent = parent;
      node.local = transform_of(from->mTransformation);
      node.has_mesh = from->mNumMeshes > 0;
      node.is_helper = name.find(kHelper) != std::string_view::npos;
      if (!index_.emplace(name, scene_.nodes.size()).second) repeated_.emplace(name);
      scene_.nodes.push_back(std::move(node));
      // The last child first: nodes keep the file's order.
      for (unsigned i = from->mNumChildren; i > 0; --i) {
        waiting.emplace_back(from->mChildren[i - 1], static_cast<int>(scene_.nodes.size()) - 1);
      }
    }
  }

  void warn_of_encoding() {
    if (std::exchange(has_guessed_encoding_, true)) return;
    scene_.warnings.emplace_back("names that are not UTF-8 are read as Latin-1");
  }

  // Assimp's skins and animations tell nodes by their names.
  SceneNode* node_named(std::string_view name) {
    if (repeated_.contains(name)) {
      fail("has several nodes named `" + printable_text(name) +
           "`, of which one moves; give each its own name");
    }
    const auto found = index_.find(name);
    return found == index_.end() ? nullptr : &scene_.nodes[found->second];
  }

  void mark_bones() {
    for (unsigned m = 0; m < from_.mNumMeshes; ++m) {
      for (unsigned b = 0; b < from_.mMeshes[m]->mNumBones; ++b) {
        SceneNode* node = node_named(view_of(from_.mMeshes[m]->mBones[b]->mName));
        if (node != nullptr) node->is_bone = true;
      }
    }
  }

  const aiAnimation& longest_animation() {
    const auto seconds = [](const aiAnimation* one) {
      return one->mDuration / (one->mTicksPerSecond > 0 ? one->mTicksPerSecond : 1);
    };
    const auto begin = from_.mAnimations;
    const auto end = begin + from_.mNumAnimations;
    if (begin == end) fail("has no animation");
    const aiAnimation* longest = *std::max_element(
        begin, end, [&](auto one, auto other) { return seconds(one) < seconds(other); });
    if (from_.mNumAnimations > 1) {
      scene_.warnings.push_back("of its " + std::to_string(from_.mNumAnimations) +
                                " animations the longest is taken, \"" +
                                printable_text(view_of(longest->mName)) +
                                "\"; save the others as files of their own");
    }
    return *longest;
  }

  // Assimp 5.2.5 takes the bytes of glTF rotations that are kept as integers for floats, which
  // gives anything but unit quaternions (findings/assimp_gltf_short_rotations.sh).
  Eigen::Quaterniond rotation_of(const aiQuaternion& q, const SceneNode& node) const {
    const Eigen::Quaterniond rotation(static_cast<double>(q.w), static_cast<double>(q.x),
                                      static_cast<double>(q.y), static_cast<double>(q.z));
    if (!(std::abs(rotation.norm() - 1) < 0.1)) {
      fail("`" + node.name +
           "` has rotations that are no unit quaternions; if the file keeps them as integers, save "
           "it with floats");
    }
    return rotation.normalized();
  }

  void add_animation() {
    const aiAnimation& animation = longest_animation();
    const double ticks_per_s = animation.mTicksPerSecond > 0 ? animation.mTicksPerSecond : 1;
    for (unsigned i = 0; i < animation.mNumChannels; ++i) {
      const aiNodeAnim& from = *animation.mChannels[i];
      const std::string_view name = view_of(from.mNodeName);
      SceneNode* node = node_named(name);
      if (node == nullptr) continue;
      SceneTrack& track = node->track;
      for (unsigned k = 0; k < from.mNumPositionKeys; ++k) {
        track.position_times_s.push_back(from.mPositionKeys[k].mTime / ticks_per_s);
        track.positions.push_back(vector_of(from.mPositionKeys[k].mValue));
      }
      for (unsigned k = 0; k < from.mNumRotationKeys; ++k) {
        track.rotation_times_s.push_back(from.mRotationKeys[k].mTime / ticks_per_s);
        track.rotations.push_back(rotation_of(from.mRotationKeys[k].mValue, *node));
      }
      for (unsigned k = 0; k < from.mNumScalingKeys; ++k) {
        track.scale_times_s.push_back(from.mScalingKeys[k].mTime / ticks_per_s);
        track.scales.push_back(vector_of(from.mScalingKeys[k].mValue));
      }
      SceneNode* moved = node_named(name.substr(0, name.find(kHelper)));
      (moved != nullptr ? moved : node)->is_animated = true;
    }
  }

  // Assimp 5.2.5 splits the transform of an FBX node with a pre- or post-rotation into helper nodes
  // above it, but where only translation, rotation and scale have curves it gives the node itself
  // keys of the whole product, T Pre R Post: the helpers must not act a second time. FBX defines T
  // Pre R Post^-1; the helper of the post-rotation, H = Post^-1, makes Post H H of Post.
  void resolve_helpers() {
    for (SceneNode& node : scene_.nodes) {
      if (node.is_helper || node.track.rotations.empty()) continue;
      const std::vector<SceneNode*> helpers = helpers_of(node);
      const bool are_separate = std::ranges::any_of(
          helpers, [](const SceneNode* helper) { return !helper->track.rotations.empty(); });
      if (are_separate) continue;
      for (SceneNode* helper : helpers) {
        if (helper->name.ends_with("_PostRotation")) {
          const Eigen::Quaterniond inverse(helper->local.linear());
          for (auto& rotation : node.track.rotations) rotation = rotation * inverse * inverse;
        }
        helper->track = identity_track();
      }
    }
  }

  // The geometric transform of an FBX node moves its mesh alone, not its joint and its children.
  // Assimp 5.2.5 puts helpers for it above the node and inverse ones above the children.
  void remove_geometric_helpers() {
    for (SceneNode& node : scene_.nodes) {
      if (node.is_helper && node.name.find("_Geometric") != std::string::npos) {
        node.local = Eigen::Affine3d::Identity();
      }
    }
  }

  // The nodes directly above that are parts of this one's transform.
  std::vector<SceneNode*> helpers_of(const SceneNode& node) {
    std::vector<SceneNode*> helpers;
    for (int i = node.parent; i > 0;) {
      SceneNode& above = scene_.nodes[static_cast<std::size_t>(i)];
      if (!above.is_helper || !above.name.starts_with(node.name + std::string(kHelper))) break;
      helpers.push_back(&above);
      i = above.parent;
    }
    return helpers;
  }

  static SceneTrack identity_track() {
    SceneTrack track;
    track.position_times_s = track.rotation_times_s = track.scale_times_s = {0};
    track.positions = {Eigen::Vector3d::Zero()};
    track.rotations = {Eigen::Quaterniond::Identity()};
    track.scales = {Eigen::Vector3d::Ones()};
    return track;
  }

  template <class Number>
  std::optional<Number> metadata(const char* key) const {
    Number value{};
    if (from_.mMetaData == nullptr || !from_.mMetaData->Get(key, value)) return std::nullopt;
    return value;
  }

  // An FBX file says how many centimetres its unit has, which axis points up, and whether the axis
  // or its opposite does. glTF has neither: it is in metres, Y up.
  Eigen::Affine3d to_metres_y_up() const {
    const std::optional<std::int32_t> axis = metadata<std::int32_t>("UpAxis");
    if (!axis) return Eigen::Affine3d::Identity();
    // A number in the file may have either width.
    const std::optional<float> narrow = metadata<float>("UnitScaleFactor");
    const double centimetres =
        narrow ? static_cast<double>(*narrow) : metadata<double>("UnitScaleFactor").value_or(1);
    if (*axis < 0 || *axis > 2 || !(centimetres > 0)) fail("has no valid up axis or unit");
    const double sign = metadata<std::int32_t>("UpAxisSign").value_or(1) < 0 ? -1 : 1;
    return Eigen::Affine3d(Eigen::Quaterniond::FromTwoVectors(sign * Eigen::Vector3d::Unit(*axis),
                                                              Eigen::Vector3d::UnitY())) *
           Eigen::Scaling(0.01 * centimetres);
  }

  // Keys come from a stranger: times must rise, numbers be finite.
  void check_numbers() const {
    for (const SceneNode& node : scene_.nodes) {
      const SceneTrack& track = node.track;
      bool is_finite = node.local.matrix().allFinite();
      for (const auto* times :
           {&track.position_times_s, &track.rotation_times_s, &track.scale_times_s}) {
        if (!std::is_sorted(times->begin(), times->end())) {
          fail("the keys of `" + node.name + "` are not in the order of time");
        }
        for (const double time_s : *times) is_finite = is_finite && std::isfinite(time_s);
      }
      for (const auto& value : track.positions) is_finite = is_finite && value.allFinite();
      for (const auto& value : track.rotations) is_finite = is_finite && value.coeffs().allFinite();
      for (const auto& value : track.scales) is_finite = is_finite && value.allFinite();
      if (!is_finite) fail("`" + node.name + "` has numbers that are not finite");
    }
  }

  const aiScene& from_;
  Scene scene_;
  std::map<std::string, std::size_t, std::less<>> index_;
  std::set<std::string, std::less<>> repeated_;  // names of several nodes
  bool has_guessed_encoding_ = false;
};

// Assimp does not add animation layers: of two that move one joint it keeps the later. It reads an
// order of rotations that is none of Euler angles as no turn at all, and rotations that are
// switched off as any others. It tells nothing of all that.
void check_fbx(std::string_view bytes, const std::string& path, Scene& scene) {
  if (has_animation_layers(bytes)) {
    scene.warnings.emplace_back(
        "has animation layers, which are not added: where several move one joint, one of them is "
        "read; merge them, or bake the motion into one");
  }
  const std::vector<FbxRotationRules> nodes = fbx_rotation_rules(bytes);
  for (const FbxRotationRules& node : nodes) {
    if (node.has_euler_order()) continue;
    throw Error(path, "`" + node.name +
                          "` has a rotation order that is not one of Euler angles, such as spheric "
                          "XYZ, and cannot be read; set it to Euler XYZ and bake the motion");
  }
  const auto is_unclear = [](const FbxRotationRules& node) {
    return !node.name.empty() && !node.is_active && (node.is_turned_else || node.order != 0);
  };
  if (const auto node = std::ranges::find_if(nodes, is_unclear); node != nodes.end()) {
    scene.warnings.push_back(
        "`" + node->name +
        "` has a rotation order or a pre- or post-rotation that is switched off (RotationActive) "
        "and is read all the same; where the pose is wrong, switch it on or bake the motion");
  }
}

}  // namespace

Scene read_scene(const std::string& path) {
  Assimp::Importer importer;
  remove_other_readers(importer);
  set_options(importer);
  importer.SetIOHandler(new FolderSystem(path));  // which the importer deletes
  const aiScene* scene = nullptr;
  try {
    scene = importer.ReadFile(path, 0);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(path, "cannot be read: " + printable_text(error.what()));
  }
  if (scene == nullptr || scene->mRootNode == nullptr) {
    throw Error(path, "cannot be read: " + printable_text(importer.GetErrorString()));
  }
  Scene made = SceneMaker(*scene, path).scene();
  if (const std::string bytes = read_file(path); file_kind_of(bytes) == FileKind::fbx)
    check_fbx(bytes, path, made);
  return made;
}

}  // namespace flinch::database
