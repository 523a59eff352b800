// The part of cca::live_access that asks for changes. Any thread asks; a loop takes its part between two of
// its beats.
#pragma once

#include <array>
#include <atomic>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <cca/runtime/live/known_parameters.hpp>
#include <cca/runtime/live/live_mailbox.hpp>
#include <cca/runtime/parameters_by_path.hpp>

namespace cca::detail {

template <class Controller, class Graph>
class live_requests {
  using shadows = known_parameters<Controller, Graph>;
  using loops = live_loops<Controller>;

public:
  // ---- any thread; false: an earlier request has not been taken yet ----

  // Other parameters of a component, as `controller::set`.
  template <fixed_string Path>
  bool set(const typename parameters_at<Graph, Path>::type& parameters) {
    static_assert(sizeof(path_refusal<Graph, 0, Path>) != 0);
    if constexpr (has_parameters<Graph, Path>()) {
      constexpr int target = node_at<Graph>(Path.view());
      return request(asked::parameters, target, [&] {
        apply_parameters(known.template of<target>(), parameters, Path.view(), shadows::step_of(Path.view()));
      });
    } else {
      return false;
    }
  }
  template <class Value>
  bool set(std::string_view path, const Value& value) {
    static_assert(has_config<shadows>, "cca::live_access: set(path, value) needs #include <cca/config.hpp>");
    return request(asked::parameters, node_of_parameter(path),
                   [&] { config_or_none<shadows>::set(known, path, value); });
  }
  // Several parameters in one request: f(parameters) sets them in a copy, by set(path, value). What it throws
  // leaves all as it was.
  template <class F>
  bool change(F f) {
    static_assert(has_config<shadows>, "cca::live_access: change(f) needs #include <cca/config.hpp>");
    return request(asked::parameters, with_components, [&] {
      const shadows before = known;
      try {
        f([&](std::string_view path, const auto& value) {
          config_or_none<shadows>::set(known, path, value);
        });
      } catch (...) {
        known = before;
        throw;
      }
    });
  }
  // f(parameters), as they are known here: as a controller, they have for_each_component. False: busy.
  template <class F>
  bool read(F f) {
    if (!mailbox.claim()) return false;
    const given_back at_the_end{mailbox};
    f(std::as_const(known));
    return true;
  }
  // All parameters that a file names: of each loop in one beat.
  // With a path: of one component, or of those of an inner graph.
  bool load(std::string_view file, std::string_view path = {}) {
    static_assert(has_config<shadows>, "cca::live_access: load(file) needs #include <cca/config.hpp>");
    return request(asked::parameters, loops_at(path, "load"),
                   [&] { config_or_none<shadows>::load(known, file, path); });
  }
  // Writes them as they are known here, in this thread, each with what it was when this was made, as a
  // comment, where that differs.
  bool save(std::string_view file, std::string_view path = {}) {
    static_assert(has_config<shadows>, "cca::live_access: save(file) needs #include <cca/config.hpp>");
    loops_at(path, "save");
    if (!mailbox.claim()) return false;
    const given_back at_the_end{mailbox};
    config_or_none<shadows>::save_since(known, first, file, path);
    return true;
  }
  // As they are known here. Empty: busy.
  std::optional<std::string> parameter(std::string_view path) {
    static_assert(has_config<shadows>, "cca::live_access: parameter(path) needs #include <cca/config.hpp>");
    if (!mailbox.claim()) return {};
    const given_back at_the_end{mailbox};
    return config_or_none<shadows>::template get<std::string>(known, path);
  }

  // A part: a node with the strategy `stoppable`.
  bool stop(std::string_view path) { return change_part(asked::stop, part_named<Graph>(path)); }
  bool start(std::string_view path) { return change_part(asked::start, part_named<Graph>(path)); }

  // Of a set of modes; another name is refused.
  bool switch_to(std::string_view mode)
    requires Modes<Graph>
  {
    return switch_to_number(live_components::mode_number<Controller>(mode));
  }
  template <fixed_string Mode>
  bool switch_to()
    requires Modes<Graph>
  {
    return switch_to_number(live_components::mode_number<Controller, Mode>());
  }

  // Whether the last request has been taken, and what refused it then; empty: nothing. A component refuses
  // parameters (`refusal_of`), and to be stopped or started where the active mode lacks it; a mode is refused
  // after a fault.
  bool is_taken() const noexcept { return mailbox.is_empty(); }
  std::string refused_by() const {
    const int by = refusing.load(std::memory_order_acquire);
    if (by <= first_part) return path_of_part<Graph>(first_part - by);
    if constexpr (Modes<Graph>)
      if (by <= first_mode) return std::string(live_components::mode_name<Controller>(first_mode - by));
    return by < 0 ? std::string() : known.path(by);
  }

protected:
  explicit live_requests(const Controller& c)
      : known(c), first(known), ordering(live_components::ordering_loop(c)) {
    for (int node = 0; node < counts_of<Graph>.node_count; ++node)
      if (live_components::is_here(c, node)) with_components[array_size(loops::of_node(node))] = true;
    for (int part = 0; part < parts_kept<Graph>; ++part)
      by_order[array_size(part)] = live_components::needs_order(c, part);
    switches_by_order = live_components::needs_order(c, -1);
  }

