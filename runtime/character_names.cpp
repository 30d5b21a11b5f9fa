// SPDX-License-Identifier: MIT
#include "runtime/character.h"

namespace flinch::runtime {

const char* message_of(Status status) noexcept {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::misses:
      return "the threat hits nothing";
    case Status::unnoticed:
      return "the character has not noticed the threat";
    case Status::not_loaded:
      return "no library is loaded";
    case Status::other_workspace:
      return "the workspace was made for another library";
    case Status::bad_clip:
      return "the library has no such clip, or the clip is not annotated";
    case Status::bad_threat:
      return "a number of the threat is not finite or out of range, or its time is";
    case Status::bad_time:
      return "the time step is not above 0 and at most 1e6 s";
    case Status::bad_pose:
      return "the pose has a number that is not finite or a rotation that is not of unit length";
    case Status::no_good_answer:
      return "no response to the push would look real";
    case Status::without_pushes:
      return "the library has no clip with a push";
    case Status::without_realism:
      return "the selector has no realism model; flinch train-realism adds one";
    case Status::bad_push:
      return "the push is at no joint of the upper body, or not 0.05 to 20 m/s fast";
    case Status::bad_placement:
      return "the position is not within 1e5 m of the origin, the direction is not finite, or the "
             "library has no such stance";
  }
  return "unknown";
}

const char* name_of(Phase phase) noexcept {
  switch (phase) {
    case Phase::idle:
      return "idle";
    case Phase::reacting:
      return "reacting";
    case Phase::waiting:
      return "waiting";
    case Phase::shifting:
      return "shifting";
    case Phase::blending:
      return "blending";
    case Phase::protecting:
      return "protecting";
    case Phase::returning:
      return "returning";
    case Phase::pushed:
      return "pushed";
    case Phase::walking:
      return "walking";
  }
  return "unknown";
}

}  // namespace flinch::runtime
