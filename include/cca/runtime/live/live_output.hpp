// The last samples of an output, for readers in any thread. One writer, which never waits for them.
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <cca/component/port.hpp>

namespace cca {

struct live_sample {
  std::vector<double> values;  // coordinates in the order of the axes
  std::int64_t origin = 0;     // ns
};

namespace detail {

class live_output {
public:
  live_output(std::string_view path, std::size_t axes) : name(path), size(axes) {
    for (slot& one : slots) one.words = std::make_unique<std::atomic<std::uint64_t>[]>(size + 1);
  }

  const std::string& path() const { return name; }

  void put(const observation& o) noexcept {
    const std::uint64_t number = count.load(std::memory_order_relaxed);
    slot& s = slots[number % slots.size()];
    s.state.store(2 * number + 1, std::memory_order_relaxed);
    s.words[0].store(static_cast<std::uint64_t>(o.origin), std::memory_order_release);
    for (std::size_t i = 0; i < size; ++i)
      s.words[i + 1].store(std::bit_cast<std::uint64_t>(o.values[i]), std::memory_order_release);
    s.state.store(2 * number + 2, std::memory_order_release);
    count.store(number + 1, std::memory_order_release);
  }

  // Empty: there is none yet. A writer that overwrites the slot while it is read is seen by its state; after
  // some such times the reader gives up, too.
  std::optional<live_sample> newest() const {
    for (int attempt = 0; attempt < 8; ++attempt) {
      const std::uint64_t number = count.load(std::memory_order_acquire);
      if (number == 0) return {};
      const slot& s = slots[(number - 1) % slots.size()];
      live_sample found;
      if (s.state.load(std::memory_order_acquire) != 2 * number) continue;
      found.origin = static_cast<std::int64_t>(s.words[0].load(std::memory_order_acquire));
      for (std::size_t i = 0; i < size; ++i)
        found.values.push_back(std::bit_cast<double>(s.words[i + 1].load(std::memory_order_acquire)));
      if (s.state.load(std::memory_order_relaxed) == 2 * number) return found;
    }
    return {};
  }

private:
  struct slot {
    std::atomic<std::uint64_t> state{0};  // 2 n + 2: it has sample n; 2 n + 1: that is being written
    std::unique_ptr<std::atomic<std::uint64_t>[]> words;
  };
  std::string name;
  std::size_t size;
  std::array<slot, 8> slots;
  std::atomic<std::uint64_t> count{0};
};

}  // namespace detail
}  // namespace cca