  // A loop's, between two of its beats.
  template <int Loop>
  void take(Controller& c) {
    mailbox.take(Loop, [&] {
      if (is_order) return has_effect(c);
      if (const int by = do_what_is_asked<Loop>(c); by != nobody)
        refusing.store(by, std::memory_order_release);
      return true;
    });
  }

private:
  enum class asked { parameters, stop, start, mode };
  static constexpr int all_nodes = -1, nobody = -1;
  static constexpr int first_mode = -2, first_part = -1000;  // -2 - n: mode n, -1000 - n: part n
  using mailbox_type = live_mailbox<loops::count>;

  // Those with a component at this path; of all without one. Refused: a path that leads to none.
  typename mailbox_type::loops loops_at(std::string_view path, const char* call) const {
    if (path.empty()) return with_components;
    typename mailbox_type::loops to{};
    for_each_node_at<Graph>(path, call, [&](int node) {
      known.check_is_here(node);
      to[array_size(loops::of_node(node))] = true;
    });
    return to;
  }
  // Each loop that has a node of it does its share.
  bool change_part(asked about, int part) {
    if (by_order[array_size(part)]) return request_order(about, [&] { asked_part = part; });
    typename mailbox_type::loops to{};
    for (int node = 0; node < counts_of<Graph>.node_count; ++node)
      if (is_in_part<Graph>(node, part)) to[array_size(loops::of_node(node))] = true;
    return request(about, to, [&] { asked_part = part; });
  }
  // One loop gives the order, and waits until all have obeyed.
  template <class F>
  bool request_order(asked about, F prepare) {
    typename mailbox_type::loops to{};
    to[array_size(ordering)] = true;
    return request(about, to, [&] {
      prepare();
      is_order = true;
      effect_in = none;
    });
  }
  // The ordering loop's, between two of its beats. False: the beat of the order is still to come.
  bool has_effect(Controller& c) {
    if (effect_in == none) {
      if (const int by = refusal_of_order(c); by != nobody)
        return refusing.store(by, std::memory_order_release), true;
      effect_in = what == asked::mode
                      ? live_components::give_order(c, ordered::mode, asked_mode)
                      : live_components::give_order(c, what == asked::stop ? ordered::stop : ordered::start,
                                                    asked_part);
    }
    return live_components::is_over(c, effect_in);
  }
  int refusal_of_order(const Controller& c) const {
    if (what == asked::mode) return c.state() == state::faulted ? first_mode - asked_mode : nobody;
    return live_components::has_part_now(c, asked_part) ? nobody : first_part - asked_part;
  }

  struct given_back {
    mailbox_type& mailbox;
    bool is_posted = false;
    ~given_back() {
      if (!is_posted) mailbox.give_back();
    }
  };

  template <class F>
  bool request(asked about, int of, F prepare) {
    if (of < 0) return request(about, with_components, prepare);
    known.check_is_here(of);
    typename mailbox_type::loops to{};
    to[array_size(loops::of_node(of))] = true;
    return request(about, to, prepare);
  }
  template <class F>
  bool request(asked about, const typename mailbox_type::loops& to, F prepare) {
    if (!mailbox.claim()) return false;
    given_back unless_posted{mailbox};
    is_order = false;
    prepare();  // may throw: then nothing is asked
    what = about;
    refusing.store(nobody, std::memory_order_relaxed);
    unless_posted.is_posted = true;
    mailbox.post(to);
    return true;
  }
  bool switch_to_number(int number)
    requires Modes<Graph>
  {
    if (switches_by_order) return request_order(asked::mode, [&] { asked_mode = number; });
    return request(asked::mode, all_nodes, [&] { asked_mode = number; });
  }

  // Of `gait.frequency` the node `gait`; `all_nodes` where the path leads into no component.
  static int node_of_parameter(std::string_view path) {
    for (auto end = path.size(); end != path.npos && end > 0; end = path.rfind('.', end - 1))
      if (const int found = node_at<Graph>(path.substr(0, end)); found >= 0) return found;
    return all_nodes;
  }

  template <int Loop>
  int do_what_is_asked(Controller& c) {
    if (what == asked::parameters) {
      const int by = known.template give_to<Loop>(c);
      if constexpr (requires { c.template parameters_changed_in<Loop>(); })
        c.template parameters_changed_in<Loop>();
      else tell_parameters(c);
      return by;
    }
    if constexpr (Modes<Graph>)
      if (what == asked::mode) {
        if (c.state() == state::faulted) return first_mode - asked_mode;
        live_components::switch_to(c, asked_mode);
        return nobody;
      }
    if constexpr (parts_kept<Graph> > 0) {
      if (!live_components::has_part_now(c, asked_part)) return first_part - asked_part;
      live_components::set_part<Loop>(c, asked_part, path_of_part<Graph>(asked_part), what == asked::stop);
    }
    return nobody;
  }

  shadows known;
  const shadows first;                             // as they were when this was made
  typename mailbox_type::loops with_components{};  // here
  mailbox_type mailbox;
  asked what = asked::parameters;
  int asked_part = 0, asked_mode = 0;
  bool is_order = false;  // what is asked for
  static constexpr std::int64_t none = -2;
  std::int64_t effect_in = none;                                   // the beat in which the order has effect
  int ordering;                                                    // the loop that gives orders
  std::array<bool, array_size(parts_kept<Graph> + 1)> by_order{};  // of each part: whether it needs one
  bool switches_by_order = false;
  std::atomic<int> refusing{nobody};
};

}  // namespace cca::detail
