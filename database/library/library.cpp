// SPDX-License-Identifier: MIT
#include "database/library/library.h"

#include <string_view>

#include "motion/loop.h"

namespace flinch::database {

std::vector<int> stance_clips(const ClipLibrary& library) {
  std::vector<int> stances{library.idle};
  for (int clip = 0; clip < static_cast<int>(library.clips.size()); ++clip) {
    if (clip != library.idle && library.clip(clip).purpose == motion::Purpose::stance)
      stances.push_back(clip);
  }
  return stances;
}

motion::Loop loop_of(const ClipLibrary& library, int clip) {
  const motion::Motion& motion = library.clip(clip).motion;
  return clip == library.idle ? motion::Loop(motion) : motion::Loop::in_cycles(motion);
}

std::string hash_text(std::uint64_t hash) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(16, '0');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = kDigits[(hash >> (60 - 4 * i)) & 0xF];
  return text;
}

}  // namespace flinch::database
