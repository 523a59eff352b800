// What was refused, and from whom: for people who look for a wrong program in the domain.
#pragma once

#include <cstdint>
#include <iostream>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace cca::dds {

// Messages of one sender that were refused for one reason.
struct refusal {
  std::string who;  // host, process and environments as far as the sender says, and its participant
  std::string why;
  std::int64_t count = 0;
};

namespace detail {

// The receiving thread counts, any thread reads.
class refusals {
public:
  void add(const std::string& who, std::string_view why) {
    const std::lock_guard lock(one_at_a_time);
    ++total;
    for (refusal& known : all)
      if (known.who == who && known.why == why) return void(++known.count);
    if (all.size() == most) return;
    all.push_back({who, std::string(why), 1});
    std::cerr << "cca::dds: refused from " + who + ": " + std::string(why) + "\n";
  }
  void add_not_finite() {
    const std::lock_guard lock(one_at_a_time);
    ++not_finite;
  }
  std::int64_t count() const {
    const std::lock_guard lock(one_at_a_time);
    return total;
  }
  std::int64_t count_not_finite() const {
    const std::lock_guard lock(one_at_a_time);
    return not_finite;
  }
  std::vector<refusal> list() const {
    const std::lock_guard lock(one_at_a_time);
    return all;
  }

private:
  static constexpr std::size_t most = 64;
  mutable std::mutex one_at_a_time;
  std::int64_t total = 0, not_finite = 0;
  std::vector<refusal> all;
};

}  // namespace detail
}  // namespace cca::dds
