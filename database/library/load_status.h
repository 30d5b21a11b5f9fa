// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace flinch::database {

/// The result of reading a library or selector file.
enum class LoadStatus : std::uint8_t {
  ok,
  cannot_open,
  not_a_file,     ///< a folder, a pipe or a device, which may never end
  too_large,      ///< larger than kMaxFileSize (input_file.h)
  not_a_library,  ///< another kind of file than the one asked for
  other_version,  ///< written in another version of the format
  damaged,        ///< cut short, changed or out of bounds: the content hash or a check fails
  other_layout,   ///< a selector trained on features that this build does not compute
  without_clips,  ///< a selector whose file holds no clips
  other_library,  ///< a selector that was trained for another library than the one given
  other_content,  ///< the file names a hash that its clips do not have
  out_of_memory,
};

/// The status as the end of a sentence that begins with the file's name, such as "is damaged or cut
/// short". Never null.
const char* message_of(LoadStatus status) noexcept;

}  // namespace flinch::database
