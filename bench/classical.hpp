// The classical way to build a component architecture, as the source document does it: components behind
// virtual functions, found by name at run time; samples on the heap behind shared pointers; a queue at each
// input; strategies as objects. The components themselves are those of the graph, so the arithmetic is the
// same.
//
// It is a good implementation of this kind: ports are looked up once, when they are connected; samples are
// typed and of fixed size.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <cca/component/component.hpp>

namespace bench::classical {

struct any_sample {
  virtual ~any_sample() = default;
  std::int64_t origin = cca::never;
};
template <class Space>
struct sample : any_sample {
  typename Space::vector_type value;
};
using sample_pointer = std::shared_ptr<const any_sample>;

// The samples that wait at an input; `newest` removes all and returns the last.
class input_port {
public:
  virtual ~input_port() = default;
  void deliver(sample_pointer s) { waiting.push_back(std::move(s)); }
  bool fresh() const { return !waiting.empty(); }
  bool wired = false;

protected:
  bool take_newest() {
    if (waiting.empty()) return false;
    held = std::move(waiting.back());
    waiting.clear();
    return true;
  }
  std::deque<sample_pointer> waiting;
  sample_pointer held;
};

template <class Space>
class typed_input : public input_port {
public:
  typed_input() {
    auto zero = std::make_shared<sample<Space>>();
    for (int i = 0; i < Space::size; ++i) zero->value[i] = Space::domain::zero(i, Space::axes::count);
    held = zero;
  }
  bool update() { return take_newest(); }
  const sample<Space>& newest() const { return static_cast<const sample<Space>&>(*held); }
};

class output_port {
public:
  virtual ~output_port() = default;
  void connect(input_port& to) { readers.push_back(&to); }
  void publish(const sample_pointer& s) const {
    for (auto* reader : readers) reader->deliver(s);
  }

private:
  std::vector<input_port*> readers;
};

struct strategy {
  virtual ~strategy() = default;
  virtual bool fires(std::int64_t k, const std::vector<std::unique_ptr<input_port>>& inputs) const = 0;
};
struct every : strategy {
  explicit every(std::int64_t beats) : n(beats) {}
  bool fires(std::int64_t k, const std::vector<std::unique_ptr<input_port>>&) const override {
    return k % n == 0;
  }
  std::int64_t n;
};
struct when_fresh : strategy {
  bool fires(std::int64_t, const std::vector<std::unique_ptr<input_port>>& inputs) const override {
    for (const auto& i : inputs)
      if (i->fresh()) return true;
    return false;
  }
};
// Fires if the first input is fresh.
struct when_first_is_fresh : strategy {
  bool fires(std::int64_t, const std::vector<std::unique_ptr<input_port>>& inputs) const override {
    return inputs.front()->fresh();
  }
};

class node {
public:
  virtual ~node() = default;
  virtual void process(std::int64_t k, std::int64_t period) = 0;
  std::map<std::string, int, std::less<>> input_names, output_names;
  std::vector<std::unique_ptr<input_port>> inputs;
  std::vector<std::unique_ptr<output_port>> outputs;
  std::unique_ptr<strategy> fires;
  std::int64_t last = -1, first_dt = 1;
};

// A component of the graph behind the virtual interface.
template <class Component, auto Function>
class wrapped : public node {
  using facts = cca::detail::function_facts<decltype(Function)>;

public:
  explicit wrapped(Component& c) : component(c) {
    add_inputs(typename facts::parameters{});
    add_outputs(typename facts::results{});
  }
  void process(std::int64_t k, std::int64_t period) override {
    const cca::beat now(k, period, last < 0 ? first_dt : k - last);
    call(now, typename facts::parameters{}, std::make_index_sequence<count(typename facts::parameters{})>{});
    last = k;
  }

private:
  template <class... P>
  static constexpr std::size_t count(cca::detail::list<P...>) {
    return sizeof...(P);
  }

