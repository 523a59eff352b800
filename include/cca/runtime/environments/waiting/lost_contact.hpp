// The reason of a fault where an environment's samples stay away, as static text; and its cause, for a
// person: what the environment needed, what it had, and what to change.
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

#include <cca/base/array_size.hpp>
#include <cca/graph/deployment/environments.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>
#include <cca/runtime/pace.hpp>

namespace cca::detail {

template <class D>
inline constexpr auto lost_contacts = [] {
  constexpr std::size_t longest = [] {
    std::size_t size = 0;
    for (const auto& e : environments_of<D>::all) size = e.name.size() > size ? e.name.size() : size;
    return size;
  }();
  std::array<std::array<char, longest + 24>, array_size(environment_count<D>)> texts{};
  for (std::size_t e = 0; e < texts.size(); ++e) {
    char* end = texts[e].data();
    for (const std::string_view part :
         {std::string_view("lost contact with `"), environments_of<D>::all[e].name, std::string_view("`")})
      for (const char letter : part) *end++ = letter;
  }
  return texts;
}();

template <class D>
constexpr std::string_view lost_contact(int environment) {
  const auto& text = lost_contacts<D>[array_size(environment)];
  return {text.data(), environments_of<D>::all[array_size(environment)].name.size() + 20};
}

// Plain numbers, taken when the run has ended; the text is made when somebody asks for it.
struct contact_loss {
  int lost = -1;              // the environment; -1: no contact was lost
  bool has_ended = false;     // its process, without the end of the run
  std::int64_t beat = -1;     // in which it needed most time
  std::int64_t needed = 0;    // ns
  std::int64_t allowed = 0;   // ns: what the delay of its wires gives it
  std::int64_t interval = 0;  // ns between two beats

  template <class D>
  static contact_loss in(const exchange<D>& shared,
                         std::size_t loser,
                         std::size_t own,
                         const fault_record& of) {
    contact_loss one;
    if (of.node >= 0) return one;
    for (int x = 0; x < environment_count<D>; ++x)
      if (lost_contact<D>(x) == std::string_view(of.reason.data())) one.lost = x;
    if (one.lost < 0) return one;
    const auto& other = shared.environments[array_size(one.lost)];
    one.has_ended = other.finished.load(std::memory_order_acquire) < shared.environments[own].finished;
    const std::int64_t since = other.slowest.since.load(std::memory_order_relaxed);
    one.beat = since != 0 ? other.slowest.running : other.slowest.beat;
    one.needed = since != 0 ? monotonic_clock::now() - since : other.slowest.needed.load();
    one.interval = shared.environments[0].interval;
    const int delay = crossings_of<D>.least_delay[array_size(one.lost)][loser];
    one.allowed = one.interval * (delay > 0 ? delay : 1);
    return one;
  }

  template <class D>
  std::string text() const {
    if (lost < 0) return {};
    const std::string name = "`" + std::string(environments_of<D>::all[array_size(lost)].name) + "`";
    const std::string tolerated = std::to_string(environments_of<D>::tolerated);
    const std::string more =
        "give its wires a greater delay, or the deployment more than `tolerate<" + tolerated + ">`";
    if (has_ended) return "the process of " + name + " has ended, or nothing is heard of it";
    if (beat < 0 || needed <= allowed)
      return name + " was late in more than " + tolerated + " beats in a row: " + more;
    return name + " needed " + milliseconds(needed) + " of " + milliseconds(allowed) + " in beat " +
           std::to_string(beat) + ": " + more;
  }

private:
  static std::string milliseconds(std::int64_t ns) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g ms", 1e-6 * static_cast<double>(ns));
    return text;
  }
};

}  // namespace cca::detail
