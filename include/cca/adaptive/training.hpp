// The learning side of a module: its learned value, its examples, and the extended life-cycle of the source
// document's section 4.4.4.
//
//   cca::training<learner, 2000> learning;               in the module
//   learning.teach(x, y, p.settings);                    in process: collects, learns or ignores
//   learning.answer(x), learning.status(x, p.settings)
//
//   auto& m = c.get<"dmp.module">();                     between two beats
//   m.learning.collect();                                ... beats ...
//   auto work = m.learning.begin_batch(m.p.settings);    a value: call work() on any thread
//   m.learning.hand_over(work());                        the whole result, between two beats
//
// An example that is NaN, infinite or beyond 1e12 is ignored in every state. An input that is NaN or infinite
// lies outside of the trained region; its answer is what the model makes of it. There is no fault.
//
// It keeps the newest Capacity examples. States and legal changes stand in a table (learning_transitions);
// other changes are refused. A beat allocates nothing. It is a value: a copy continues independently. Memory:
// Capacity examples. Errors: `cca::refused` for illegal changes and for files (learned_file.hpp).
// Example: tests/runtime/adaptive/kinds.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <cca/component/input_status.hpp>
#include <cca/adaptive/learned_file.hpp>
#include <cca/adaptive/learner.hpp>
#include <cca/adaptive/module_status.hpp>
#include <cca/component/field_types.hpp>
#include <cca/base/file.hpp>

namespace cca {

// The files that a module reads on load and writes on save; an empty name means none.
struct learned_files {
  BOOST_HANA_DEFINE_STRUCT(learned_files, (text<200>, load), (text<200>, save));
};

namespace detail {

enum class learning_change : std::uint8_t { collect, learn, begin_batch, hand_over, rest, forget };

struct learning_transition {
  learning_change what;
  learning from, to;
};

// `rest` leads to trained, or to idle if nothing was learned.
inline constexpr std::array learning_transitions{
    learning_transition{learning_change::collect, learning::idle, learning::collecting},
    learning_transition{learning_change::collect, learning::trained, learning::collecting},
    learning_transition{learning_change::learn, learning::idle, learning::online},
    learning_transition{learning_change::learn, learning::trained, learning::online},
    // A batch from idle uses the examples that were collected before.
    learning_transition{learning_change::begin_batch, learning::idle, learning::batch},
    learning_transition{learning_change::begin_batch, learning::trained, learning::batch},
    learning_transition{learning_change::begin_batch, learning::collecting, learning::batch},
    learning_transition{learning_change::hand_over, learning::batch, learning::trained},
    learning_transition{learning_change::hand_over, learning::idle, learning::trained},
    learning_transition{learning_change::hand_over, learning::trained, learning::trained},
    learning_transition{learning_change::rest, learning::collecting, learning::trained},
    learning_transition{learning_change::rest, learning::online, learning::trained},
    // Gives up a batch, without its result.
    learning_transition{learning_change::rest, learning::batch, learning::trained},
    learning_transition{learning_change::forget, learning::idle, learning::idle},
    learning_transition{learning_change::forget, learning::trained, learning::idle},
};

constexpr bool is_legal(learning_change what, learning from) {
  for (const auto& one : learning_transitions)
    if (one.what == what && one.from == from) return true;
  return false;
}

}  // namespace detail

// A batch that has begun, with its own copy of the examples.
template <BatchLearner Rule>
struct learning_batch {
  std::vector<example<typename Rule::model>> examples;
  typename Rule::settings settings;
  typename Rule::learned operator()() const { return Rule::batch(examples, settings); }
};

template <Learner Rule, int Capacity = 2000>
class training {
public:
  using model = typename Rule::model;
  using input = typename model::input;
  using output = typename model::output;
  using settings = typename Rule::settings;
  using learned = typename Rule::learned;

  // For use in a beat.
  output answer(const input& x) const { return model::answer(known.function, x); }
  const learned& get() const { return known; }
  learning state() const { return now; }
  // always_inline, here and below: calls in the beat otherwise (docs/compilers.md).
  [[gnu::always_inline]] bool in_trained_region(const input& x, const settings& s) const {
    return has_learned && detail::all_finite(x) && Rule::inside(known, x, s);
  }
  [[gnu::always_inline]] trained_region region(const input& x, const settings& s) const {
    return in_trained_region(x, s) ? trained_region::inside : trained_region::outside;
  }
  [[gnu::always_inline]] auto status(const input& x, const settings& s) const {
    return status_of(now, region(x, s));
  }

