// Reads samples of some topics from a recording and writes them as told.hpp reads them.
//
//   extract FILE.mcap /robot/angles /robot/orientation ... > sensed
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <cca/record/mcap/reader.hpp>

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  cca::recording::mcap_reader file(argv[1]);
  std::vector<std::int64_t> count(static_cast<std::size_t>(argc));
  for (cca::recording::mcap_message m; file.next(m);) {
    const std::string& topic = file.channels().at(m.channel).topic;
    for (int i = 2; i < argc; ++i) {
      if (topic != argv[i]) continue;
      constexpr std::size_t head = 4, numbers = head + 2 * sizeof(std::int64_t);  // CDR, then beat and origin
      const auto index = static_cast<std::uint32_t>(i - 2);
      const auto size = static_cast<std::uint32_t>((m.data.size() - numbers) / sizeof(double));
      std::fwrite(&index, sizeof index, 1, stdout);
      std::fwrite(&size, sizeof size, 1, stdout);
      std::fwrite(m.data.data() + head, 1, numbers - head + size * sizeof(double), stdout);
      ++count[static_cast<std::size_t>(i)];
    }
  }
  for (int i = 2; i < argc; ++i)
    if (count[static_cast<std::size_t>(i)] == 0) {
      std::fprintf(stderr, "%s has no samples of %s\n", argv[1], argv[i]);
      return 1;
    }
  if (!file.damage().empty()) std::fprintf(stderr, "%s\n", file.damage().c_str());
  return file.damage().empty() ? 0 : 1;
}
