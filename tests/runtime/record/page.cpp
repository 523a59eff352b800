// A recording in a page: every byte of it comes out of the HTML file again, and what is missing or wrong is
// refused in words.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <system_error>

#include <cca/main.hpp>

#include "graphs.hpp"

using namespace record_test;

namespace {

std::string bytes_in(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
void put(const std::string& name, std::string_view bytes) { std::ofstream(name, std::ios::binary) << bytes; }

// What a browser's atob gives.
std::string decoded(std::string_view text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  REQUIRE(text.size() % 4 == 0);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    unsigned four = 0, count = 3;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t letter = letters.find(text[i + k]);
      if (letter == letters.npos) {
        REQUIRE(text[i + k] == '=');
        REQUIRE(i + 4 == text.size());
        --count;
      }
      four = four << 6 | static_cast<unsigned>(letter == letters.npos ? 0 : letter);
    }
    for (unsigned k = 0; k < count; ++k) bytes += static_cast<char>(four >> (16 - 8 * k) & 255U);
  }
  return bytes;
}
// The recording in a page.
std::string recording_in(const std::string& html) {
  const auto tag = html.find("<script id=\"recording\"");
  REQUIRE(tag != html.npos);
  const auto from = html.find('>', tag) + 1;
  return decoded(std::string_view(html).substr(from, html.find("</script>", from) - from));
}

struct graph : walking<> {};
struct program : cca::robot_program<graph> {
  explicit program(const std::string& page, const std::string& record = "") {
    settings.seconds = 0.1;
    settings.speed.reset();
    settings.quiet = true;
    settings.page = page;
    settings.record = record;
  }
};

const std::string empty_page = "<html><body>before <!-- the recording --> behind</body></html>";

}  // namespace

TEST_CASE("every byte of a recording is in the page") {
  const temporary_file page("page"), recording("in_page"), empty("empty_page");
  put(empty.path, empty_page);
  std::mt19937 dice(17);
  for (const std::size_t size : {0U, 1U, 2U, 3U, 4U, 49'151U, 49'152U, 49'153U, 200'000U}) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(dice() & 255U);
    put(recording.path, bytes);
    cca::recording::write_page(page.path, recording.path, empty.path);
    const std::string html = bytes_in(page.path);
    CHECK(recording_in(html) == bytes);
    CHECK(html.starts_with("<html><body>before <script"));
    CHECK(html.ends_with("</script> behind</body></html>"));
    CHECK_FALSE(std::filesystem::exists(page.path + ".part"));
  }
}

TEST_CASE("a name can't end the text around it") {
  const temporary_file recording("named"), empty("empty_named");
  const temporary_file page("a\"b<c>&d");
  put(empty.path, empty_page);
  put(recording.path, "abc");
  cca::recording::write_page(page.path, recording.path, empty.path);
  CHECK(bytes_in(page.path).find("a&quot;b&lt;c>&amp;d") != std::string::npos);
}

TEST_CASE("what can't become a page is refused in words") {
  const temporary_file page("refused_page"), recording("refused_recording"), empty("refused_empty");
  put(recording.path, "abc");
  put(empty.path, "<html></html>");
  CHECK_THROWS_WITH_AS(cca::recording::write_page(page.path, recording.path, empty.path),
                       doctest::Contains("this is no page for recordings"), cca::refused);
  put(empty.path, empty_page);
  CHECK_THROWS_AS(cca::recording::write_page(page.path, "/nowhere/a.mcap", empty.path), std::system_error);
  CHECK_THROWS_AS(cca::recording::write_page("/nowhere/a.html", recording.path, empty.path),
                  std::system_error);
  CHECK_THROWS_AS(cca::recording::write_page("/dev/full/a.html", recording.path, empty.path),
                  std::system_error);
  CHECK_FALSE(std::filesystem::exists(page.path));
}

TEST_CASE("the page of cca is where the target says") {  // and elsewhere: tests/consumers/page.cmake
  CHECK(cca::recording::page_of_cca() == CCA_RECORDING_PAGE);
  CHECK(cca::recording::page_without_recording() == CCA_RECORDING_PAGE);
}

TEST_CASE("a program writes the page of its run") {
  const temporary_file page("of_run"), recording("of_run_too");
  program alone(page.path);
  REQUIRE(cca::run_robot(alone, "walk") == 0);
  CHECK(recording_in(bytes_in(page.path)).starts_with("\x89MCAP"));
  program both(page.path, recording.path);
  REQUIRE(cca::run_robot(both, "walk") == 0);
  CHECK(recording_in(bytes_in(page.path)) == bytes_in(recording.path));
  program twice(page.path, page.path);
  CHECK_THROWS_WITH_AS(cca::run_robot(twice, "walk"),
                       doctest::Contains(" name one file: give each option its own"), cca::refused);
  program nowhere("/nowhere/a.html", recording.path);
  CHECK(cca::run_robot(nowhere, "walk") == cca::exit_code::error);
  CHECK_FALSE(std::filesystem::exists(page.path + ".mcap"));
}
