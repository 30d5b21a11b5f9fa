// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flinch::program {

/// A file that the page carries.
struct PageFile {
  std::string name;   ///< as the page shows it
  std::string bytes;  ///< of the whole file
};

/// Text near the start of every page, by which the program knows its own.
inline constexpr std::string_view kPageMark = "<meta name=\"generator\" content=\"Flinch";

/// Returns the page that scripts/page builds, which carries no files yet: an HTML document. It is
/// `page/index.html` beside the program in a build, and `share/flinch/page.html` where the program
/// is installed. Throws Error that says how to build it if it is in neither place.
std::string read_page();

/// Returns the page with these files in it, in their order: each is an element of data, in base64,
/// at the place that the page marks for them. Characters of names that are neither letters, digits
/// nor one of "._- " become "_". Throws Error if the page has no such place.
std::string page_with(const std::string& page, std::span<const PageFile> files);

/// Returns bytes in base64 (RFC 4648, section 4).
std::string base64(std::string_view bytes);

}  // namespace flinch::program
