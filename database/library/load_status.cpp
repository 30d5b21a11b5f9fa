// SPDX-License-Identifier: MIT
#include "database/library/load_status.h"

namespace flinch::database {

const char* message_of(LoadStatus status) noexcept {
  switch (status) {
    case LoadStatus::ok:
      return "is sound";
    case LoadStatus::cannot_open:
      return "cannot be read";
    case LoadStatus::not_a_file:
      return "is no regular file";
    case LoadStatus::too_large:
      return "is larger than 1 GiB";
    case LoadStatus::not_a_library:
      return "is another kind of file";
    case LoadStatus::other_version:
      return "was written by another version of Flinch";
    case LoadStatus::damaged:
      return "is damaged, cut short or holds a value out of bounds";
    case LoadStatus::other_layout:
      return "was trained on other features than this version of Flinch computes";
    case LoadStatus::without_clips:
      return "has no clips in it";
    case LoadStatus::other_library:
      return "was trained for another library";
    case LoadStatus::other_content:
      return "names a hash that its clips do not have";
    case LoadStatus::out_of_memory:
      return "does not fit into memory";
  }
  return "has an unknown status";
}

}  // namespace flinch::database
