// Other threads look at a controller that runs, and ask it for changes. Neither side waits: the loop writes
// what it observes into rings, and takes at most one request between two beats.
//
//   cca::live_access live(c);                                    // before the run
//   std::thread window([&] {
//     const auto leg = live.newest("robot.angles");              // an output that the graph observes
//     if (!live.set("gait.frequency", 2.0)) { /* busy: later */ }
//   });
//   c.run(cca::for_<10>{}, cca::at_wall_clock(), live);          // as `between`
//
// Any thread may call any member function but the call operator, which is the loop's. A request is checked in
// the thread that makes it: what is wrong with it is `cca::refused` there, with the messages of `controller`.
// `false`: an earlier request has not been taken yet. Parameters are known as of the time when this was made
// and as they were set here, so set them here alone while it is in use. Cost: what is observed is copied
// once, and one atomic number is read. set and load of a path or file need <cca/config.hpp>. Example:
// tests/runtime/core/live.cpp; docs/controller.md.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include <cca/graph/modes.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/runtime/live/known_parameters.hpp>
#include <cca/runtime/live/live_output.hpp>

namespace cca {

template <class Controller>
class live_access {
  static_assert(
      sizeof(Controller) == 0,
      "cca::live_access: it is made from a cca::controller; of a cca::deployed, any thread may read "
      "figures(), late() and overruns(), and parameters are set between two runs");
};

template <Modes M>
class live_access<controller<M>> {
  static_assert(sizeof(M) == 0,
                "cca::live_access: it is made from the controller of one graph; of a set of modes, copy what "
                "other threads read (observed(), mode()) and apply what they ask for (set(), switch_to()) "
                "between two beats, in the call that run() takes");

public:
  explicit live_access(const controller<M>&) {}
};

template <class Graph>
  requires(!Modes<Graph>)
class live_access<controller<Graph>> {
  using shadows = detail::known_parameters<Graph>;

public:
  explicit live_access(const controller<Graph>& c) : known(c) {
    c.observed([&](const observation& o) {
      outputs.emplace_back(o.path, o.values.size());
      if (o.origin != never) outputs.back().put(o);
    });
    look_at(c);
  }

  // The loop calls it between two beats. False: another thread has called `end_run()`.
  bool operator()(controller<Graph>& c) {
    std::size_t i = 0;
    c.observed([&](const observation& o) {
      if (o.fresh) outputs[i].put(o);
      ++i;
    });
    look_at(c);
    if (mailbox.load(std::memory_order_acquire) == mail::posted) {
      take(c);
      mailbox.store(mail::empty, std::memory_order_release);
    }
    return !ends.load(std::memory_order_acquire);
  }

  // ---- what it does ----

  // The newest sample of an output that an item `observe<...>` of the graph names; empty if there is none
  // yet.
  std::optional<live_sample> newest(std::string_view path) const {
    for (const auto& output : outputs)
      if (output.path() == path) return output.newest();
    throw refused("cca::live_access: nobody observes `" + std::string(path) + "`: add cca::observe<\"" +
                  std::string(path) + "\"> to the items of the graph");
  }
  cca::state state() const noexcept { return now.load(std::memory_order_acquire); }
  std::int64_t beat_index() const noexcept { return k.load(std::memory_order_acquire); }
  std::int64_t overruns() const noexcept { return late.load(std::memory_order_acquire); }
  cca::fault fault() const noexcept {
    const char* const why = reason.load(std::memory_order_acquire);
    return why ? cca::fault(why) : cca::fault();
  }

  // ---- requests; false: an earlier one has not been taken yet ----

