// A farm whose workers have a thread each: what they do may take longer than a beat, and the loop never waits
// for them.
//
//   cca::node<"ik", cca::farm_on_threads<leg_ik, cca::array_of<paw_position, 4>, cca::array_of<leg_angles,
//   4>>> in  "input"     From: what is fresh in a beat is a task out "output"    To, a `maybe`: a result,
//   with the origin of its task out "waiting"   a number: tasks under way, from being handed out to being
//   published out "dropped"   a number: tasks that came while `capacity` others were under way, since the
//   start
//
// The fourth argument says in what order. `in_order`: each result once, the oldest first, one a beat.
// `as_they_come`: each part as soon as its worker has it, the newest; the whole then has the oldest origin of
// its parts. A worker may be slow: then results are late, and from `capacity` on tasks are lost and counted;
// the loop is not held up. To set more,
//
//   struct patient : cca::in_order { static constexpr int capacity = 16; static constexpr
//   std::chrono::microseconds rest{200}; };
//
// where `rest` is how often a worker that has nothing to do looks for a task. What a result is does not
// depend on the threads, when it comes does: of all components this one alone goes by real time. `cca::farm`
// has the same ports and gives the same results at once.
//
// Threads begin in on_start and end in on_stop. A copy of a running controller waits until the tasks under
// way are done, takes over the workers and the results that nobody has taken, and has threads of its own. A
// worker's parameters hold from the next start on. Errors: skeleton.arity; cca::refused, if the system has no
// more threads. Cost: two loads and two stores a worker in a beat; no allocation, no lock, no system call.
// Example: tests/runtime/skeleton/threads.cpp; docs/skeletons.md.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <system_error>
#include <tuple>
#include <utility>

#include <cca/base/inlining.hpp>
#include <cca/component/parameters.hpp>
#include <cca/base/refused.hpp>
#include <cca/skeleton/crew.hpp>
#include <cca/skeleton/farm.hpp>
#include <cca/skeleton/piece_work.hpp>

namespace cca {

struct in_order {
  static constexpr int capacity = 4;
  static constexpr std::chrono::microseconds rest{50};
};
struct as_they_come : in_order {};

struct task_count : space<number, axes<x>> {};

namespace detail {

// Equal workers have equal parameters.
template <class Worker>
struct shared_parameters {};
template <HasParameters Worker>
struct shared_parameters<Worker> {
  using parameters = typename Worker::parameters;
  parameters p = Worker{}.p;
};

template <class Worker, class From, class To, class Order>
class threaded_farm : public shared_parameters<Worker> {
  static constexpr int count = workers_in<Worker, From, To>;
  static constexpr bool ordered = !std::is_base_of_v<as_they_come, Order>;
  using work = piece_work<Worker>;
  using hands = crew<work, count, Order::capacity>;
  using results = std::tuple<maybe<"output", To>, out<"waiting", task_count>, out<"dropped", task_count>>;

public:
  threaded_farm() = default;
  threaded_farm(const threaded_farm& other)
      : shared_parameters<Worker>(other),
        workers(other.workers),
        whole(other.whole),
        origins(other.origins),
        is_new(other.is_new),
        last_task(other.last_task),
        lost(other.lost),
        at_work(other.at_work ? std::make_unique<hands>(*other.at_work) : nullptr) {}
  threaded_farm(threaded_farm&&) = default;
  threaded_farm& operator=(threaded_farm other) {
    static_cast<shared_parameters<Worker>&>(*this) = other;
    workers = other.workers;
    whole = other.whole, origins = other.origins, is_new = other.is_new;
    last_task = other.last_task, lost = other.lost;
    at_work = std::move(other.at_work);
    return *this;
  }
  ~threaded_farm() = default;

  auto process(in<"input", From> input, beat now) -> results {
    maybe<"output", To> output;
    if (take()) output = published();
    if (input.fresh() && !hand_out(input, now)) ++lost;
    return {output, static_cast<double>(under_way()), static_cast<double>(lost)};
  }

