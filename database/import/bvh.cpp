// SPDX-License-Identifier: MIT
#include "database/import/bvh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "database/files/file_io.h"
#include "database/files/text_encoding.h"
#include "database/import/bvh_lexer.h"
#include "database/import/bvh_motion.h"

namespace flinch::database {
namespace {

// Far above any figure, and low enough for code that walks the tree.
constexpr std::size_t kMaxJoints = 4096;
constexpr std::size_t kMaxDepth = 256;

constexpr std::array<std::string_view, 6> kChannelNames{"Xposition", "Yposition", "Zposition",
                                                        "Xrotation", "Yrotation", "Zrotation"};

std::optional<BvhChannel> channel_named(std::string_view name) {
  for (std::size_t i = 0; i < kChannelNames.size(); ++i) {
    if (equals_ignoring_case(name, kChannelNames[i])) return static_cast<BvhChannel>(i);
  }
  return std::nullopt;
}

bool is_position(BvhChannel channel) {
  return channel <= BvhChannel::z_position;
}

/// Parses the tree of joints. Uses its own stack, so that no file can overflow the program's.
class HierarchyParser {
 public:
  HierarchyParser(BvhLexer& lexer, Bvh& bvh) : lexer_(lexer), bvh_(bvh) {}

  /// Parses from HIERARCHY to MOTION, inclusive.
  void parse() {
    parse_opening();
    begin_joint();
    while (!open_.empty()) parse_item();
    parse_closing();
  }

 private:
  struct OpenJoint {
    std::size_t index = 0;
    std::size_t line = 0;
    bool has_offset = false;
    bool has_channels = false;
    bool has_children = false;
  };

  BvhJoint& joint() { return bvh_.joints[open_.back().index]; }
  std::string in_joint() { return "joint " + quoted(joint().name); }

  void parse_opening() {
    const std::string_view first = lexer_.next_word();
    if (!equals_ignoring_case(first, "HIERARCHY")) {
      lexer_.fail("is not BVH: expected HIERARCHY, found " + quoted(first));
    }
    const std::string_view second = lexer_.next_word();
    if (!equals_ignoring_case(second, "ROOT")) {
      lexer_.fail("expected ROOT after HIERARCHY, found " + quoted(second));
    }
  }

  void parse_closing() {
    const std::string_view word = lexer_.next_word();
    if (equals_ignoring_case(word, "ROOT")) {
      lexer_.fail("a second ROOT: a file must hold one figure; split it into one file each");
    }
    if (!equals_ignoring_case(word, "MOTION")) {
      lexer_.fail("expected MOTION after the hierarchy, found " + quoted(word));
    }
  }

  void parse_item() {
    const std::string_view word = lexer_.next_word();
    if (word == "}") return end_joint();
    if (equals_ignoring_case(word, "OFFSET")) return parse_offset();
    if (equals_ignoring_case(word, "CHANNELS")) return parse_channels();
    if (equals_ignoring_case(word, "JOINT")) return begin_joint();
    if (equals_ignoring_case(word, "End") || equals_ignoring_case(word, "EndSite"))
      return parse_end_site();
    if (word.empty()) {
      lexer_.fail("the file ends inside " + in_joint() + " of line " +
                  std::to_string(open_.back().line) + "; is it cut short?");
    }
    lexer_.fail("expected OFFSET, CHANNELS, JOINT, End Site or } in " + in_joint() + ", found " +
                quoted(word));
  }

  void begin_joint() {
    const std::size_t line = lexer_.line();
    const std::string_view name = lexer_.rest_of_line();
    if (name.empty()) lexer_.fail("a joint without a name");
    if (bvh_.joints.size() == kMaxJoints) {
      lexer_.fail("more than " + std::to_string(kMaxJoints) + " joints");
    }
    if (open_.size() == kMaxDepth) {
      lexer_.fail("joints nested more than " + std::to_string(kMaxDepth) + " deep");
    }
    BvhJoint joint;
    joint.name = printable_text(name);
    if (!is_utf8(name) && !std::exchange(has_guessed_encoding_, true)) {
      bvh_.warnings.push_back(lexer_.where(line) + ": the name " + quoted(name) +
                              " is not UTF-8; such names are read as Latin-1");
    }
    joint.first_channel = bvh_.channel_count;
    if (!open_.empty()) {
      joint.parent = static_cast<int>(open_.back().index);
      open_.back().has_children = true;
    }
    if (!names_.insert(joint.name).second) {
      bvh_.warnings.push_back(lexer_.where(line) + ": another joint is named " + quoted(name) +
                              " too");
    }
    open_.push_back({.index = bvh_.joints.size(), .line = line});
    bvh_.joints.push_back(std::move(joint));
    expect("{", in_joint());
  }