  // Ignores examples that are not finite or beyond `largest_input`: their squares would not be.
  void teach(const input& x, const output& y, const settings& s) {
    if (now != learning::collecting && now != learning::online) return;
    if (!(x.array().abs() <= largest_input).all() || !(y.array().abs() <= largest_input).all()) return;
    if (now == learning::collecting) {
      kept[written++ % kept.size()] = {x, y};
    } else if constexpr (OnlineLearner<Rule>) {
      Rule::step(known, x, y, s);
      has_learned = true;
    }
  }

  // A request of another component. A request that is illegal in this state is ignored.
  void obey(learning_call call) {
    using detail::learning_change;
    if (call == learning_call::collect) (void)changed(learning_change::collect);
    else if (call == learning_call::learn) (void)changed(learning_change::learn);
    else if (call == learning_call::rest) (void)changed(learning_change::rest);
    else if (call == learning_call::forget && changed(learning_change::forget)) clear();
  }

  // For use between two beats.
  void collect() { change(detail::learning_change::collect, "collect()"); }
  void learn()
    requires OnlineLearner<Rule>
  {
    change(detail::learning_change::learn, "learn()");
  }
  void rest() { change(detail::learning_change::rest, "rest()"); }
  void forget() {
    change(detail::learning_change::forget, "forget()");
    clear();
  }
  std::size_t example_count() const { return written < kept.size() ? written : kept.size(); }
  std::vector<example<model>> examples() const {
    std::vector<example<model>> all;
    for (std::size_t i = written - example_count(); i < written; ++i) all.push_back(kept[i % kept.size()]);
    return all;
  }

  learning_batch<Rule> begin_batch(const settings& s)
    requires BatchLearner<Rule>
  {
    if (example_count() == 0)
      throw refused(
          "cca::training: begin_batch() is refused: no examples yet; call collect() and run some beats "
          "first");
    change(detail::learning_change::begin_batch, "begin_batch()");
    return {examples(), s};
  }
  void hand_over(const learned& whole) {
    change(detail::learning_change::hand_over, "hand_over()");
    known = whole;
    has_learned = true;
  }

  // `constants` are the values that the numbers depend on. If a file is refused, nothing changes.
  void load(const std::string& file, const std::vector<learned_header::constant>& constants = {}) {
    if (!detail::is_legal(detail::learning_change::hand_over, now))
      change(detail::learning_change::hand_over, "load()");
    learned copy = known;
    detail::read_learned(detail::read_file(file), file, header(constants), detail::schema_of<learned>, &copy);
    hand_over(copy);
  }
  void save(const std::string& file, const std::vector<learned_header::constant>& constants = {}) const {
    if (!has_learned) throw refused(file + ": not written: the module has learned nothing");
    std::vector<detail::complaint> wrong;
    detail::check(detail::schema_of<learned>, &known, "", wrong);
    if (!wrong.empty())
      throw refused(file + ": not written: " + wrong.front().path + ": " + wrong.front().what);
    detail::write_file(file, detail::learned_text(header(constants), detail::schema_of<learned>, &known));
  }

private:
  static learned_header header(const std::vector<learned_header::constant>& constants) {
    return {std::string(model::title()), std::string(Rule::name), constants};
  }
  bool changed(detail::learning_change what) {
    for (const auto& one : detail::learning_transitions)
      if (one.what == what && one.from == now) {
        now = what == detail::learning_change::rest && !has_learned ? learning::idle : one.to;
        return true;
      }
    return false;
  }
  void change(detail::learning_change what, const char* call) {
    if (changed(what)) return;
    throw refused(
        std::string("cca::training: ") + call + " is refused while it is `" + std::string(to_string(now)) +
        "`: " +
        (now == learning::idle || now == learning::trained ? "nothing is running" : "call rest() first"));
  }
  void clear() {
    known = {};
    written = 0;
    has_learned = false;
  }

  learned known{};
  std::array<example<model>, static_cast<std::size_t>(Capacity)> kept;
  std::size_t written = 0;
  learning now = learning::idle;
  bool has_learned = false;
};

}  // namespace cca
