// SPDX-License-Identifier: MIT
// Status messages and names of the C interface, which need no handle.
#include <string_view>

#include "lookahead/look_ahead.h"
#include "reaction/reaction.h"
#include "runtime/c/flinch.h"
#include "runtime/character.h"

namespace motion = flinch::motion;
namespace reaction = flinch::reaction;
namespace runtime = flinch::runtime;

namespace {

bool is_below(std::int32_t index, int count) {
  return index >= 0 && index < count;
}

}  // namespace

const char* flinch_status_message(flinch_status status) {
  switch (status) {
    case FLINCH_OK:
      return "ok";
    case FLINCH_MISSES:
      return message_of(runtime::Status::misses);
    case FLINCH_UNNOTICED:
      return message_of(runtime::Status::unnoticed);
    case FLINCH_OUTSIDE_TRAINING:
      return "the threat is unlike all that the selector was trained for";
    case FLINCH_NULL_POINTER:
      return "a pointer is NULL";
    case FLINCH_BAD_HANDLE:
      return "the handle was freed, or is of another kind";
    case FLINCH_BAD_SIZE:
      return "the size member of a struct is not one that this version of Flinch knows: set it to "
             "sizeof";
    case FLINCH_OTHER_LIBRARY:
      return "the workspace was made for a different library than the character";
    case FLINCH_BAD_INDEX:
      return "there is no such clip or target, or a capacity or count is out of range";
    case FLINCH_BAD_CLIP:
      return message_of(runtime::Status::bad_clip);
    case FLINCH_BAD_THREAT:
      return message_of(runtime::Status::bad_threat);
    case FLINCH_BAD_TIME:
      return message_of(runtime::Status::bad_time);
    case FLINCH_BAD_POSE:
      return message_of(runtime::Status::bad_pose);
    case FLINCH_BAD_PLACEMENT:
      return message_of(runtime::Status::bad_placement);
    case FLINCH_NO_GOOD_ANSWER:
      return message_of(runtime::Status::no_good_answer);
    case FLINCH_BAD_PUSH:
      return message_of(runtime::Status::bad_push);
    case FLINCH_WITHOUT_PUSHES:
      return "the selector has no recorded pushes, or no realism model for them; flinch import, "
             "label "
             "and train-realism make both";
    case FLINCH_BAD_LIMITS:
      return "a limit of perception is negative, not finite, or a probability above 1, or an "
             "option of "
             "reactions is out of range";
    case FLINCH_BAD_MASK:
      return "a weight of the mask is not between 0 and 1";
    case FLINCH_OUT_OF_MEMORY:
      return "there is not enough memory";
    case FLINCH_NOT_REACTING:
      return "the character was created without reactions";
    case FLINCH_SIMULATION_FAILED:
      return message_of(reaction::ReactionStatus::failed);
    case FLINCH_CANNOT_OPEN:
      return "the file cannot be read";
    case FLINCH_NOT_A_SELECTOR:
      return "this is not a selector: make one with flinch train";
    case FLINCH_OTHER_VERSION:
      return "the selector was written by another version of Flinch: train it again";
    case FLINCH_DAMAGED:
      return "the selector is damaged, cut short or holds a value out of bounds";
    case FLINCH_NOT_A_FILE:
      return "the path names a folder, a pipe or a device, not a file";
    case FLINCH_TOO_LARGE:
      return "the file is larger than 1 GiB";
    case FLINCH_OTHER_LAYOUT:
      return "the selector was trained on other features than this version of Flinch computes";
    case FLINCH_WITHOUT_CLIPS:
      return "the selector has no clips in its file: load it beside its library, or train it again";
    case FLINCH_WITHOUT_COSTS:
      return "the selector does not know what its clips cost: train it again";
    case FLINCH_WITHOUT_SELECTOR:
      return "the clips were taken without a selector, which alone chooses among them";
    case FLINCH_NOT_A_LIBRARY:
      return "the bytes are not of a library";
    case FLINCH_OTHER_CLIPS:
      return "the selector was trained for another library: give it the one of its hash, which "
             "flinch info shows";
    case FLINCH_OTHER_CONTENT:
      return "the file names a hash that its clips do not have: make it again";
    default:
      return "this is not a status of Flinch";
  }
}

// The names are string literals, so each is null-terminated where its view ends.
const char* flinch_joint_name(int32_t joint) {
  if (!is_below(joint, motion::kRoleCount)) return nullptr;
  return name_of(static_cast<motion::Role>(joint)).data();
}

int32_t flinch_joint_parent(int32_t joint) {
  if (!is_below(joint, motion::kRoleCount)) return -1;
  const auto parent = parent_of(static_cast<motion::Role>(joint));
  return parent ? static_cast<std::int32_t>(*parent) : -1;
}

const char* flinch_body_name(int32_t body) {
  if (!is_below(body, motion::kBodyCount)) return nullptr;
  return name_of(static_cast<motion::Body>(body)).data();
}

const char* flinch_target_name(int32_t target) {
  if (!is_below(target, motion::kTargetCount)) return nullptr;
  return name_of(static_cast<motion::Target>(target)).data();
}

const char* flinch_phase_name(int32_t phase) {
  if (!is_below(phase, FLINCH_WALKING + 1)) return nullptr;
  return name_of(static_cast<runtime::Phase>(phase));
}

const char* flinch_foreseen_name(int32_t foreseen) {
  namespace lookahead = flinch::lookahead;
  if (!is_below(foreseen, FLINCH_FORESEEN_CUT + 1)) return nullptr;
  return name_of(static_cast<lookahead::Foreseen>(foreseen));
}
