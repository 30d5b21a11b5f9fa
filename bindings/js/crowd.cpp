// SPDX-License-Identifier: MIT
// A crowd in C.
#include "reaction/crowd/crowd.h"

#include <memory>
#include <new>
#include <utility>

#include "bindings/js/exports.h"
#include "runtime/c/c_check.h"
#include "runtime/c/c_objects.h"
#include "runtime/c/c_values.h"
#include "runtime/push/push_search.h"

namespace reaction = flinch::reaction;
namespace runtime = flinch::runtime;
using runtime::check;

struct flinch_crowd : runtime::HandleHeader {
  static constexpr std::uint32_t kMark = 0xF11C0008;
  struct Content {
    Content(runtime::SharedLibrary of, std::shared_ptr<const runtime::MotionGraph> ways,
            std::uint32_t seed)
        : library(std::move(of)),
          graph(std::move(ways)),
          crowd(*library, *graph, {.seed = seed}),
          skeleton(library->clip_library().character.skeleton) {}
    runtime::SharedLibrary library;
    std::shared_ptr<const runtime::MotionGraph> graph;
    reaction::Crowd crowd;
    const flinch::motion::Skeleton& skeleton;
  };
  explicit flinch_crowd(std::unique_ptr<Content> made)
      : HandleHeader(kMark), content(std::move(made)) {}

  std::unique_ptr<Content> content;
};

flinch_status flinch_crowd_create(const flinch_library* library, uint32_t seed,
                                  flinch_crowd** out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  *out = nullptr;
  if (const flinch_status status = check(library)) return status;
  const runtime::Library& content = *library->content;
  if (content.push_responses().responses.empty() || content.push_model().realism == nullptr)
    return FLINCH_WITHOUT_PUSHES;
  auto graph = runtime::make_motion_graph(content);
  if (!graph) return FLINCH_OUT_OF_MEMORY;
  return runtime::make_handle(out, [&] {
    return std::make_unique<flinch_crowd::Content>(library->content, std::move(graph), seed);
  });
}

flinch_status flinch_crowd_free(flinch_crowd* crowd) {
  return runtime::free_handle(crowd);
}

flinch_status flinch_crowd_update(flinch_crowd* crowd, float dt_s) try {
  if (const flinch_status status = check(crowd)) return status;
  if (!(dt_s > 0 && double{dt_s} <= reaction::kMaxReactionFrame_s)) return FLINCH_BAD_TIME;
  crowd->content->crowd.update(dt_s);
  return FLINCH_OK;
} catch (const std::bad_alloc&) {
  return FLINCH_OUT_OF_MEMORY;
}

flinch_status flinch_crowd_describe(const flinch_crowd* crowd, flinch_crowd_state* out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = check(crowd)) return status;
  const reaction::Crowd& of = crowd->content->crowd;
  const auto counted = [](std::size_t count) { return static_cast<std::int32_t>(count); };
  *out = {.characters = counted(of.characters().size()),
          .half_side_m = of.options().half_side_m,
          .bumps = counted(of.tally().bumps),
          .walls = counted(of.tally().walls),
          .answered = counted(of.tally().answered),
          .physical = counted(of.tally().physical),
          .knocked_over = counted(of.tally().knocked_over),
          .push_count = counted(of.pushes().size())};
  return FLINCH_OK;
}

flinch_status flinch_crowd_joint_frames(const flinch_crowd* crowd, int32_t character,
                                        flinch_joint_frames* out) {
  if (const flinch_status status = check(crowd, out)) return status;
  const auto& characters = crowd->content->crowd.characters();
  if (!runtime::is_index(character, characters.size())) return FLINCH_BAD_INDEX;
  const flinch::motion::Pose& pose = characters[static_cast<std::size_t>(character)].pose();
  runtime::write_struct(
      *out, runtime::to_c(flinch::motion::forward_kinematics(crowd->content->skeleton, pose)));
  return FLINCH_OK;
}

flinch_status flinch_crowd_pushed(const flinch_crowd* crowd, int32_t index,
                                  flinch_crowd_push* out) {
  if (out == nullptr) return FLINCH_NULL_POINTER;
  if (const flinch_status status = check(crowd)) return status;
  const auto& pushes = crowd->content->crowd.pushes();
  if (!runtime::is_index(index, pushes.size())) return FLINCH_BAD_INDEX;
  const reaction::CrowdPush& push = pushes[static_cast<std::size_t>(index)];
  *out = {.character = static_cast<std::int32_t>(push.character),
          .is_physical = push.is_physical ? 1 : 0,
          .at = {push.at.x(), push.at.y()},
          .velocity = {push.velocity.x(), push.velocity.y()}};
  return FLINCH_OK;
}
