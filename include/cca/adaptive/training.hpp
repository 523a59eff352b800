// The learning side of a module: its learned value, its examples, and the extended life-cycle of the source
// document's section 4.4.4.
//
//   cca::training<learner, 2000> learning;               in the module
//   learning.teach(x, y, p.settings);                    in process: collects, learns or ignores
//   learning.answer(x), learning.status(x, p.settings)
//   if (call) learning.hear(call, p.settings);           a request at the port "learn"
//
//   auto& m = c.get<"dmp.module">();                     between two beats
//   m.learning.collect();                                ... beats ...
//   auto work = m.learning.begin_batch(m.p.settings);    a value: call work() on any thread
//   m.learning.hand_over(work());                        the whole result, between two beats
//
// An example that is NaN, infinite or beyond 1e12 is ignored in every state. An input that is NaN or infinite
// lies outside of the trained region; its answer is what the model makes of it. There is no fault.
//
// It keeps the newest Capacity examples, and counts the others: lost_examples(). For models of sequences
// these are whole demonstrations: the rest of one whose beginning is lost would count as a demonstration of
// its own, so it is left out, unless it is all that there is. States and legal changes stand in a table
// (learning/changes.hpp); other changes are refused. A beat allocates nothing. It is a value: a copy
// continues independently. Memory: Capacity examples. Errors: `cca::refused` for illegal changes and for
// files (learned_file.hpp); learner.request for a request that the compiler knows.
//
// Requests (module_status.hpp) are events: a component publishes one when it wants something. Each is
// answered in the status. A `batch` that is requested is computed by a thread beside the loop
// (batch_thread.hpp); the loop goes on with the old value, and takes the whole new one in the first firing
// after it is done. Its value does not depend on the thread, but that firing does. `load()` starts the thread
// where the port is wired. Example: tests/runtime/adaptive/kinds.cpp, tests/runtime/adaptive/requests.cpp.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <cca/base/math/roots.hpp>
#include <cca/component/input_status.hpp>
#include <cca/adaptive/learning/batch_thread.hpp>
#include <cca/adaptive/learning/changes.hpp>
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

// The call that a number is; beyond the last one: none.
inline constexpr auto no_learning_call = static_cast<learning_call>(255);
inline learning_call learning_call_of(double number) {
  constexpr double last = status_of(learning_call::batch);
  return number >= 0 && number <= last && math::trunc(number) == number
             ? static_cast<learning_call>(static_cast<std::uint8_t>(number))
             : no_learning_call;
}

template <Learner Rule>
struct batches_of {
  struct type {};
};
template <BatchLearner Rule>
struct batches_of<Rule> {
  using type = batch_thread<Rule>;
};

}  // namespace detail

// A batch that has begun, with its own copy of the examples.
template <Learner Rule>
struct learning_batch {
  std::vector<example<typename Rule::model>> examples;
  typename Rule::settings settings;
  typename Rule::learned operator()() const { return Rule::batch(examples, settings); }
};

