// The laws of requests to a learner, stated once and run for every learner and every module: whatever is
// requested in whatever state is answered, and what is answered is true.
//
// A case has
//   student               what learns: a value with `learning`, a cca::training, and `p.settings`
//   fresh()               a std::unique_ptr to a new one
//   fire(s, call, shown)  one firing with a request (as a number), while a demonstration is shown or not;
//                         it returns {learning, region, answer} as published
//   teach(s)              shows a whole demonstration, without a request
//   numbers               what to request: each learning_call, and numbers that are none
//
// `lone_learner` makes one of a case of learner_laws.hpp, `module_student` of one of module_laws.hpp.
// `laws::allocations_of_this_thread()` counts calls of malloc; the test program defines it.
#pragma once

#include <array>
#include <chrono>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <type_traits>

#include <cca/adaptive/training.hpp>

#include "learner_laws.hpp"
#include "module_laws.hpp"

namespace laws {

std::size_t allocations_of_this_thread();

struct told_of_request {
  cca::learning learning;
  cca::trained_region region;
  cca::learning_answer answer;
};
template <class Status>
told_of_request told_of(const Status& s) {
  return {static_cast<cca::learning>(s[0]), static_cast<cca::trained_region>(s[1]),
          static_cast<cca::learning_answer>(s[2])};
}

template <class Case>
class classroom {
  using student = typename Case::student;
  using training = std::remove_cvref_t<decltype(std::declval<student&>().learning)>;
  using rule = typename training::rule;
  static constexpr bool online = cca::OnlineLearner<rule>, batches = cca::BatchLearner<rule>;
  using call = cca::learning_call;
  using answer = cca::learning_answer;
  using state = cca::learning;

public:
  // In every state every number: what the answer is, and what has changed.
  static void every_request() {
    for (const state from : {state::idle, state::collecting, state::online, state::batch, state::trained})
      for (const bool has_examples : {false, true}) {
        auto begin = in_state(from, has_examples);
        if (!begin) continue;
        for (const double number : Case::numbers) {
          auto s = std::make_unique<student>(*begin);
          const auto before = picture(*s);
          const auto asked = s->learning.last_answer();
          const auto told = Case::fire(*s, number, false);
          const std::string where = std::string(cca::to_string(from)) + ", request " + std::to_string(number);
          const answer wanted = number == 0 ? asked : expected(from, has_examples, number);
          CHECK_MESSAGE(told.answer == wanted,
                        where << ": " << cca::to_string(told.answer) << ", not " << cca::to_string(wanted));
          CHECK_MESSAGE(s->learning.state() == after(from, number, wanted), where);
          CHECK_MESSAGE(told.learning == s->learning.state(), where << ": the status says what it does");
          if (number == 0 || wanted != answer::accepted || after(from, number, wanted) == from)
            if (number != double(call::forget))
              CHECK_MESSAGE(picture(*s) == before, where << ": nothing has changed");
        }
      }
  }

  // What was accepted happens.
  static void accepted_is_done() {
    auto s = Case::fresh();
    s->learning.compute_batches();
    const auto untaught = picture(*s);
    if (request(*s, call::learn) == answer::accepted) {
      Case::teach(*s);
      CHECK_MESSAGE(picture(*s) != untaught, "online it learns from what is shown");
      CHECK(request(*s, call::rest) == answer::accepted);
      CHECK(s->learning.state() == state::trained);
      CHECK(request(*s, call::forget) == answer::accepted);
      CHECK_MESSAGE(picture(*s) == untaught, "forgotten");
    } else {
      CHECK_FALSE(online);
    }
    if (request(*s, call::collect) == answer::accepted) {
      Case::teach(*s);
      const auto examples = s->learning.examples();
      REQUIRE_MESSAGE(!examples.empty(), "it collects what is shown");
      CHECK(request(*s, call::batch) == answer::accepted);
      CHECK(s->learning.state() == state::batch);
      CHECK_MESSAGE(learned_of(*s) == text_of({}), "the old value stays while it learns");
      CHECK_MESSAGE(ends_in(*s, state::trained), "the batch ends");
      if constexpr (batches)
        CHECK_MESSAGE(learned_of(*s) == text_of(rule::batch(examples, s->p.settings)),
                      "the result is that of a batch in the program, bit for bit");
      CHECK(request(*s, call::forget) == answer::accepted);
      CHECK_MESSAGE(picture(*s) == untaught, "forgotten, with its examples");
    } else {
      CHECK_FALSE(batches);
    }
  }