  void end_joint() {
    if (!open_.back().has_offset) {
      lexer_.fail_at(open_.back().line, in_joint() + " has no OFFSET");
    }
    open_.pop_back();
  }

  void parse_offset() {
    if (std::exchange(open_.back().has_offset, true)) {
      lexer_.fail(in_joint() + " has a second OFFSET");
    }
    joint().offset = parse_vector();
  }

  void parse_channels() {
    if (std::exchange(open_.back().has_channels, true)) {
      lexer_.fail(in_joint() + " has a second CHANNELS");
    }
    if (open_.back().has_children) {
      lexer_.fail("CHANNELS of " + in_joint() +
                  " come after its children, which leaves the order of the columns open");
    }
    const long long declared = lexer_.next_whole_number("the number of channels");
    const std::size_t line = lexer_.line();
    std::vector<BvhChannel>& channels = joint().channels;
    while (const auto channel = channel_named(lexer_.peek_word())) {
      if (std::find(channels.begin(), channels.end(), *channel) != channels.end()) {
        const std::string what = in_joint() + " has two channels " + quoted(lexer_.peek_word());
        if (is_position(*channel)) lexer_.fail(what);
        bvh_.warnings.push_back(lexer_.where(line) + ": " + what +
                                "; their turns follow each other in the order of the channels");
      }
      lexer_.next_word();
      channels.push_back(*channel);
    }
    if (std::cmp_not_equal(declared, channels.size())) {
      const std::string found = quoted(lexer_.peek_word());
      lexer_.fail_at(line, "CHANNELS says " + std::to_string(declared) + ", but " +
                               std::to_string(channels.size()) +
                               " known names follow (Xposition to Zrotation), then " + found);
    }
    bvh_.channel_count += static_cast<int>(channels.size());
  }

  void parse_end_site() {
    lexer_.rest_of_line();  // "Site", and sometimes a name that nothing refers to
    expect("{", "an End Site");
    if (!accept("OFFSET")) {
      const std::string found = quoted(lexer_.peek_word());
      lexer_.fail("expected the OFFSET of an End Site, found " + found);
    }
    joint().end_sites.push_back(parse_vector());
    if (accept("CHANNELS") && lexer_.next_whole_number("the number of channels") != 0) {
      lexer_.fail("an End Site has CHANNELS, but only joints move; make it a JOINT");
    }
    expect("}", "an End Site");
  }

  /// Moves past the next word if it is this one.
  bool accept(std::string_view wanted) {
    if (!equals_ignoring_case(lexer_.peek_word(), wanted)) return false;
    lexer_.next_word();
    return true;
  }

  Eigen::Vector3d parse_vector() {
    Eigen::Vector3d vector;
    for (double& component : vector) component = lexer_.next_number("a component of OFFSET");
    return vector;
  }

  void expect(std::string_view wanted, const std::string& of_what) {
    const std::string_view word = lexer_.next_word();
    if (word == wanted) return;
    lexer_.fail("expected " + quoted(wanted) + " of " + of_what + ", found " + quoted(word));
  }

  BvhLexer& lexer_;
  Bvh& bvh_;
  std::vector<OpenJoint> open_;
  std::set<std::string> names_;
  bool has_guessed_encoding_ = false;
};

}  // namespace

Bvh parse_bvh(std::string_view text, const std::string& path) {
  Bvh bvh;
  bvh.path = path;
  BvhLexer lexer(text, path);
  HierarchyParser(lexer, bvh).parse();
  if (bvh.channel_count == 0) lexer.fail("no joint has CHANNELS, so nothing can move");
  parse_bvh_motion(lexer, bvh);
  return bvh;
}

Bvh read_bvh(const std::string& path) {
  return parse_bvh(read_file(path), path);
}

}  // namespace flinch::database
