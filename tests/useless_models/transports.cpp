// Transports that carry nothing. Each process that they join waits ten seconds for the other, so these trials
// are a test of their own.
#include <memory>
#include <string>

#include "../laws/transport_laws.hpp"
#include "trials.hpp"

using namespace useless;

namespace {

// What one process sees alone.
template <class D>
struct alone : cca::peers {
  std::shared_ptr<cca::exchange<D>> own = std::make_shared<cca::exchange<D>>();
  cca::exchange<D>* exchanged() { return own.get(); }
  bool is_gone(int) const override { return false; }
};
struct silent {
  template <class D>
  std::shared_ptr<alone<D>> open(const cca::environments_here<D>&) const {
    return std::make_shared<alone<D>>();
  }
};
struct refusing {
  template <class D>
  std::shared_ptr<alone<D>> open(const cca::environments_here<D>&) const {
    throw cca::refused("no");
  }
};
// Says that all samples of the others have come for ever, and shows what was there when it began. It is gone
// when somebody asks, so a run ends.
struct stale {
  template <class D>
  struct snapshot : alone<D> {
    bool is_gone(int) const override { return true; }
  };
  template <class D>
  std::shared_ptr<snapshot<D>> open(const cca::environments_here<D>& here) const {
    auto one = std::make_shared<snapshot<D>>();
    for (std::size_t e = 0; e < here.size(); ++e)
      if (!here[e]) {
        auto& other = one->own->environments[e];
        other.arrived = other.ready = 1'000'000;
        other.position = other.length = cca::detail::no_position / 2;
      }
    return one;
  }
};

template <class Transport>
struct meeting {
  static Transport transport(const std::string&) { return {}; }
  static std::string other_name() { return "useless"; }
};
template <class Transport>
void suite() {
  using at = meeting<Transport>;
  laws::law("has the bits of one loop", transport_laws::has_the_bits_of_one_loop<at>);
  laws::law("refuses whom it must", transport_laws::refuses_whom_it_must<at>);
  // A reader of what was there at first would run for ever: nobody ever stops.
  if constexpr (!std::is_same_v<Transport, stale>)
    laws::law("stops with the others", transport_laws::stops_with_the_others<at>);
}

}  // namespace

TEST_CASE("transport") {
  try_model("transport", does_nothing, 3, suite<silent>);
  try_model("transport", refuses, 3, suite<refusing>);
  try_model("transport", repeats, 2, suite<stale>);
}