  // A batch that was given up leaves nothing, and another one may follow.
  static void given_up() {
    if (!batches) return;
    auto s = in_state(state::collecting, true);
    const auto before = learned_of(*s);
    CHECK(request(*s, call::batch) == answer::accepted);
    CHECK(request(*s, call::rest) == answer::accepted);
    CHECK(s->learning.state() == state::idle);
    for (int k = 0; k < 20; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      (void)Case::fire(*s, 0, false);
    }
    CHECK(s->learning.state() == state::idle);
    CHECK_MESSAGE(learned_of(*s) == before, "nothing was learned");
    // The old one may still be computed: then it is refused.
    auto said = answer::not_now;
    for (int k = 0; said == answer::not_now && k < 10000; ++k) {
      said = request(*s, call::batch);
      if (said == answer::not_now) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK(said == answer::accepted);
    CHECK(ends_in(*s, state::trained));
  }

  // A copy that is taken while a batch is computed learns the same.
  static void copied() {
    if (!batches) return;
    auto s = in_state(state::collecting, true);
    CHECK(request(*s, call::batch) == answer::accepted);
    auto copy = std::make_unique<student>(*s);
    CHECK(copy->learning.state() == state::batch);
    CHECK(ends_in(*s, state::trained));
    s->learning.forget();
    CHECK(ends_in(*copy, state::trained));
    auto later = std::make_unique<student>(*copy);
    CHECK(learned_of(*later) == learned_of(*copy));
    CHECK(learned_of(*copy) != learned_of(*s));
  }

  // Firings with requests neither allocate nor wait.
  static void no_allocation() {
    if (!batches) return;
    auto s = in_state(state::collecting, true);
    const std::size_t before = allocations_of_this_thread();
    (void)Case::fire(*s, double(call::batch), false);
    (void)Case::fire(*s, double(call::rest), false);
    (void)Case::fire(*s, double(call::batch), false);
    bool all = true;
    for (int k = 0; k < 10000 && s->learning.state() == state::batch; ++k) {
      (void)Case::fire(*s, 0, false);
      all = all && allocations_of_this_thread() == before;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    CHECK_MESSAGE(all, "a firing does not allocate");
  }

  // Without a thread for batches a request for one is refused.
  static void nobody_computes() {
    auto s = Case::fresh();
    s->learning.collect();
    Case::teach(*s);
    CHECK(request(*s, call::batch) == answer::impossible);
    CHECK(s->learning.state() == state::collecting);
  }

private:
  static answer request(student& s, call what) { return Case::fire(s, double(what), false).answer; }

  static std::string text_of(const typename rule::learned& known) {
    return cca::detail::learned_text({std::string(rule::model::title()), std::string(rule::name)},
                                     cca::detail::schema_of<typename rule::learned>, &known);
  }
  static std::string learned_of(const student& s) { return text_of(s.learning.get()); }
  static std::string picture(const student& s) {
    return learned_of(s) + std::to_string(s.learning.example_count()) +
           std::string(cca::to_string(s.learning.state()));
  }
  static bool ends_in(student& s, state wanted) {
    for (int k = 0; k < 20000 && s.learning.state() == state::batch; ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      (void)Case::fire(s, 0, false);
    }
    return s.learning.state() == wanted;
  }

  // By the functions for between two beats; null where the learner has no such state.
  static std::unique_ptr<student> in_state(state wanted, bool has_examples) {
    auto s = Case::fresh();
    s->learning.compute_batches();
    if (has_examples) {
      s->learning.collect();
      Case::teach(*s);
      if (wanted != state::collecting) s->learning.rest();
    } else if (wanted == state::collecting) {
      s->learning.collect();
    }
    if (wanted == state::online) {
      if constexpr (online) s->learning.learn();
      else return nullptr;
    }
    if (wanted == state::batch) {
      if constexpr (!batches) return nullptr;
      else if (!has_examples) return nullptr;
      else (void)s->learning.begin_batch(s->p.settings);
    }
    if (wanted == state::trained) s->learning.hand_over({});
    REQUIRE(s->learning.state() == wanted);
    return s;
  }

  static answer expected(state from, bool has_examples, double number) {
    const bool rests = from == state::idle || from == state::trained;
    if (number == double(call::collect))
      return !batches                             ? answer::impossible
             : rests || from == state::collecting ? answer::accepted
                                                  : answer::not_now;
    if (number == double(call::learn))
      return !online                          ? answer::impossible
             : rests || from == state::online ? answer::accepted
                                              : answer::not_now;
    if (number == double(call::rest)) return answer::accepted;
    if (number == double(call::forget)) return rests ? answer::accepted : answer::not_now;
    if (number == double(call::batch))
      return !batches                ? answer::impossible
             : from == state::batch  ? answer::accepted
             : from == state::online ? answer::not_now
             : has_examples          ? answer::accepted
                                     : answer::no_examples;
    return answer::unknown;
  }
  static state after(state from, double number, answer said) {
    if (said != answer::accepted) return from;
    if (number == double(call::collect)) return state::collecting;
    if (number == double(call::learn)) return state::online;
    if (number == double(call::batch)) return state::batch;
    if (number == double(call::forget)) return state::idle;
    if (number == double(call::rest) && from != state::trained) return state::idle;  // nothing was learned
    return from;
  }
};

template <class Case>
void requests() {
  law("every request in every state is answered", classroom<Case>::every_request);
  law("what is accepted is done", classroom<Case>::accepted_is_done);
  law("a batch that is given up leaves nothing", classroom<Case>::given_up);
  law("a copy goes on with the batch", classroom<Case>::copied);
  law("a firing with a request does not allocate", classroom<Case>::no_allocation);
  law("a batch that nobody computes is refused", classroom<Case>::nobody_computes);
}

inline constexpr std::array any_numbers{
    0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 255.0, 256.0, -1.0, 1.5, std::numeric_limits<double>::quiet_NaN()};

// The port "learn", as the loop gives it.
inline cca::optional_in<"learn", cca::learning_request> numbered_request(double call) {
  cca::optional_in<"learn", cca::learning_request> port(cca::learning_request::vector_type(call), 0,
                                                        call != 0);
  port.set_wired();
  return port;
}

// A learner alone, with the port "learn". A case of learner_laws.hpp makes its examples.
template <class Case>
struct lone_learner {
  struct student {
    struct {
      typename Case::learner::settings settings{};
    } p{};
    cca::training<typename Case::learner, 200> learning;
    int shown = 0;
    cca::learning_answer answer{};  // of a useless one
  };
  static constexpr auto numbers = any_numbers;
  static auto fresh() { return std::make_unique<student>(); }
  static told_of_request fire(student& s, double call, bool) {
    s.learning.hear(numbered_request(call), s.p.settings);
    return told_of(s.learning.status(example(s.shown).x, s.p.settings, true));
  }
  static void teach(student& s) {
    for (int i = 0; i < 100; ++i) {
      const auto one = example(s.shown++);
      s.learning.teach(one.x, one.y, s.p.settings);
    }
  }

private:
  static auto example(int i) {
    static const auto all = examples<Case>(300, 7);
    return all[static_cast<std::size_t>(i) % all.size()];
  }
};

// A module of module_laws.hpp, by its case.
template <class Case>
struct module_student {
  using student = typename Case::module;
  static constexpr std::array numbers{0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 255.0};
  static auto fresh() {
    auto m = started_module<student>();
    if constexpr (requires { Case::hasten(*m); }) Case::hasten(*m);  // fewer steps in a batch
    return m;
  }
  static told_of_request fire(student& s, double call, bool what) {
    const auto now = Case::fire(s, 0, what ? shown::demonstration : shown::nothing,
                                static_cast<cca::learning_call>(static_cast<std::uint8_t>(call)));
    return {now.learning, now.region, now.answer};
  }
  static void teach(student& s) {
    s.on_start();
    for (int k = 0; k < Case::lesson; ++k)
      (void)Case::fire(s, k, shown::demonstration, cca::learning_call::nothing);
  }
};

}  // namespace laws
