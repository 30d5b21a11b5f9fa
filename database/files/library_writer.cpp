// SPDX-License-Identifier: MIT
#include "database/files/library_writer.h"

#include <algorithm>
#include <span>
#include <vector>

#include "database/files/file_io.h"
#include "database/files/file_kind.h"
#include "database/files/pose_packer.h"
#include "database/files/text_encoding.h"
#include "database/library/library_file.h"
#include "database/library/library_layout.h"
#include "database/library/pose_grid.h"
#include "library_generated.h"
#include "motion/error.h"
#include "motion/mirror.h"

namespace flinch::database {
namespace {

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;

void append(const Eigen::Vector3f& vector, std::vector<float>& floats) {
  floats.insert(floats.end(), vector.begin(), vector.end());
}

std::vector<float> floats_of(const motion::PerRole<Eigen::Vector3f>& vectors) {
  std::vector<float> floats;
  floats.reserve(kFloatsPerSkeletonVector);
  for (const Eigen::Vector3f& vector : vectors) append(vector, floats);
  return floats;
}

std::vector<float> floats_of(const std::vector<motion::Pose>& poses) {
  std::vector<float> floats;
  floats.reserve(poses.size() * kFloatsPerPose);
  for (const motion::Pose& pose : poses) {
    append(pose.root_position, floats);
    for (const Eigen::Quaternionf& rotation : pose.rotation) {
      floats.push_back(rotation.w());
      append(rotation.vec(), floats);
    }
  }
  return floats;
}

Offset<schema::Annotation> store(FlatBufferBuilder& builder, const motion::Annotation& annotation) {
  return schema::CreateAnnotation(builder, static_cast<std::uint8_t>(annotation.target),
                                  static_cast<std::uint8_t>(annotation.degree),
                                  annotation.direction, annotation.onset_s, annotation.peak_s,
                                  annotation.end_s);
}

Offset<schema::Push> store(FlatBufferBuilder& builder, const motion::Push& push) {
  return schema::CreatePush(builder, push.contact_s, push.peak_s,
                            static_cast<std::uint8_t>(push.place), push.direction,
                            push.velocity.x(), push.velocity.y(), push.velocity.z());
}

/// How a file of format 4 has a clip's poses: packed, or as the mirror image of another clip's.
struct StoredPoses {
  std::vector<std::uint8_t> packed;
  std::optional<std::uint32_t> mirror_of;
};

bool are_same(const std::vector<motion::Pose>& a, const std::vector<motion::Pose>& b) {
  return std::ranges::equal(a, b, motion::has_same_bits);
}

/// The index of the clip that `clip` says it mirrors, if its poses are the mirror images.
std::optional<std::uint32_t> original_of(const ClipLibrary& library, const motion::Clip& clip) {
  const auto named = std::ranges::find(library.clips, clip.mirrored_from, &motion::Clip::name);
  if (named == library.clips.end() || !named->mirrored_from.empty()) return std::nullopt;
  std::vector<motion::Pose> mirrored = motion::mirrored(*named).motion.poses;
  std::ranges::for_each(mirrored, make_zeros_positive);
  if (!are_same(clip.motion.poses, mirrored)) return std::nullopt;
  return static_cast<std::uint32_t>(named - library.clips.begin());
}

/// How each clip is stored in format 4; none unless all poses are on the grid.
std::optional<std::vector<StoredPoses>> packed(const ClipLibrary& library) {
  std::vector<StoredPoses> stored;
  for (const motion::Clip& clip : library.clips) {
    std::optional<std::vector<std::uint8_t>> own = pack_poses(clip.motion.poses);
    if (!own) return std::nullopt;
    StoredPoses& poses = stored.emplace_back();
    poses.mirror_of = original_of(library, clip);
    if (!poses.mirror_of) poses.packed = std::move(*own);
  }
  return stored;
}

// Each part is stored in a statement of its own: the order in which arguments are evaluated is
// unspecified, and the bytes must not depend on it. Without `stored`, the poses are floats.
Offset<schema::Clip> store(FlatBufferBuilder& builder, const motion::Clip& clip,
                           const StoredPoses* stored) {
  const auto name = builder.CreateString(clip.name);
  const auto kind = builder.CreateString(clip.kind);
  const auto source = builder.CreateString(clip.source);
  const auto mirrored_from = builder.CreateString(clip.mirrored_from);
  Offset<schema::Annotation> annotation;
  if (clip.annotation) annotation = store(builder, *clip.annotation);
  Offset<flatbuffers::Vector<float>> poses;
  Offset<flatbuffers::Vector<std::uint8_t>> packed;
  flatbuffers::Optional<std::uint32_t> mirror_of;
  if (stored == nullptr) {
    poses = builder.CreateVector(floats_of(clip.motion.poses));
  } else if (stored->mirror_of) {
    mirror_of = *stored->mirror_of;
  } else {
    packed = builder.CreateVector(stored->packed);
  }
  Offset<schema::Push> push;
  if (clip.push) push = store(builder, *clip.push);
  return schema::CreateClip(builder, name, static_cast<std::uint8_t>(clip.purpose), kind, source,
                            mirrored_from, annotation, poses, push, packed, mirror_of);
}

Offset<schema::Character> store(FlatBufferBuilder& builder, const motion::Physique& character) {
  const auto offsets = builder.CreateVector(floats_of(character.skeleton.offset));
  const auto tips = builder.CreateVector(floats_of(character.skeleton.tip));
  return schema::CreateCharacter(builder, offsets, tips, character.mass_kg,
                                 static_cast<std::uint8_t>(character.sex));
}

/// What a file holds beside the library.
struct Origin {
  std::string_view provenance;
  std::uint64_t bare_hash = 0;
};

std::string content_of(const ClipLibrary& library, const Origin& origin,
                       const std::vector<StoredPoses>* poses) {
  FlatBufferBuilder builder;
  const auto name = builder.CreateString(library.name);
  const auto character = store(builder, library.character);
  std::vector<Offset<schema::Clip>> stored;
  for (std::size_t i = 0; i < library.clips.size(); ++i)
    stored.push_back(store(builder, library.clips[i], poses != nullptr ? &(*poses)[i] : nullptr));
  const auto clips = builder.CreateVector(stored);
  Offset<flatbuffers::String> provenance;
  if (!origin.provenance.empty()) provenance = builder.CreateString(origin.provenance);
  schema::FinishLibraryBuffer(
      builder, schema::CreateLibrary(builder, name, character, library.rate_hz,
                                     static_cast<std::uint32_t>(library.idle), clips, provenance,
                                     origin.bare_hash));
  return {reinterpret_cast<const char*>(builder.GetBufferPointer()), builder.GetSize()};
}

std::string sealed(std::uint8_t version, const std::string& content) {
  FileFormat format = kLibraryFormat;
  format.version = version;
  const auto header = make_file_header(format, bytes_of(content));
  std::string bytes(header.size(), '\0');
  std::ranges::transform(header, bytes.begin(),
                         [](std::byte byte) { return static_cast<char>(byte); });
  return bytes.append(content);
}

// Half of the largest file that is read leaves room for everything except poses.
constexpr std::size_t kMaxLibraryPoses = kMaxFileSize / 2 / (kFloatsPerPose * sizeof(float));

std::size_t poses_in(const ClipLibrary& library) {
  std::size_t count = 0;
  for (const motion::Clip& clip : library.clips) count += clip.motion.poses.size();
  return count;
}

std::string text_of(const ClipLibrary& library, const LibraryFault& fault) {
  if (!fault.clip) return fault.what;
  return "clip " + std::to_string(*fault.clip) + " (" +
         printable_text(library.clips[*fault.clip].name) + ") " + fault.what;
}

std::string sealed_bytes(const ClipLibrary& library) {
  if (const auto stored = packed(library)) {
    const std::string content = content_of(library, {}, &*stored);
    // Readers refuse more, which only a library of half an hour without motion can have.
    if (poses_in(library) * sizeof(motion::Pose) <= max_unpacked_size(content.size()))
      return sealed(kPackedVersion, content);
  }
  return sealed(float_version_of(library), content_of(library, {}, nullptr));
}

std::uint64_t hash_of_content(const std::string& file) {
  return content_hash(bytes_of(file).subspan(kFileHeaderSize));
}

/// The library's file `bare` with its provenance, and poses stored as they are there.
std::string with_provenance(const ClipLibrary& library, const std::string& bare) {
  const Origin origin{library.provenance, hash_of_content(bare)};
  const auto version = static_cast<std::uint8_t>(bare[kLibraryFormat.magic.size()]);
  if (version != kPackedVersion) return sealed(version, content_of(library, origin, nullptr));
  const auto stored = packed(library);
  return sealed(version, content_of(library, origin, &*stored));
}

}  // namespace

std::string bare_library_bytes(const ClipLibrary& library) {
  const std::string where = "library " + printable_text(library.name);
  if (const auto fault = fault_of(library)) {
    throw Error(where, "cannot be written: " + text_of(library, *fault));
  }
  if (poses_in(library) > kMaxLibraryPoses) {
    throw Error(where, "cannot be written: holds more than " + std::to_string(kMaxLibraryPoses) +
                           " poses; split it");
  }
  return sealed_bytes(library);
}

std::string library_bytes(const ClipLibrary& library) {
  const std::string bare = bare_library_bytes(library);
  if (library.provenance.empty()) return bare;
  return with_provenance(library, bare);
}

std::uint64_t write_library(const ClipLibrary& library, const std::string& path) {
  const std::string bare = bare_library_bytes(library);
  write_file_atomically(path, library.provenance.empty() ? bare : with_provenance(library, bare));
  return hash_of_content(bare);
}

ClipLibrary load_library(const std::string& path) {
  const std::string bytes = read_file(path);
  ClipLibrary library;
  const LoadStatus status = read_library(bytes_of(bytes), library);
  if (status == LoadStatus::ok) return library;
  if (status == LoadStatus::not_a_library) {
    throw Error(path, "is " + std::string(name_of(file_kind_of(bytes))) +
                          ", not a library; `flinch import` makes one");
  }
  throw Error(path, "the library " + refusal_of(status, kLibraryFormat, bytes) + "; make it again");
}

}  // namespace flinch::database