  template <class Port>
  static constexpr bool is_port =
      cca::detail::parameter_facts<Port>::kind == cca::detail::parameter_kind::input;

  template <class... P>
  void add_inputs(cca::detail::list<P...>) {
    const auto one = [&]<class Port>(std::type_identity<Port>) {
      int position = -1;
      if constexpr (is_port<Port>) {
        position = static_cast<int>(inputs.size());
        input_names.emplace(std::string(Port::name), position);
        inputs.push_back(std::make_unique<typed_input<typename Port::space>>());
      }
      positions.push_back(position);
    };
    (one(std::type_identity<P>{}), ...);
  }
  template <class... R>
  void add_outputs(cca::detail::list<R...>) {
    ((output_names.emplace(std::string(R::name), static_cast<int>(outputs.size())),
      outputs.push_back(std::make_unique<output_port>())),
     ...);
  }

  template <class Port>
  Port argument(std::size_t i, const cca::beat& now) {
    if constexpr (is_port<Port>) {
      auto& input =
          static_cast<typed_input<typename Port::space>&>(*inputs[static_cast<std::size_t>(positions[i])]);
      const bool fresh = input.update();
      typename Port::vector_type coordinates;
      for (int c = 0; c < Port::space::size; ++c) coordinates[c] = input.newest().value[c];
      Port port{coordinates, input.newest().origin, fresh};
      if constexpr (requires { port.set_wired(); }) {
        if (input.wired) port.set_wired();
      }
      return port;
    } else {
      return now;
    }
  }

  template <class... P, std::size_t... I>
  void call(const cca::beat& now, cca::detail::list<P...>, std::index_sequence<I...>) {
    if constexpr (std::is_void_v<typename facts::result>) (component.*Function)(argument<P>(I, now)...);
    else publish((component.*Function)(argument<P>(I, now)...), now);
  }

  template <class... R>
  void publish(const std::tuple<R...>& results, const cca::beat& now) {
    std::apply(
        [&](const auto&... one) {
          std::size_t i = 0;
          (publish_one(one, i++, now), ...);
        },
        results);
  }
  template <class R>
  void publish(const R& result, const cca::beat& now) {
    publish_one(result, 0, now);
  }
  template <class R>
  void publish_one(const R& result, std::size_t i, const cca::beat& now) {
    auto s = std::make_shared<sample<typename R::space>>();
    s->value = result.vector();
    s->origin = now.time();
    outputs[i]->publish(s);
  }

  Component& component;
  std::vector<int> positions;
};

class architecture {
public:
  explicit architecture(std::int64_t nanoseconds) : period(nanoseconds) {}

  // Components fire in the order in which they were added.
  template <auto Function, class Component>
  void add(const std::string& name,
           Component& component,
           std::unique_ptr<strategy> when,
           std::int64_t first_dt = 1) {
    auto n = std::make_unique<wrapped<Component, Function>>(component);
    n->fires = std::move(when);
    n->first_dt = first_dt;
    by_name[name] = n.get();
    nodes.push_back(std::move(n));
  }

  void connect(const std::string& from, const std::string& to) {
    auto [writer, output] = find(from);
    auto [reader, input] = find(to);
    auto& in = *reader->inputs[static_cast<std::size_t>(reader->input_names.at(input))];
    writer->outputs[static_cast<std::size_t>(writer->output_names.at(output))]->connect(in);
    in.wired = true;
  }

  void step() {
    for (const auto& n : nodes)
      if (n->fires->fires(k, n->inputs)) n->process(k, period);
    ++k;
  }

private:
  std::pair<node*, std::string> find(const std::string& path) const {
    const auto dot = path.find('.');
    const auto found = by_name.find(path.substr(0, dot));
    if (found == by_name.end()) throw std::runtime_error("no such component: " + path);
    return {found->second, path.substr(dot + 1)};
  }

  std::int64_t period, k = 0;
  std::vector<std::unique_ptr<node>> nodes;
  std::map<std::string, node*> by_name;
};

}  // namespace bench::classical
