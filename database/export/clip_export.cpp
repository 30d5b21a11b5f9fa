// SPDX-License-Identifier: MIT
#include "database/export/clip_export.h"

#include <set>
#include <string>

namespace flinch::database {
namespace {

std::string plain(const std::string& name) {
  std::string result = name;
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    if (!((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))) c = '_';
  }
  return result;
}

}  // namespace

std::vector<NamedMotion> exported_clips(const ClipLibrary& library) {
  std::vector<NamedMotion> clips;
  std::set<std::string> taken;
  for (const motion::Clip& clip : library.clips) {
    const std::string base = plain(clip.name);
    std::string name = base;
    for (int number = 2; !taken.insert(name).second; ++number)
      name = base + "_" + std::to_string(number);
    clips.push_back({name, clip.motion, {.clip = clip.name, .annotation = clip.annotation}});
  }
  return clips;
}

}  // namespace flinch::database
