// SPDX-License-Identifier: MIT
#pragma once

#include <stdexcept>
#include <string>

namespace flinch::tests {

/// Three joints, two frames, twelve channels. Its frames are on lines 24 and 25.
inline const std::string kPlainBvh = R"(HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT Chest
  {
    OFFSET 0 5.21 0
    CHANNELS 3 Zrotation Yrotation Xrotation
    End Site
    {
      OFFSET 0 4.5 0
    }
  }
  JOINT LeftUpLeg
  {
    OFFSET 3.91 0 0
    CHANNELS 3 Zrotation Xrotation Yrotation
  }
}
MOTION
Frames: 2
Frame Time: 0.25
1 2 3 4 5 6 7 8 9 10 11 12
-1 -2 -3 -4 -5 -6 -7 -8 -9 -10 -11 -12.5
)";

/// Returns the text with every `what` replaced by `with`; fails if there is none.
inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  std::size_t position = text.find(what);
  if (position == std::string::npos) throw std::invalid_argument("nothing to replace: " + what);
  for (; position != std::string::npos; position = text.find(what, position + with.size())) {
    text.replace(position, what.size(), with);
  }
  return text;
}

}  // namespace flinch::tests
