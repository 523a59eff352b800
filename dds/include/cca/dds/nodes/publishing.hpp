// What every publisher is: a node that leaves its inputs for the thread of the connection. It sends once all
// inputs have a sample.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/dds/nodes/outgoing.hpp>

namespace cca::dds::detail {

template <class Message, class Quality>
class publishes {
public:
  std::int64_t sent() const { return to ? to->sent() : 0; }
  std::int64_t dropped() const { return to ? to->dropped() : 0; }

  // For programs, after the run (base/after_run.hpp).
  std::string summary() const {
    return dropped() > 0 ? std::to_string(dropped()) + " samples dropped: a reader did not keep up" : "";
  }

protected:
  void open(const address& at) { to.open(at); }

  template <class... Inputs>
  void publish(const beat& now, const Inputs&... inputs) {
    const std::int64_t oldest = std::min({inputs.origin()...});
    if (!to || oldest == never) return;
    const std::int64_t age = std::max<std::int64_t>(now.time() - oldest, 0);
    if constexpr (sizeof...(Inputs) == 1) {
      (to->put(inputs.vector(), age), ...);
    } else {
      Eigen::Matrix<double, Message::size, 1> all;
      int next = 0;
      ((all.template segment<Inputs::space::size>(next) = inputs.vector(), next += Inputs::space::size), ...);
      to->put(all, age);
    }
  }

private:
  connected<outgoing<Message, Quality>> to;
};

}  // namespace cca::dds::detail