  void on_load() {
    each([](auto& w) {
      if constexpr (OnLoad<Worker>) w.on_load();
    });
  }
  void on_save() {
    each([](auto& w) {
      if constexpr (OnSave<Worker>) w.on_save();
    });
  }
  void on_start() {
    each([&](auto& w) {
      if constexpr (HasParameters<Worker>) w.p = this->p;
      if constexpr (OnStart<Worker>) w.on_start();
    });
    is_new = {}, last_task = -1, lost = 0;
    try {
      at_work = std::make_unique<hands>(workers, Order::rest);
    } catch (const std::system_error& error) {
      throw refused(std::string("cca::farm_on_threads: the system gives no more threads: ") + error.what());
    }
  }
  void on_stop() {
    at_work->stop();
    for (std::size_t i = 0; i < count; ++i) workers[i] = at_work->at(i);
    at_work.reset();
    each([](auto& w) {
      if constexpr (OnStop<Worker>) w.on_stop();
    });
  }

  // Until what has been handed out is done: for tests, and where one may wait.
  void wait() const { at_work->wait(); }

private:
  template <class F>
  void each(F f) {
    for (auto& w : workers) f(w);
  }

  std::size_t under_way() const {
    std::size_t most = 0;
    for (std::size_t i = 0; at_work && i < count; ++i) most = std::max(most, at_work->under_way(i));
    return most;
  }

  bool hand_out(const sample<From>& input, beat now) {
    if (!at_work || !at_work->room()) return false;
    const std::int64_t since = last_task < 0 ? 1 : now.index() - last_task;
    last_task = now.index();
    for (std::size_t i = 0; i < count; ++i)
      at_work->hand_out(
          i, {input.vector().template segment<work::taken::size>(static_cast<int>(i) * work::taken::size),
              input.origin(), beat(now.index(), now.period(), since)});
    return true;
  }

  // True if there is a whole to publish: each part has come, and, in order, is new.
  CCA_GLUE bool take() noexcept {
    if (!at_work) return false;
    if constexpr (ordered) {
      for (std::size_t i = 0; i < count; ++i)
        if (!at_work->ready(i)) return false;
    }
    bool any = false;
    for (std::size_t i = 0; i < count; ++i)
      while (at_work->ready(i)) {
        any |= put(i, at_work->take(i));
        if constexpr (ordered) break;
      }
    return any && std::all_of(is_new.begin(), is_new.end(), [](bool is) { return is; });
  }
  bool put(std::size_t i, const typename work::result& result) {
    if (!result.published) return false;
    whole.template segment<work::given::size>(static_cast<int>(i) * work::given::size) = result.value;
    origins[i] = result.origin;
    return is_new[i] = true;
  }
  out<"output", To> published() {
    if constexpr (ordered) is_new = {};
    return out<"output", To>(whole).with_origin(*std::min_element(origins.begin(), origins.end()));
  }

  std::array<Worker, count> workers{};
  typename To::vector_type whole = sample<To>().vector();
  std::array<std::int64_t, count> origins{};
  std::array<bool, count> is_new{};
  std::int64_t last_task = -1, lost = 0;
  std::unique_ptr<hands> at_work;
};

template <class Worker>
struct uneven_threads {
  static constexpr text told() {
    text t;
    t << "is to have " << type_name<Worker>() << " on threads, ";
    if constexpr (Graph<Worker>)
      t << "but that is a graph, whose nodes run in the loop: put what it does into one component";
    else t << "but that may return a fault, of which the loop would hear too late: tell of it by a status";
    return t;
  }
};

template <class Worker, class From, class To, class Order>
constexpr auto threaded_kind() {
  if constexpr (workers_in<Worker, From, To> == 0)
    return std::type_identity<uneven<uneven_farm<Worker, From, To>>>();
  else if constexpr (Graph<Worker>) return std::type_identity<uneven<uneven_threads<Worker>>>();
  else if constexpr (function_may_fault<Worker>) return std::type_identity<uneven<uneven_threads<Worker>>>();
  else
    return std::type_identity<graph<node<"crew", threaded_farm<Worker, From, To, Order>, full_speed>,
                                    expose<"crew.input", "input">, expose<"crew.output", "output">,
                                    expose<"crew.waiting", "waiting">, expose<"crew.dropped", "dropped">>>();
}

}  // namespace detail

template <class Worker, class From, class To, class Order = in_order>
struct farm_on_threads : decltype(detail::threaded_kind<Worker, From, To, Order>())::type {
  using passage_in = detail::passage<"input", From>;
  using passage_out = detail::passage<"output", To>;
};

}  // namespace cca