  // Other parameters of a component, as `controller::set`.
  template <fixed_string Path, class Parameters = typename detail::parameters_at<Graph, Path>::type>
  bool set(const Parameters& parameters) {
    if constexpr (detail::can_set<Graph, Path>())
      return request(asked::parameters, [&] {
        auto& own = known.template of<detail::node_at<Graph>(Path.view())>();
        detail::apply_parameters(own, parameters, Path.view(), shadows::step_of(Path.view()));
      });
    else return false;
  }
  template <class Value>
  bool set(std::string_view path, const Value& value) {
    static_assert(detail::HasConfig<shadows>,
                  "cca::live_access: set(path, value) needs #include <cca/config.hpp>");
    return request(asked::parameters, [&] { detail::config_backend<shadows>::set(known, path, value); });
  }
  // All parameters that a file names, in one beat.
  bool load(std::string_view file) {
    static_assert(detail::HasConfig<shadows>, "cca::live_access: load(file) needs #include <cca/config.hpp>");
    return request(asked::parameters, [&] { detail::config_backend<shadows>::load(known, file); });
  }
  // As they are known here. Empty: busy.
  std::optional<std::string> parameter(std::string_view path) {
    static_assert(detail::HasConfig<shadows>,
                  "cca::live_access: parameter(path) needs #include <cca/config.hpp>");
    if (!claim()) return {};
    const claimed until_the_end{mailbox};
    return detail::config_backend<shadows>::template get<std::string>(known, path);
  }

  // A component with the strategy `stoppable`.
  bool stop(std::string_view path) {
    return request(asked::stop, [&] { node = detail::stoppable_node_named<Graph>(path); });
  }
  bool start(std::string_view path) {
    return request(asked::start, [&] { node = detail::stoppable_node_named<Graph>(path); });
  }

  // The run ends after its beat; so does each later one.
  void end_run() noexcept { ends.store(true, std::memory_order_release); }

  // Whether the last request has been taken, and which component refused it then (`refusal_of`); empty: none.
  bool is_taken() const noexcept { return mailbox.load(std::memory_order_acquire) == mail::empty; }
  std::string refused_by() const {
    const int refusing_node = refusing.load(std::memory_order_acquire);
    return refusing_node < 0 ? std::string() : known.path(refusing_node);
  }

private:
  enum class mail { empty, being_written, posted };
  enum class asked { parameters, stop, start };
  // Nobody else may write until then.
  struct claimed {
    std::atomic<mail>& mailbox;
    mail then = mail::empty;
    ~claimed() { mailbox.store(then, std::memory_order_release); }
  };

  bool claim() {
    mail expected = mail::empty;
    return mailbox.compare_exchange_strong(expected, mail::being_written, std::memory_order_acquire);
  }
  template <class F>
  bool request(asked about, F prepare) {
    if (!claim()) return false;
    claimed until_posted{mailbox};
    prepare();  // may throw: then nothing is asked
    what = about;
    until_posted.then = mail::posted;
    return true;
  }
  void take(controller<Graph>& c) {
    int refused_here = -1;
    if (what == asked::parameters) {
      refused_here = known.give_to(c);
      detail::tell_parameters(c);
    } else if (what == asked::stop) c.stop(known.path(node));
    else c.start(known.path(node));
    refusing.store(refused_here, std::memory_order_release);
  }
  void look_at(const controller<Graph>& c) noexcept {
    now.store(c.state(), std::memory_order_release);
    k.store(c.beat_index(), std::memory_order_release);
    late.store(c.overruns(), std::memory_order_release);
    const cca::fault why = c.fault();
    reason.store(why ? why.reason() : nullptr, std::memory_order_release);
  }

  shadows known;
  std::deque<detail::live_output> outputs;
  std::atomic<mail> mailbox{mail::empty};
  asked what = asked::parameters;
  int node = -1;
  std::atomic<int> refusing{-1};
  std::atomic<cca::state> now{};
  std::atomic<std::int64_t> k{0}, late{0};
  std::atomic<const char*> reason{nullptr};
  std::atomic<bool> ends{false};
};

template <class Controller>
live_access(const Controller&) -> live_access<Controller>;

}  // namespace cca
