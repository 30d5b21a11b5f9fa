// SPDX-License-Identifier: MIT
#include "database/import/role_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>

namespace flinch::database {
namespace {

using motion::Role;
using Words = std::vector<std::string>;

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

bool is_upper(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
}

bool is_lower(char c) {
  return std::islower(static_cast<unsigned char>(c)) != 0;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_number(const std::string& word) {
  return std::all_of(word.begin(), word.end(), is_digit);
}

// A word ends at a separator, and where a lower-case letter or a capitalised word begins a new one:
// "lShldr" is l, shldr; "LHipJoint" is l, hip, joint. Digits belong to the word before them.
Words words_of(std::string_view name) {
  Words words(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (c == ' ' || c == '_' || c == '.' || c == '-' || c == '\t') {
      words.emplace_back();
      continue;
    }
    const bool after_small = i > 0 && is_upper(c) && !is_upper(name[i - 1]);
    const bool before_small = i > 0 && i + 1 < name.size() && is_upper(c) &&
                              is_upper(name[i - 1]) && is_lower(name[i + 1]);
    if (after_small || before_small) words.emplace_back();
    words.back().push_back(lower(c));
  }
  std::erase(words, std::string());
  return words;
}

std::string_view without_namespace(std::string_view name) {
  const std::size_t colon = name.find_last_of(":|");
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

NameSide side_named(std::string_view word) {
  constexpr std::array<std::string_view, 3> kLeft{"l", "left", "le"};
  constexpr std::array<std::string_view, 3> kRight{"r", "right", "ri"};
  if (std::ranges::find(kLeft, word) != kLeft.end()) return NameSide::left;
  if (std::ranges::find(kRight, word) != kRight.end()) return NameSide::right;
  return NameSide::none;
}

// One joint's name, while parts of it are removed.
struct NameParts {
  Words words;
  NameSide side = NameSide::none;
};

void strip_rig_prefix(Words& words) {
  for (std::string_view prefix : rig_prefixes()) {
    const Words expected = words_of(prefix);
    if (words.size() > expected.size() &&
        std::equal(expected.begin(), expected.end(), words.begin())) {
      words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(expected.size()));
      return;
    }
  }
}

// The side is the first or the last word; else any word, as in "thigh.L.001".
void take_side(NameParts& parts) {
  Words& words = parts.words;
  if (words.size() < 2) return;
  const auto is_side = [](const std::string& word) { return side_named(word) != NameSide::none; };
  auto at = words.begin();
  if (!is_side(*at)) at = words.end() - 1;
  if (!is_side(*at)) at = std::find_if(words.begin(), words.end(), is_side);
  if (at == words.end()) return;
  parts.side = side_named(*at);
  words.erase(at);
}

// Japanese: 左腕 is left, 腕.
void take_japanese_side(NameParts& parts) {
  constexpr std::string_view kLeft = "左";
  constexpr std::string_view kRight = "右";
  std::string& word = parts.words.front();
  const bool left = word.starts_with(kLeft);
  if (!left && !word.starts_with(kRight)) return;
  parts.side = left ? NameSide::left : NameSide::right;
  word.erase(0, kLeft.size());
  if (word.empty() && parts.words.size() > 1) parts.words.erase(parts.words.begin());
}

// In rigs that mark both sides, words for the middle stand in their place: "Spine1_M", "root.x".
void strip_middle(NameParts& parts) {
  const auto is_middle = [](const std::string& word) {
    return word == "m" || word == "c" || word == "x";
  };
  if (parts.side != NameSide::none || parts.words.size() < 2) return;
  if (is_middle(parts.words.back())) {
    parts.words.pop_back();
  } else if (is_middle(parts.words.front())) {
    parts.words.erase(parts.words.begin());
  }
}

std::string joined(const Words& words) {
  std::string all;
  for (const std::string& word : words) all += word;
  return all;
}

// Daz Genesis: "lThighBend" is the thigh, and "lThighTwist" its twist bone; Auto-Rig Pro:
// "thigh_stretch.l".
void strip_bend(Words& words) {
  if (words.size() > 1 && (words.back() == "bend" || words.back() == "stretch")) words.pop_back();
}

bool has_helper_word(const Words& words) {
  return std::ranges::any_of(words, [](const std::string& word) {
    const std::string letters = word.substr(0, word.find_last_not_of("0123456789") + 1);
    return letters.ends_with("twist") ||
           std::ranges::find(helper_words(), letters) != helper_words().end();
  });
}

bool is_limb_stem(std::string_view stem) {
  return std::ranges::any_of(limb_stems(), [stem](const KnownStem& known) {
    return known.stem == stem && known.fit >= NameFit::likely;
  });
}

std::optional<std::string_view> without(std::string_view text, std::string_view part,
                                        bool at_front) {
  if (at_front ? !text.starts_with(part) : !text.ends_with(part)) return std::nullopt;
  text.remove_prefix(at_front ? part.size() : 0);
  text.remove_suffix(at_front ? 0 : part.size());
  return text;
}

// "lfemur", "leftupleg", "handr": side and stem without a separator. Only where the rest is known.
void split_run_together(PlainName& name) {
  constexpr std::array<std::string_view, 4> kSides{"left", "right", "l", "r"};
  for (std::string_view side : kSides) {
    for (bool at_front : {true, false}) {
      const std::optional<std::string_view> rest = without(name.stem, side, at_front);
      if (!rest || !is_limb_stem(*rest)) continue;
      name.side = side_named(side);
      name.stem = std::string(*rest);
      return;
    }
  }
}

PlainName finished(NameParts parts) {
  strip_middle(parts);
  PlainName name;
  name.side = parts.side;
  name.is_helper = has_helper_word(parts.words);
  strip_bend(parts.words);
  name.stem = joined(parts.words);
  const std::size_t letters = name.stem.find_last_not_of("0123456789") + 1;
  name.number = name.stem.substr(letters);
  name.stem.resize(letters);
  if (name.side == NameSide::none) split_run_together(name);
  return name;
}

NameParts parts_of(std::string_view name) {
  NameParts parts;
  parts.words = words_of(without_namespace(name));
  if (parts.words.empty()) parts.words.emplace_back();
  strip_rig_prefix(parts.words);
  take_side(parts);
  if (parts.side == NameSide::none) take_japanese_side(parts);
  return parts;
}

bool is_first_number(std::string_view number) {
  return number.find_first_not_of('0') == std::string_view::npos ||
         (number.back() == '1' && number.find_first_not_of('0') == number.size() - 1);
}

bool is_known(const PlainName& name) {
  if (name.side != NameSide::none) return is_limb_stem(name.stem);
  for (Role role : {Role::pelvis, Role::neck, Role::head}) {
    for (std::string_view stem : middle_stems(role)) {
      if (is_named(name, stem)) return true;
    }
  }
  return false;
}

std::ptrdiff_t known_among(const std::vector<NameParts>& rig) {
  return std::ranges::count_if(rig,
                               [](const NameParts& parts) { return is_known(finished(parts)); });
}

enum class NameEnd : std::uint8_t { front, back };

// The word at one end; numbers are alike, whatever their values: "Hips_01", "Spine_02".
std::string end_word(const NameParts& parts, NameEnd end) {
  const std::string& word = end == NameEnd::front ? parts.words.front() : parts.words.back();
  return is_number(word) ? "0" : word;
}

// Removes the word that at least two thirds of the names have at one end, and returns whether there
// was one. Helpers are not asked: they have further words of their own.
bool strip_shared_word(std::vector<NameParts>& rig, NameEnd end) {
  std::map<std::string, std::size_t> count;
  std::size_t asked = 0;
  for (const NameParts& parts : rig) {
    if (has_helper_word(parts.words)) continue;
    ++count[end_word(parts, end)];
    ++asked;
  }
  const auto most = std::ranges::max_element(
      count, [](const auto& one, const auto& other) { return one.second < other.second; });
  if (most == count.end() || 3 * most->second < 2 * asked) return false;
  std::vector<NameParts> stripped = rig;
  bool any = false;
  for (NameParts& parts : stripped) {
    if (parts.words.size() < 2 || end_word(parts, end) != most->first) continue;
    parts.words.erase(end == NameEnd::front ? parts.words.begin() : parts.words.end() - 1);
    any = true;
  }
  if (!any || known_among(stripped) < known_among(rig)) return false;
  rig = std::move(stripped);
  return true;
}

std::vector<NameParts> rig_of(const std::vector<std::string>& names) {
  std::vector<NameParts> rig;
  rig.reserve(names.size());
  for (const std::string& name : names) rig.push_back(parts_of(name));
  return rig;
}

std::size_t shared_letters(const std::string& one, const std::string& other, NameEnd end) {
  const std::size_t most = std::min(one.size(), other.size());
  std::size_t shared = 0;
  while (shared < most) {
    const char a = end == NameEnd::front ? one[shared] : one[one.size() - 1 - shared];
    const char b = end == NameEnd::front ? other[shared] : other[other.size() - 1 - shared];
    if (lower(a) != lower(b)) break;
    ++shared;
  }
  return shared;
}

// Removes the letters that all names but the root's share at one end, for names without separators:
// "rigleftarm". Only where more names are known then.
void strip_shared_letters(std::vector<std::string>& names, NameEnd end) {
  if (names.size() < 3) return;
  std::size_t shared = names[1].size();
  for (std::size_t i = 2; i < names.size(); ++i) {
    shared = std::min(shared, shared_letters(names[1], names[i], end));
  }
  std::vector<std::string> stripped = names;
  for (std::string& name : stripped) {
    if (shared_letters(names[1], name, end) < shared || name.size() == shared) continue;
    name.erase(end == NameEnd::front ? 0 : name.size() - shared, shared);
  }
  if (known_among(rig_of(stripped)) > known_among(rig_of(names))) names = std::move(stripped);
}

}  // namespace

PlainName plain_name(std::string_view name) {
  return finished(parts_of(name));
}

std::vector<PlainName> plain_names(std::vector<std::string> names) {
  strip_shared_letters(names, NameEnd::front);
  strip_shared_letters(names, NameEnd::back);
  std::vector<NameParts> rig = rig_of(names);
  while (strip_shared_word(rig, NameEnd::front)) {
  }
  while (strip_shared_word(rig, NameEnd::back)) {
  }
  std::vector<PlainName> plain;
  plain.reserve(rig.size());
  for (NameParts& parts : rig) plain.push_back(finished(std::move(parts)));
  return plain;
}

NameSide side_of(Role role) {
  if (motion::mirrored(role) == role) return NameSide::none;
  return motion::name_of(role).starts_with("left") ? NameSide::left : NameSide::right;
}

NameFit fit_of(const PlainName& name, Role role) {
  const bool can_fit = name.side != NameSide::none && name.side == side_of(role);
  if (!can_fit || name.is_helper || !is_first_number(name.number)) return NameFit::none;
  const Role left = name.side == NameSide::left ? role : motion::mirrored(role);
  for (const KnownStem& known : limb_stems()) {
    if (known.left_role == left && known.stem == name.stem) return known.fit;
  }
  return NameFit::none;
}

bool is_named(const PlainName& name, std::string_view middle_stem) {
  if (name.side != NameSide::none) return false;
  return (name.stem == middle_stem && is_first_number(name.number)) ||
         name.stem + name.number == middle_stem;
}

}  // namespace flinch::database
