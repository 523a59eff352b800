// A farm with one thread per worker: a worker may take longer than a beat, and the loop never waits for it.
//
//   cca::node<"ik",
//             cca::farm_on_threads<leg_ik, cca::array_of<paw_position, 4>, cca::array_of<leg_angles, 4>>>
//   in  "input"     From: each fresh sample is a task
//   out "output"    To, a `maybe`: a result, with the origin of its task
//   out "waiting"   a number: tasks under way, from being handed out to being published
//   out "dropped"   a number: tasks lost since the start, because `capacity` others were under way
//
// The fourth argument sets the order of results. `in_order`: each result once, the oldest first, one per
// beat. `as_they_come`: each part as soon as its worker has it, only the newest; the whole has the oldest
// origin of its parts. If a worker is slow, results are late; once `capacity` tasks are under way, further
// tasks are lost and counted. To set more,
//
//   struct patient : cca::in_order {
//     static constexpr int capacity = 16;
//     static constexpr std::chrono::microseconds rest{200};
//   };
//
// `rest` is how often an idle worker looks for a task. The values of results do not depend on the threads,
// but the beat in which they come does: this is the only component that depends on real time. `cca::farm` has
// the same input and output and gives the same results in the same beat.
//
// Threads begin in on_start. on_stop never waits for them: a robot that stops, or changes its mode, goes on
// getting frames. A worker that is busy then finishes its task in its thread, where its own on_stop runs. It
// is back when the farm starts again or saves; if it is still busy, its place gets the worker as it was when
// the farm started before. The destructor waits for it. Copying a running controller waits until the tasks
// under way are done; the copy gets the workers, the results still to be published, and threads of its own. A
// change of a worker's parameters takes effect at the next start. Errors: skeleton.arity; cca::refused, if
// the system has no more threads. Cost: two atomic loads and two stores per worker and beat; no allocation,
// no lock, no system call. Example: tests/runtime/skeleton/threads.cpp; docs/skeletons.md.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <system_error>
#include <tuple>
#include <utility>

#include <cca/base/inlining.hpp>
#include <cca/base/refused.hpp>
#include <cca/component/parameters.hpp>
#include <cca/skeleton/crew.hpp>
#include <cca/skeleton/farm.hpp>
#include <cca/skeleton/worker_task.hpp>

namespace cca {

struct in_order {
  static constexpr int capacity = 4;
  static constexpr std::chrono::microseconds rest{50};
};
struct as_they_come : in_order {};

struct task_count : space<number, axes<x>> {};

namespace detail {

// All workers have the same parameters.
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
  using work = worker_task<Worker>;
  using threads = crew<work, count, Order::capacity>;
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
        at_work(other.at_work ? std::make_unique<threads>(*other.at_work) : nullptr) {}
  threaded_farm(threaded_farm&&) = default;
  threaded_farm& operator=(threaded_farm other) {
    static_cast<shared_parameters<Worker>&>(*this) = other;
    workers = other.workers;
    whole = other.whole, origins = other.origins, is_new = other.is_new;
    last_task = other.last_task, lost = other.lost;
    retire();
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
    fetch();
    each([](auto& w) {
      if constexpr (OnSave<Worker>) w.on_save();
    });
  }
  void on_start() {
    fetch();
    is_out = {};
    forget_the_ended();
    each([&](auto& w) {
      if constexpr (HasParameters<Worker>) w.p = this->p;
      if constexpr (OnStart<Worker>) w.on_start();
    });
    is_new = {}, last_task = -1, lost = 0;
    try {
      at_work = std::make_unique<threads>(workers, Order::rest);
    } catch (const std::system_error& error) {
      throw refused(std::string("cca::farm_on_threads: the system gives no more threads: ") + error.what());
    }
  }
  void on_stop() {
    if (!at_work) return;  // on_start was refused
    for (std::size_t i = 0; i < count; ++i) is_out[i] = !at_work->stop(i);
    for (std::size_t i = 0; i < count; ++i) {
      if (is_out[i]) continue;
      workers[i] = at_work->at(i);
      work::stopped(workers[i]);
    }
    retire();
  }

  // Waits until all tasks are done: for tests, and where waiting is allowed.
  void wait() const { at_work->wait(); }

private:
  template <class F>
  void each(F f) {
    for (auto& w : workers) f(w);
  }

  // The threads of the last crews may still be busy.
  void retire() noexcept {
    if (!at_work) return;
    at_work->stop();
    at_work->before = std::move(retired);
    retired = std::move(at_work);
  }
  void forget_the_ended() {
    for (auto* one = &retired; *one;)
      if ((*one)->has_ended()) *one = std::move((*one)->before);
      else one = &(*one)->before;
  }
  // Workers that were busy when the farm was stopped, and are back.
  void fetch() {
    for (std::size_t i = 0; retired && i < count; ++i)
      if (is_out[i] && retired->is_back(i)) {
        workers[i] = retired->at(i);
        is_out[i] = false;
      }
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

  // True if there is a whole to publish: every part has arrived and, with in_order, is new.
  CCA_INLINE bool take() noexcept {
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
  std::unique_ptr<threads> at_work, retired;
  std::array<bool, count> is_out{};  // in the last crew that was retired
};

template <class Worker>
struct wrong_worker {
  static constexpr text message() {
    text t;
    t << "is to have " << type_name<Worker>() << " on threads, ";
    if constexpr (Graph<Worker>)
      t << "but that is a graph, whose nodes run in the loop: put what it does into one component";
    else t << "but that may return a fault, which would reach the loop too late: publish a status instead";
    return t;
  }
};

template <class Worker, class From, class To, class Order>
constexpr auto threaded_kind() {
  if constexpr (workers_in<Worker, From, To> == 0)
    return std::type_identity<bad_skeleton<wrong_farm<Worker, From, To>>>();
  else if constexpr (Graph<Worker>) return std::type_identity<bad_skeleton<wrong_worker<Worker>>>();
  else if constexpr (function_may_fault<Worker>)
    return std::type_identity<bad_skeleton<wrong_worker<Worker>>>();
  else
    return std::type_identity<graph<node<"crew", threaded_farm<Worker, From, To, Order>, full_speed>,
                                    expose<"crew.input", "input">, expose<"crew.output", "output">,
                                    expose<"crew.waiting", "waiting">, expose<"crew.dropped", "dropped">>>();
}

}  // namespace detail

template <class Worker, class From, class To, class Order = in_order>
struct farm_on_threads : decltype(detail::threaded_kind<Worker, From, To, Order>())::type {
  using stage_input = detail::stage_port<"input", From>;
  using stage_output = detail::stage_port<"output", To>;
};

}  // namespace cca
