#include "firing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <mutex>
#include <numeric>
#include <tuple>
#include <utility>

namespace semantics {

namespace {

unsigned scrambled(int a, int b, int c) {
  unsigned x = static_cast<unsigned>(a) * 2654435761u ^ static_cast<unsigned>(b) * 2246822519u ^
               static_cast<unsigned>(c) * 3266489917u;
  x ^= x >> 15;
  x *= 2246822519u;
  x ^= x >> 13;
  x *= 3266489917u;
  return x ^ (x >> 16);
}

std::mutex threads;
std::deque<log> of_threads;

}  // namespace

void record(const firing& f) {
  if (!recording) {
    const std::lock_guard lock(threads);
    recording = &of_threads.emplace_back();
  }
  recording->push_back(f);
}

log recorded_by_threads() {
  const std::lock_guard lock(threads);
  log all;
  for (const log& one : of_threads) all.insert(all.end(), one.begin(), one.end());
  of_threads.clear();
  return all;
}

std::uint64_t digest(const firing& f) {
  std::uint64_t key = 1469598103934665603u;
  const auto add = [&](std::uint64_t fact) { key = (key ^ fact) * 1099511628211u; };
  const auto add_number = [&](double number) { add(std::bit_cast<std::uint64_t>(number)); };
  const auto add_all = [&](const std::vector<double>& numbers) {
    add(numbers.size());
    for (const double number : numbers) add_number(number);
  };
  add(static_cast<std::uint64_t>(f.id));
  add(static_cast<std::uint64_t>(f.which));
  add(static_cast<std::uint64_t>(f.beat));
  add(static_cast<std::uint64_t>(f.time));
  add_number(f.dt);
  for (const recorded_input& s : f.inputs) {
    for (const char letter : s.name) add(static_cast<unsigned char>(letter));
    add_all(s.value);
    add(static_cast<std::uint64_t>(s.origin));
    add(s.fresh);
    add(s.wired);
    add(static_cast<std::uint64_t>(s.dropped));
  }
  for (const recorded_output& t : f.outputs) {
    add_all(t.value);
    add(t.is_maybe);
    add(t.published);
    add(t.sets_origin);
    add(static_cast<std::uint64_t>(t.origin));
  }
  add(f.fault);
  return key;
}

log in_order_of_content(log seen) {
  std::sort(seen.begin(), seen.end(), [](const firing& a, const firing& b) { return digest(a) < digest(b); });
  return seen;
}

log merged(log all) {
  // A graph that is used twice has components of one id in two threads: all that they record decides.
  std::vector<std::uint64_t> digests;
  for (const firing& f : all) digests.push_back(digest(f));
  const auto key = [&](std::size_t i) {
    const firing& f = all[i];
    return std::tuple(f.which == function::on_fault, f.beat, f.which, f.id, digests[i]);
  };
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  log ordered;
  for (const std::size_t i : order) ordered.push_back(std::move(all[i]));
  return ordered;
}

void add_input(firing& f,
               std::string_view name,
               const double* values,
               int size,
               std::int64_t origin,
               bool fresh,
               bool wired,
               std::int64_t dropped) {
  f.inputs.push_back(
      {std::string(name), std::vector<double>(values, values + size), origin, fresh, wired, dropped});
}

void add_output(firing& f, int size, bool is_maybe) {
  f.outputs.push_back({std::vector<double>(static_cast<std::size_t>(size)), is_maybe});
}

void copy_value(const recorded_output& from, double* to) {
  std::copy(from.value.begin(), from.value.end(), to);
}

void respond(const habit& h, memory& m, firing& f) {
  // Every figure that the component is told changes every value from here on. Folded into -8 to 8, so that
  // nothing grows.
  double s = 0.5 * m.state + 0.125 * h.id + 0.01 * static_cast<double>(f.beat) + 3 * f.dt +
             1e-9 * static_cast<double>(f.time);
  double weight = 0.25;
  for (const auto& input : f.inputs) {
    for (const double coordinate : input.value) s += (weight += 0.0625) * coordinate;
    if (input.origin != never) s += weight * 1e-8 * static_cast<double>(input.origin);
    if (input.fresh) s += weight;
    if (!input.wired) s -= weight;
  }
  m.state = std::fmod(s, 8.0);
  ++m.firings;

  for (std::size_t i = 0; i < f.outputs.size(); ++i) {
    auto& output = f.outputs[i];
    const unsigned dice = scrambled(h.id, m.firings, static_cast<int>(i));
    output.published = !output.is_maybe || dice % 100 < static_cast<unsigned>(h.publishes);
    for (std::size_t c = 0; c < output.value.size(); ++c)
      output.value[c] =
          output.published ? m.state + 0.5 * static_cast<double>(i) - 0.375 * static_cast<double>(c) : 0.0;
    const auto period = f.beat > 0 ? f.time / f.beat : 0;
    const int choice = h.origin == 2 ? 2 + static_cast<int>(dice / 128 % 3) : h.origin;
    output.sets_origin = output.published && choice > 0 && choice < 4;
    if (output.sets_origin)
      output.origin = choice == 1 ? f.time - 2 * period : choice == 2 ? f.time : f.time + period;
  }
  f.fault = f.may_fault && h.fault_at >= 0 && f.beat >= h.fault_at;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

bool same(const firing& a, const firing& b) {
  if (a.id != b.id || a.which != b.which || a.beat != b.beat || a.time != b.time || a.fault != b.fault)
    return false;
  if (std::memcmp(&a.dt, &b.dt, sizeof a.dt) != 0) return false;
  if (a.inputs.size() != b.inputs.size() || a.outputs.size() != b.outputs.size()) return false;
  for (std::size_t i = 0; i < a.inputs.size(); ++i) {
    const auto &x = a.inputs[i], &y = b.inputs[i];
    if (x.name != y.name || !same(x.value, y.value) || x.origin != y.origin || x.fresh != y.fresh ||
        x.wired != y.wired || x.dropped != y.dropped)
      return false;
  }
  for (std::size_t i = 0; i < a.outputs.size(); ++i) {
    const auto &x = a.outputs[i], &y = b.outputs[i];
    if (!same(x.value, y.value) || x.published != y.published || x.sets_origin != y.sets_origin ||
        x.origin != y.origin)
      return false;
  }
  return true;
}

std::ostream& operator<<(std::ostream& to, const firing& f) {
  constexpr const char* names[] = {"sense", "process", "act", "on_fault", "look"};
  to.precision(17);
  to << "beat " << f.beat << ": component " << f.id << " " << names[static_cast<int>(f.which)] << ", dt "
     << f.dt << " s, time " << f.time;
  for (const auto& input : f.inputs) {
    to << "\n    sees " << input.name << " (";
    for (const double coordinate : input.value) to << ' ' << coordinate;
    to << " ) of ";
    if (input.origin == never) to << "never";
    else to << input.origin;
    to << (input.fresh ? ", fresh" : "") << (input.wired ? "" : ", not wired");
    if (input.dropped > 0) to << ", " << input.dropped << " lost";
  }
  for (const auto& output : f.outputs) {
    to << "\n    tells (";
    for (const double coordinate : output.value) to << ' ' << coordinate;
    to << " )" << (output.published ? "" : ", not published");
    if (output.sets_origin) to << " of " << output.origin;
  }
  if (f.fault) to << "\n    fault";
  return to;
}

}  // namespace semantics
