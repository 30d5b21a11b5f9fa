// SPDX-License-Identifier: MIT
#include "database/library/library_file.h"

#include <cstdint>
#include <new>
#include <utility>
#include <vector>

#include "database/library/library_bounds.h"
#include "database/library/library_layout.h"
#include "database/library/unfolded_size.h"
#include "library_generated.h"

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

bool read_clip(const schema::Clip& stored, float rate_hz, motion::Clip& clip) {
  clip.name = stored.name()->str();
  clip.purpose = static_cast<motion::Purpose>(stored.purpose());
  clip.kind = stored.kind()->str();
  clip.source = stored.source()->str();
  clip.mirrored_from = stored.mirrored_from()->str();
  if (stored.annotation() != nullptr) clip.annotation = annotation_of(*stored.annotation());
  if (stored.push() != nullptr) clip.push = push_of(*stored.push());
  clip.motion.rate_hz = rate_hz;
  return read_poses(*stored.poses(), clip.motion.poses);
}

/// Whether counts are within their bounds, and no more is read than the file holds.
bool has_bounded_size(const schema::Library& stored, std::size_t content_size) {
  if (stored.clips()->size() > kMaxClips) return false;
  UnfoldedSize unfolded;
  unfolded.add(stored.provenance())
      .add(stored.name())
      .add(stored.character()->offsets())
      .add(stored.character()->tips());
  for (const schema::Clip* clip : *stored.clips()) {
    unfolded.add(clip->name()).add(clip->kind()).add(clip->source());
    unfolded.add(clip->mirrored_from()).add(clip->poses());
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
  return true;
}

LoadStatus read_unsealed(const VerifiedFile& file, ClipLibrary& library) {
  if (file.status != LoadStatus::ok) return file.status;
  flatbuffers::Verifier verifier(reinterpret_cast<const std::uint8_t*>(file.content.data()),
                                 file.content.size());
  if (!schema::VerifyLibraryBuffer(verifier)) return LoadStatus::damaged;
  const schema::Library& stored = *schema::GetLibrary(file.content.data());
  ClipLibrary read;
  if (!has_bounded_size(stored, file.content.size()) || !read_stored(stored, read) ||
      fault_of(read) || format_of(read).version != file.version) {
    return LoadStatus::damaged;
  }
  read.hash = read.provenance.empty() ? file.hash : stored.bare_hash();
  library = std::move(read);
  return LoadStatus::ok;
}

}  // namespace

FileFormat format_of(const ClipLibrary& library) {
  FileFormat format = kLibraryFormat;
  if (stance_clips(library).size() > 1) format.version = format.newest_read;
  return format;
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
  return read_unsealed(verify_embedded_file(kLibraryFormat, aligned(bytes, storage)), library);
} catch (const std::bad_alloc&) {
  return LoadStatus::out_of_memory;
}

LoadStatus read_library(const std::string& path, ClipLibrary& library) noexcept {
  std::vector<std::byte> bytes;
  const LoadStatus status = read_bytes(path, bytes);
  return status == LoadStatus::ok ? read_library(bytes, library) : status;
}

}  // namespace flinch::database
