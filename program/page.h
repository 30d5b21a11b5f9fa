// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flinch::program {

/// A page that is built from viewer/ and that the program fills.
struct PageKind {
  std::string_view beside;     ///< the program in a build
  std::string_view installed;  ///< in `share/flinch` where the program is installed
  std::string_view place;      ///< comment in the page where the program puts data
};
/// The page on which to throw balls.
inline constexpr PageKind kThrowPage{"page/index.html", "page.html", "<!-- selectors -->"};
/// The page of `flinch compare --report`.
inline constexpr PageKind kReportPage{"page/report.html", "report.html", "<!-- report -->"};

/// A file that the page carries.
struct PageFile {
  std::string name;   ///< as the page shows it
  std::string bytes;  ///< of the whole file
};

/// Text near the start of every page, by which the program knows its own.
inline constexpr std::string_view kPageMark = "<meta name=\"generator\" content=\"Flinch";

/// Returns a page without data, an HTML document, or an empty text if it was not built. Throws
/// Error for one that has no place for data.
std::string find_page(const PageKind& kind);

/// The page of reports; where there is none, warns that there will be no report.html.
std::string find_report_page();

/// Returns the page on which to throw balls with these files in it, in their order: each is an
/// element of data, in base64. Characters of names that are neither letters, digits nor one of
/// "._- " become "_".
std::string page_with(const std::string& page, std::span<const PageFile> files);

/// Returns the page of a report with the report in it. `json` is one JSON document.
std::string page_with_report(const std::string& page, const std::string& json);

/// Returns bytes in base64 (RFC 4648, section 4).
std::string base64(std::string_view bytes);

}  // namespace flinch::program
