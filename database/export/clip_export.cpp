// SPDX-License-Identifier: MIT
#include "database/export/clip_export.h"

#include <map>
#include <set>
#include <string>

namespace flinch::database {
namespace {

/// Leaves room for numbers and endings in the names of files, which may have 255 bytes.
constexpr std::size_t kMaxSize = 100;

std::string plain(const std::string& name) {
  std::string result = name.substr(0, kMaxSize);
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
  std::map<std::string, int> used;  // numbers of each name
  for (const motion::Clip& clip : library.clips) {
    const std::string base = plain(clip.name);
    int& number = used.emplace(base, 1).first->second;
    std::string name = base;
    while (!taken.insert(name).second) name = base + "_" + std::to_string(++number);
    clips.push_back({name, clip.motion, {.clip = clip.name, .annotation = clip.annotation}});
  }
  return clips;
}

}  // namespace flinch::database
