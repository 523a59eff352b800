// The functions that put a recording into a page. page.hpp includes this, unless they are compiled once
// for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>

#include <cca/base/refused.hpp>
#include <cca/base/system/output_file.hpp>
#include <cca/record/page.hpp>

namespace cca::recording {

namespace detail {

// Stated once for a program, in what is compiled once: files with and without the target's definition get
// the same. Where nothing is compiled once, all files must have it, or none.
inline std::string stated_page() {
#ifdef CCA_RECORDING_PAGE
  return CCA_RECORDING_PAGE;
#else
  return {};
#endif
}
inline std::string page_beside_program() {
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  return program.empty() ? std::string() : (program.parent_path() / "cca_page.html").string();
}

inline constexpr std::string_view place_of_recording = "<!-- the recording -->";

inline void check(const std::ios& file, const std::string& name) {
  if (!file) throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(), name);
}

inline std::ifstream opened(const std::string& name) {
  errno = 0;
  std::ifstream file(name, std::ios::binary);
  check(file, name);
  return file;
}

// In a value between quotation marks.
inline std::string in_html(std::string_view plain) {
  std::string html;
  for (const char c : plain)
    c == '<' ? html += "&lt;" : c == '&' ? html += "&amp;" : c == '"' ? html += "&quot;" : html += c;
  return html;
}

// Base64 of three bytes at a time; the last group may be shorter.
inline void write_base64(output_file& to, std::istream& from) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<char, 3 << 14> bytes;
  std::string text;
  while (from.read(bytes.data(), bytes.size()), from.gcount() > 0) {
    const auto count = static_cast<std::size_t>(from.gcount());
    text.clear();
    for (std::size_t i = 0; i < count; i += 3) {
      std::uint32_t three = 0;
      for (std::size_t k = 0; k < 3; ++k)
        three = three << 8 | (i + k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
      for (std::size_t k = 0; k < 4; ++k) text += i + k > count ? '=' : letters[three >> (18 - 6 * k) & 63U];
    }
    to.write(text);
  }
}

}  // namespace detail

CCA_RECORD_INLINE std::string page_of_cca() {
  std::error_code unknown;
  for (const std::string& file : {detail::stated_page(), detail::page_beside_program()})
    if (std::filesystem::is_regular_file(file, unknown)) return file;
  return {};
}
CCA_RECORD_INLINE std::string page_without_recording() {
  if (std::string file = page_of_cca(); !file.empty()) return file;
  const std::string stated = detail::stated_page(), beside = detail::page_beside_program();
  throw refused("there is no page to put a recording into, neither " +
                (stated.empty() ? "" : stated + " nor ") + beside +
                ". It is the file page/recording.html of cca, and share/cca/recording.html of an installed "
                "one: copy it there");
}

CCA_RECORD_INLINE void write_page(const std::string& page,
                                  const std::string& recording,
                                  const std::string& from) {
  std::ifstream empty = detail::opened(from);
  const std::string html{std::istreambuf_iterator<char>(empty), {}};
  const std::size_t place = html.find(detail::place_of_recording);
  if (place == html.npos) throw refused(from + ": this is no page for recordings");
  std::ifstream recorded = detail::opened(recording);

  output_file to(page);
  try {
    const std::string name = std::filesystem::path(page).stem().string();
    to.write(std::string_view(html).substr(0, place));
    to.write("<script id=\"recording\" type=\"text/plain\" data-name=\"" + detail::in_html(name) + "\">");
    detail::write_base64(to, recorded);
    to.write("</script>");
    to.write(std::string_view(html).substr(place + detail::place_of_recording.size()));
    to.keep();
  } catch (...) {
    to.discard();
    throw;
  }
}

}  // namespace cca::recording
