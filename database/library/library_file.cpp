// SPDX-License-Identifier: MIT
#include "database/library/library_file.h"

#include <cstdint>
#include <new>
#include <utility>
#include <vector>

#include "database/library/bare_hash.h"
#include "database/library/library_bounds.h"
#include "database/library/library_check.h"
#include "database/library/library_layout.h"
#include "database/library/packed_poses.h"
#include "database/library/pose_grid.h"
#include "database/library/unfolded_size.h"
#include "library_generated.h"
#include "motion/mirror.h"

namespace flinch::database {
namespace {

/// Reads values from the front of a vector of floats.
class FloatReader {
 public:
  explicit FloatReader(const flatbuffers::Vector<float>& floats) : floats_(floats) {}

  float number() { return floats_.Get(next_++); }
  Eigen::Vector3f vector() {
    Eigen::Vector3f vector;
    for (float& component : vector) component = number();
    return vector;
  }
  Eigen::Quaternionf rotation() {
    Eigen::Quaternionf rotation;
    rotation.w() = number();
    rotation.vec() = vector();
    return rotation;
  }

 private:
  const flatbuffers::Vector<float>& floats_;
  flatbuffers::uoffset_t next_ = 0;
};

/// Returns false unless the vector has the size of one 3-vector per role.
bool read_vectors(const flatbuffers::Vector<float>& floats,
                  motion::PerRole<Eigen::Vector3f>& vectors) {
  if (floats.size() != kFloatsPerSkeletonVector) return false;
  FloatReader reader(floats);
  for (Eigen::Vector3f& vector : vectors) vector = reader.vector();
  return true;
}

bool read_poses(const flatbuffers::Vector<float>& floats, std::vector<motion::Pose>& poses) {
  if (floats.size() % kFloatsPerPose != 0) return false;
  poses.resize(floats.size() / kFloatsPerPose);
  FloatReader reader(floats);
  for (motion::Pose& pose : poses) {
    pose.root_position = reader.vector();
    for (Eigen::Quaternionf& rotation : pose.rotation) rotation = reader.rotation();
  }
  return true;
}

motion::Annotation annotation_of(const schema::Annotation& stored) {
  return {.target = static_cast<motion::Target>(stored.target()),
          .direction = stored.direction(),
          .degree = static_cast<motion::Degree>(stored.degree()),
          .onset_s = stored.onset_s(),
          .peak_s = stored.peak_s(),
          .end_s = stored.end_s()};
}

motion::Push push_of(const schema::Push& stored) {
  return {.contact_s = stored.contact_s(),
          .peak_s = stored.peak_s(),
          .place = static_cast<motion::Role>(stored.place()),
          .direction = stored.direction(),
          .velocity = {stored.velocity_x(), stored.velocity_y(), stored.velocity_z()}};
}

/// Reads the poses of a clip that is no mirror image.
bool read_own_poses(const schema::Clip& stored, std::vector<motion::Pose>& poses) {
  if (stored.packed() == nullptr) return read_poses(*stored.poses(), poses);
  return unpack_poses({stored.packed()->data(), stored.packed()->size()}, poses);
}

bool read_clip(const schema::Clip& stored, float rate_hz, motion::Clip& clip) {
  clip.name = stored.name()->str();
  clip.purpose = static_cast<motion::Purpose>(stored.purpose());
  clip.kind = stored.kind()->str();
  clip.source = stored.source()->str();
  clip.mirrored_from = stored.mirrored_from()->str();
  if (stored.annotation() != nullptr) clip.annotation = annotation_of(*stored.annotation());
  if (stored.push() != nullptr) clip.push = push_of(*stored.push());
  clip.motion.rate_hz = rate_hz;
  return stored.mirror_of() || read_own_poses(stored, clip.motion.poses);
}

void mirror_poses(const std::vector<motion::Pose>& from, std::vector<motion::Pose>& to) {
  motion::mirror(from, to);
  for (motion::Pose& pose : to) make_zeros_positive(pose);
}

using StoredClips = flatbuffers::Vector<flatbuffers::Offset<schema::Clip>>;

/// Whether each clip has its poses in the one way that the version has.
bool has_poses(const StoredClips& clips, std::uint8_t version) {
  for (const schema::Clip* clip : clips) {
    if (version < kPackedVersion) {
      if (clip->poses() == nullptr || clip->packed() != nullptr || clip->mirror_of()) return false;
      continue;
    }
    if (clip->poses() != nullptr || (clip->packed() != nullptr) == clip->mirror_of().has_value())
      return false;
    if (const auto original = clip->mirror_of())
      if (*original >= clips.size() || clips.Get(*original)->packed() == nullptr) return false;
  }
  return true;
}

/// The bytes in memory of the poses that packed clips and their mirror images claim; none if a
/// count is out of bounds. For clips that has_poses().
std::optional<std::uint64_t> unpacked_size(const StoredClips& clips) {
  std::uint64_t size = 0;  // cannot overflow: at most kMaxClips of kMaxPoses
  for (const schema::Clip* clip : clips) {
    const auto original = clip->mirror_of();
    const auto* packed = original ? clips.Get(*original)->packed() : clip->packed();
    if (packed == nullptr) continue;
    const auto count = packed_pose_count({packed->data(), packed->size()});
    if (!count || *count > kMaxPoses) return std::nullopt;
    size += std::uint64_t{*count} * sizeof(motion::Pose);
  }
  return size;
}

/// Whether counts are within their bounds, and no more is read than the file holds.
bool has_bounded_size(const schema::Library& stored, std::size_t content_size) {
  const std::optional<std::uint64_t> unpacked = unpacked_size(*stored.clips());
  if (!unpacked || *unpacked > max_unpacked_size(content_size)) return false;
  UnfoldedSize unfolded;
  unfolded.add(stored.provenance())
      .add(stored.name())
      .add(stored.character()->offsets())
      .add(stored.character()->tips());
  for (const schema::Clip* clip : *stored.clips()) {
    unfolded.add(clip->name()).add(clip->kind()).add(clip->source());
    unfolded.add(clip->mirrored_from()).add(clip->poses()).add(clip->packed());
  }
  return unfolded.is_within(content_size);
}

/// Checks what the schema's own verification does not: sizes of vectors.
bool read_stored(const schema::Library& stored, ClipLibrary& library) {
  const schema::Character& character = *stored.character();
  library.name = stored.name()->str();
  if (stored.provenance() != nullptr) library.provenance = stored.provenance()->str();
  library.character.mass_kg = character.mass_kg();
  library.character.sex = static_cast<motion::Sex>(character.sex());
  library.rate_hz = stored.rate_hz();
  if (!read_vectors(*character.offsets(), library.character.skeleton.offset) ||
      !read_vectors(*character.tips(), library.character.skeleton.tip)) {
    return false;
  }
  const auto& clips = *stored.clips();
  if (stored.idle() >= clips.size()) return false;
  library.idle = static_cast<int>(stored.idle());
  library.clips.resize(clips.size());
  for (flatbuffers::uoffset_t i = 0; i < clips.size(); ++i) {
    if (!read_clip(*clips.Get(i), library.rate_hz, library.clips[i])) return false;
  }
  for (flatbuffers::uoffset_t i = 0; i < clips.size(); ++i) {
    if (const auto original = clips.Get(i)->mirror_of())
      mirror_poses(library.clips[*original].motion.poses, library.clips[i].motion.poses);
  }
  return true;
}

LoadStatus read_unsealed(const VerifiedFile& file, ClipLibrary& library) {
  if (file.status != LoadStatus::ok) return file.status;
  flatbuffers::Verifier verifier(reinterpret_cast<const std::uint8_t*>(file.content.data()),
                                 file.content.size());
  if (!schema::VerifyLibraryBuffer(verifier)) return LoadStatus::damaged;
  const schema::Library& stored = *schema::GetLibrary(file.content.data());
  ClipLibrary read;
  if (stored.clips()->size() > kMaxClips || !has_poses(*stored.clips(), file.version) ||
      !has_bounded_size(stored, file.content.size()) || !read_stored(stored, read)) {
    return LoadStatus::damaged;
  }
  const bool is_packed = file.version >= kPackedVersion;
  if (is_packed ? fault_beside_poses(read) : fault_of(read)) return LoadStatus::damaged;
  if (!is_packed && float_version_of(read) != file.version) return LoadStatus::damaged;
  read.hash = file.hash;
  if (!read.provenance.empty()) {
    read.hash = stored.bare_hash();
    if (bare_hash_of(stored, file.content) != read.hash) return LoadStatus::other_content;
  }
  library = std::move(read);
  return LoadStatus::ok;
}

}  // namespace

std::uint8_t float_version_of(const ClipLibrary& library) {
  return stance_clips(library).size() > 1 ? kStanceVersion : kLibraryFormat.version;
}

LoadStatus read_library(std::span<const std::byte> bytes, ClipLibrary& library) noexcept try {
  std::vector<std::byte> storage;
  return read_unsealed(verify_file(kLibraryFormat, aligned(bytes, storage)), library);
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

LoadStatus read_embedded_library(std::span<const std::byte> bytes, ClipLibrary& library) noexcept
    try {
  std::vector<std::byte> storage;
  const VerifiedFile file = parse_file(kLibraryFormat, aligned(bytes, storage));
  if (file.status == LoadStatus::ok && file.hash != content_hash(file.content))
    return LoadStatus::other_content;
  return read_unsealed(file, library);
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

LoadStatus read_library(const std::string& path, ClipLibrary& library) noexcept {
  std::vector<std::byte> bytes;
  const LoadStatus status = read_bytes(path, bytes);
  return status == LoadStatus::ok ? read_library(bytes, library) : status;
}

}  // namespace flinch::database
