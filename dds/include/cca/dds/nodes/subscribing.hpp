// What every subscriber is: a node that takes what the thread of the connection has received and checked.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <cca/dds/nodes/incoming.hpp>

namespace cca::dds::detail {

template <class Message, class Quality>
class subscribes {
public:
  void on_start() {
    if (from) from->forget();
  }

  std::int64_t received() const { return from ? from->received() : 0; }
  std::int64_t refused() const { return from ? from->refused() : 0; }
  std::int64_t too_late() const { return from ? from->too_late() : 0; }
  std::string_view why_refused() const { return from ? from->why_refused() : std::string_view(); }

  // For programs, after the run (base/after_run.hpp).
  std::string summary() const {
    std::string all;
    if (refused() > 0)
      all = std::to_string(refused()) + " messages refused, the newest: " + std::string(why_refused());
    if (too_late() > 0)
      all += (all.empty() ? "" : "; ") + std::to_string(too_late()) +
             " dropped, because no beat took them in time";
    return all;
  }

protected:
  using vector_type = typename incoming<Message, Quality>::vector_type;

  void open(const address& at) { from.open(at); }
  // The newest message since the last firing. False: there is none.
  bool take(vector_type& to, std::int64_t& age) { return from && from->take(to, age); }

private:
  connected<incoming<Message, Quality>> from;
};

}  // namespace cca::dds::detail
