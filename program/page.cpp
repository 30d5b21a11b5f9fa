// SPDX-License-Identifier: MIT
#include "program/page.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>

#include "database/files/file_io.h"
#include "motion/error.h"
#include "program/log.h"

namespace flinch::program {
namespace {

namespace fs = std::filesystem;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("._- ").find(c) != std::string_view::npos;
}

std::string read_page(const fs::path& file, const PageKind& kind) {
  const std::string page = database::read_file(file.string());
  if (page.find(kind.place) == std::string::npos || page.find(kPageMark) == std::string::npos)
    throw Error("", "the page beside this program is damaged: build it again with scripts/page");
  return page;
}

std::string filled(const PageKind& kind, const std::string& page, const std::string& data) {
  return std::string(page).replace(page.find(kind.place), kind.place.size(), data);
}

}  // namespace

std::string find_page(const PageKind& kind) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (const fs::path& page :
       {program / kind.beside, program.parent_path() / "share/flinch" / kind.installed}) {
    if (fs::exists(page, error)) return read_page(page, kind);
  }
  return {};
}

std::string find_report_page() {
  std::string page = find_page(kReportPage);
  if (page.empty()) {
    log(LogLevel::warning,
        "there will be no report.html, only its data: this program was built without the packages "
        "of the page; scripts/setup fetches them");
  }
  return page;
}

std::string page_with(const std::string& page, std::span<const PageFile> files) {
  std::string data;
  for (const PageFile& file : files) {
    std::string name = file.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !is_plain(c); }, '_');
    data += "<script type=\"application/octet-stream\" data-selector=\"" + name + "\">" +
            base64(file.bytes) + "</script>\n";
  }
  return filled(kThrowPage, page, data);
}

std::string page_with_report(const std::string& page, const std::string& json) {
  std::string data = "<script type=\"application/json\" id=\"report\">";
  // In JSON "<" stands only in strings, where its escape means the same; so no text ends the
  // element.
  for (const char c : json) c == '<' ? data += "\\u003c" : data += c;
  return filled(kReportPage, page, data + "</script>");
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    // Three bytes are four digits of 6 bits; "=" stands for digits beyond the end.
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto byte = i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
      bits = bits << 8 | byte;
    }
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace flinch::program