template <Learner Rule, int Capacity = 2000>
class training {
public:
  using rule = Rule;
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
    return status_of(now, region(x, s), answer_to_last);
  }
  // `is_asked`: the port "learn" is wired. Otherwise there are no requests, and this costs nothing.
  [[gnu::always_inline]] auto status(const input& x, const settings& s, bool is_asked) const {
    return status_of(now, region(x, s), is_asked ? answer_to_last : learning_answer::none);
  }

  // Ignores examples that are not finite or beyond `largest_input`: their squares would not be.
  void teach(const input& x, const output& y, const settings& s) {
    if (now != learning::collecting && now != learning::online) return;
    if (!(x.array().abs() <= largest_input).all() || !(y.array().abs() <= largest_input).all()) return;
    if (now == learning::collecting) {
      kept[written % kept.size()] = {x, y};
      if constexpr (SequenceModel<model>) kept[written % kept.size()].begins = std::exchange(is_anew, false);
      ++written;
    } else if constexpr (OnlineLearner<Rule>) {
      Rule::step(known, x, y, s);
      has_learned = true;
    }
  }
  // The next example is the first of another demonstration: for models of sequences.
  [[gnu::always_inline]] void begin_demonstration() {
    if constexpr (SequenceModel<model>) is_anew = true;
  }

  // What this learner can do on request, in a suitable state.
  static constexpr bool can(learning_call call) {
    switch (call) {
      case learning_call::collect:
      case learning_call::batch:
        return BatchLearner<Rule>;
      case learning_call::learn:
        return OnlineLearner<Rule>;
      default:
        return true;
    }
  }
  // Why a constant request is refused by the compiler (learner.request); empty: it is not.
  static constexpr std::string_view refusal(double call) {
    constexpr auto number = [](learning_call one) { return static_cast<double>(one); };
    if (call == number(learning_call::learn) && !can(learning_call::learn))
      return "`learn` needs a learner that learns online, and this one learns in batches only: request "
             "`collect`, and then `batch`";
    if ((call == number(learning_call::collect) || call == number(learning_call::batch)) &&
        !can(learning_call::batch))
      return "`collect` and `batch` need a learner that learns in batches, and this one learns online only: "
             "request `learn`";
    return {};
  }

  // A firing of a component whose port "learn" is wired: takes the result of a batch, and answers a request.
  template <class Port>
  void hear(const Port& call, const settings& s) {
    take_batch();
    if (call.fresh()) (void)obey(detail::learning_call_of(call.vector()[0]), s);
  }
  // A request. What is refused changes nothing.
  learning_answer obey(learning_call call, const settings& s) {
    if (call != learning_call::nothing) answer_to_last = answer_to(call, s);
    return answer_to_last;
  }
  // The same with the settings as they are by default.
  learning_answer obey(learning_call call) { return obey(call, settings{}); }
  learning_answer last_answer() const { return answer_to_last; }

  // From now on a batch may be requested: a thread computes it. Not in a beat; again, it does nothing.
  void compute_batches() {
    if constexpr (BatchLearner<Rule>) beside.start(kept.size());
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
  std::size_t example_count() const { return written - first_example(); }
  // Examples since the last forget() that no batch learns from any more: there were more than Capacity.
  std::size_t lost_examples() const { return first_example(); }
  static constexpr int capacity = Capacity;
  std::vector<example<model>> examples() const {
    std::vector<example<model>> all;
    for (std::size_t i = first_example(); i < written; ++i) all.push_back(kept[i % kept.size()]);
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
  learning_answer answer_to(learning_call call, const settings& s) {
    using enum learning_answer;
    using detail::learning_change;
    if (call > learning_call::batch) return unknown;
    if (!can(call)) return impossible;
    switch (call) {
      case learning_call::collect:
        return now == learning::collecting || changed(learning_change::collect) ? accepted : not_now;
      case learning_call::learn:
        return now == learning::online || changed(learning_change::learn) ? accepted : not_now;
      case learning_call::rest:
        return changed(learning_change::rest) || is_at_rest() ? accepted : not_now;
      case learning_call::forget:
        if (!changed(learning_change::forget)) return not_now;
        clear();
        return accepted;
      default:
        return now == learning::batch ? accepted : start_batch(s);
    }
  }
  learning_answer start_batch([[maybe_unused]] const settings& s) {
    using enum learning_answer;
    if constexpr (BatchLearner<Rule>) {
      if (!beside.is_there()) return impossible;
      if (!detail::is_legal(detail::learning_change::begin_batch, now)) return not_now;
      if (example_count() == 0) return no_examples;
      if (!beside.ask(kept, first_example(), written, s)) return not_now;
      (void)changed(detail::learning_change::begin_batch);
      return accepted;
    } else {
      return impossible;
    }
  }
  void take_batch() {
    if constexpr (BatchLearner<Rule>) {
      if (now != learning::batch) return;
      const auto end = beside.take(known);
      if (end == detail::batch_end::not_yet) return;
      if (end == detail::batch_end::done) has_learned = true;
      else answer_to_last = learning_answer::failed;
      now = has_learned ? learning::trained : learning::idle;
    }
  }
  // The oldest example that a batch learns from.
  std::size_t first_example() const {
    if (written <= kept.size()) return 0;
    const std::size_t oldest = written - kept.size();
    if constexpr (SequenceModel<model>)
      for (std::size_t i = oldest; i < written; ++i)
        if (kept[i % kept.size()].begins) return i;
    return oldest;
  }
  bool is_at_rest() const { return now == learning::idle || now == learning::trained; }

  bool changed(detail::learning_change what) {
    for (const auto& one : detail::learning_transitions)
      if (one.what == what && one.from == now) {
        if constexpr (BatchLearner<Rule>)
          if (now == learning::batch) beside.give_up();
        now = what == detail::learning_change::rest && !has_learned ? learning::idle : one.to;
        if (now == learning::collecting) begin_demonstration();
        return true;
      }
    return false;
  }
  void change(detail::learning_change what, const char* call) {
    if (changed(what)) return;
    throw refused(std::string("cca::training: ") + call + " is refused while it is `" +
                  std::string(to_string(now)) +
                  "`: " + (is_at_rest() ? "nothing is running" : "call rest() first"));
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
  bool is_anew = true;  // the next example begins a demonstration
  learning_answer answer_to_last = learning_answer::none;
  [[no_unique_address]] typename detail::batches_of<Rule>::type beside;
};

}  // namespace cca
