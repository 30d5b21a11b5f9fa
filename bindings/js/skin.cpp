// SPDX-License-Identifier: MIT
// The surface of the figure in C.
#include "motion/skin/figure_skin.h"

#include <memory>
#include <utility>

#include "bindings/js/exports.h"
#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"

namespace motion = flinch::motion;
namespace runtime = flinch::runtime;

struct flinch_skin : runtime::HandleHeader {
  static constexpr std::uint32_t kMark = 0xF11C0006;
  explicit flinch_skin(motion::FigureSkin made)
      : HandleHeader(kMark), content(std::make_unique<motion::FigureSkin>(std::move(made))) {}

  std::unique_ptr<motion::FigureSkin> content;
};

// The arrays are handed out as they are.
static_assert(FLINCH_SKIN_JOINTS == motion::kMaxSkinJoints);
static_assert(FLINCH_COVERINGS == motion::kCoveringCount);
static_assert(sizeof(motion::Role) == sizeof(std::uint8_t));
static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));

flinch_status flinch_skin_create(const flinch_library* library, flinch_skin** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = runtime::check(library)) return status;
  return runtime::make_handle(
      out, [&] { return motion::make_figure_skin(library->content->clip_library().character); });
}

flinch_status flinch_skin_free(flinch_skin* skin) {
  return runtime::free_handle(skin);
}

flinch_status flinch_skin_describe(const flinch_skin* skin, flinch_skin_mesh* out) {
  if (const flinch_status status = runtime::check(skin, out)) return status;
  const motion::FigureSkin& content = *skin->content;
  flinch_skin_mesh mesh{};
  mesh.vertex_count = static_cast<std::int32_t>(content.positions.size());
  mesh.position = content.positions.data()->data();
  mesh.normal = content.normals.data()->data();
  mesh.joint = reinterpret_cast<const std::uint8_t*>(content.joints.data());
  mesh.weight = content.weights.data()->data();
  std::size_t index = 0;
  for (const auto& triangles : content.triangles) {
    mesh.triangle[index] = triangles.data()->data();
    mesh.triangle_count[index] = static_cast<std::int32_t>(triangles.size());
    ++index;
  }
  runtime::write_struct(*out, mesh);
  return FLINCH_OK;
}
