// A recording, replayed: the bytes are a whole file; or, after a byte that says so, records after the head
// of a right one, outside of chunks or in a chunk of their own, so that checksums and definitions hold. It is
// refused, or it ends: soon, and with a result that fits to itself.
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include <unistd.h>

#include <cca/base/file.hpp>
#include <cca/record/replay.hpp>

#include "../runtime/record/graphs.hpp"
#include "../runtime/record/rewriting.hpp"
#include "memory_file.hpp"

namespace {

namespace mcap = cca::recording::detail;

struct graph : record_test::walking<> {};

// What a recording has before its first message.
std::vector<unsigned char> head_of_recording() {
  const std::string name =
      (std::filesystem::temp_directory_path() / ("cca_fuzz_replay_" + std::to_string(::getpid()))).string();
  {
    cca::controller<graph> c;
    const cca::recording::recorder recording(c, name, {.viewer_hz = 0});
  }
  record_test::rewrite(
      name, name + ".head",
      {.compression = "none", .change = [](const std::string&, record_test::bytes&) { return false; }});
  const std::string all = cca::detail::read_file(name + ".head");
  std::filesystem::remove(name);
  std::filesystem::remove(name + ".head");
  constexpr std::size_t end = 9 + 4 + 9 + 20 + 8;  // the end of the data, the footer, and the magic bytes
  return {all.begin(), all.end() - end};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::memory_file file;
  static const std::vector<unsigned char> head = head_of_recording();
  const mcap::byte_view bytes(data, size);
  mcap::byte_writer all;
  if (size == 0 || data[0] > 1) {
    all.add(bytes);
  } else {
    const mcap::byte_view records = bytes.subspan(1);
    all.add(mcap::byte_view(head));
    if (data[0] == 0) {
      all.add(records);
    } else {
      mcap::byte_writer chunk;
      chunk.add(std::uint64_t{0}).add(std::uint64_t{0}).add(std::uint64_t{records.size()});
      chunk.add(std::uint32_t{0}).add(std::string_view()).add(std::uint64_t{records.size()}).add(records);
      all.add(static_cast<std::uint8_t>(mcap::op::chunk)).add(std::uint64_t{chunk.size()}).add(chunk.view());
    }
    all.add(static_cast<std::uint8_t>(mcap::op::data_end)).add(std::uint64_t{4}).add(std::uint32_t{0});
  }
  file.holds(all.view().data(), all.size());
  try {
    constexpr std::int64_t most_silent_beats = 1000;
    const auto result =
        mcap::replay_run<graph, mcap::recorded_items<graph>>(file.name(), most_silent_beats).go();
    fuzz::must(result.beats >= 0 && result.samples >= 0);
    fuzz::must(result.difference.empty() ? bool(result) == result.ended_early.empty() : !result);
    fuzz::must(!result || result.beats > 0);
  } catch (const cca::refused& e) { fuzz::must(std::string_view(e.what()).starts_with(file.name())); }
  return 0;
}
