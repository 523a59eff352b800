// The functions of tests of inputs: input_tests.hpp; and what a door's clients ask of them: hub.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/base/response/frequency_response.hpp>
#include <cca/base/response/step_response.hpp>
#include <cca/door/network/changes_functions.hpp>
#include <cca/door/network/hub.hpp>
#include <cca/door/network/input_tests.hpp>
#include <cca/door/network/messages_functions.hpp>
#include <cca/door/network/rights_functions.hpp>
#include <cca/door/network/services_functions.hpp>

namespace cca::detail::door_network {

// ---- what is asked for ----

inline std::string input_test::read(const json& given,
                                    const std::vector<door_test_input>& of,
                                    const shown_channels& channels) {
  settings to;
  const std::string name = text_member(given, "input");
  const auto found = std::find_if(of.begin(), of.end(), [&](const auto& one) { return one.input == name; });
  if (found == of.end()) {
    std::string names;
    for (const auto& one : of) names += (names.empty() ? "" : ", ") + one.input;
    return "input = " + text_of(json(name)) + ": expected an input that a cca::test_input declares: " + names;
  }
  to.of = *found;
  std::string why;
  const auto number = [&](const char* member_name, double& value) {
    const json* one = member(given, member_name);
    if (!one || !why.empty()) return;
    if (!one->is_number() || !std::isfinite(one->get<double>()))
      why = std::string(member_name) + " = " + text_of(*one) + ": expected a number";
    else value = one->get<double>();
  };
  // By its name or its number. Where a port has none, it is that of the input; where that has none, the
  // first.
  const auto axis_of = [&](const char* member_name, const std::string& of_what,
                           const std::vector<std::string>& axes) {
    const json* const one = member(given, member_name);
    const json is = one ? *one : json(to.axis);
    const auto named =
        is.is_string() ? std::find(axes.begin(), axes.end(), is.get<std::string>()) : axes.end();
    if (named != axes.end()) return static_cast<std::size_t>(named - axes.begin());
    const double index = is.is_number() ? is.get<double>() : -1;
    if (index >= 0 && index < static_cast<double>(axes.size()) && index == std::floor(index))
      return static_cast<std::size_t>(index);
    std::string names;
    for (const std::string& label : axes) names += (names.empty() ? "" : ", ") + label;
    why = std::string(member_name) + " = " + text_of(is) + ": expected an axis" + of_what + ": " + names +
          ", or its number, a whole number from 0 to " + std::to_string(axes.size() - 1);
    return std::size_t{0};
  };
  const auto port_of = [&](const char* path, const char* axis, port& into) {
    const std::string is = text_member(given, path);
    const auto channel = channels.channel_of(topic_of(is));
    const auto axes = channel ? channels.axes_of(*channel) : std::vector<std::string>();
    if (!why.empty()) return;
    if (is.empty() || axes.empty())
      why = std::string(path) + " = " + text_of(json(is)) + ": expected the path of an output" +
            channels.near_output(is);
    else into.channel = *channel, into.axis = axis_of(axis, " of " + is, axes);
  };
  to.signal = text_member(given, "signal");
  number("amplitude", to.amplitude), number("frequency", to.frequency), number("to", to.to);
  number("duration", to.duration);
  if (!why.empty()) return why;
  const std::size_t axis = axis_of("axis", "", to.of.axes);
  if (!why.empty()) return why;
  to.axis = static_cast<std::int64_t>(axis);
  if (to.signal != "step" && to.signal != "sine" && to.signal != "chirp" && to.signal != "linear_chirp")
    return "signal = " + text_of(json(to.signal)) + ": expected step, sine, chirp or linear_chirp";
  if (to.amplitude == 0)
    return "amplitude: expected one that is not 0, at most " + number_text(to.of.most) +
           (to.of.unit.empty() ? "" : " " + to.of.unit);
  port_of("output", "output_axis", to.output);
  if (given.contains("from")) port_of("from", "from_axis", to.from.emplace());
  const auto excitation = channels.channel_of(topic_of(to.of.node + ".excitation"));
  if (why.empty() && !excitation) why = "the run has not begun";
  if (!why.empty()) return why;
  to.excitation.channel = *excitation, to.excitation.axis = axis;
  asked = std::move(to);
  return {};
}

inline std::string input_test::fill(const std::vector<door_parameter>& known, door_request& request) const {
  request.values.clear();
  const auto parameter = [&](const std::string& name) {
    return std::find_if(known.begin(), known.end(),
                        [&](const auto& one) { return one.path == node() + "." + name; });
  };
  const auto run = parameter("run");
  if (run == known.end()) return "the run has not begun";
  // One after the other, and checked each time: so the signal comes after its frequencies, and what it has
  // none of stays as it is.
  std::vector<std::pair<const char*, json>> all{
      {"axis", asked.axis}, {"amplitude", asked.amplitude}, {"duration", asked.duration}};
  if (asked.signal != "step") all.emplace_back("frequency", asked.frequency);
  if (asked.signal.ends_with("chirp")) all.emplace_back("to", asked.to);
  all.emplace_back("signal", asked.signal);
  all.emplace_back("run", run->value.integer + 1);
  for (const auto& [name, value] : all) {
    const auto of = parameter(name);
    std::string wrong;
    const auto one = of == known.end() ? std::nullopt : value_for(*of, &value, wrong);
    if (!one) return wrong.empty() ? "there is no parameter " + text_of(json(node() + "." + name)) : wrong;
    request.values.emplace_back(of->path, *one);
  }
  return {};
}

// ---- its record ----

inline void input_test::listen(shown_channels& channels, bool does) const {
  channels.listen(asked.excitation.channel, does);
  channels.listen(asked.output.channel, does);
  if (asked.from) channels.listen(asked.from->channel, does);
}
inline void input_test::begin(std::uint64_t with_id, std::int64_t period_of_beat, shown_channels& channels) {
  own_id = with_id, began = none, lost_messages = 0, period = period_of_beat, is_cut = false, cut_by.clear();
  is_listening = true;
  listen(channels, true);
}
inline void input_test::end(shown_channels& channels) {
  if (std::exchange(is_listening, false)) listen(channels, false);
  own_id = 0;
}

// A sample of an output: the head of CDR, the beat, the time of origin, a number for each axis.
inline void input_test::take(port& into, std::uint16_t channel, std::string_view data) {
  if (into.channel != channel || into.samples.size() >= most_samples) return;
  const std::size_t at = 4 + 16 + 8 * into.axis;
  std::int64_t beat = 0;
  double value = 0;
  if (data.size() < at + sizeof value) return;
  std::memcpy(&beat, data.data() + 4, sizeof beat);
  std::memcpy(&value, data.data() + at, sizeof value);
  into.samples.emplace_back(beat, value);
}
inline void input_test::sample(std::uint16_t channel, std::string_view data) {
  if (!is_listening) return;
  take(asked.excitation, channel, data);
  take(asked.output, channel, data);
  if (asked.from) take(*asked.from, channel, data);
}

// ---- the answer ----

inline std::optional<json> input_test::response(std::uint64_t now, std::string& why) const {
  const auto& u = asked.excitation.samples;
  if (period <= 0 || (began == none && !is_running(now)))
    return why = "no test has run: call /cca/test", std::nullopt;
  if (is_running(now)) return why = "the test of " + input() + " runs", std::nullopt;
  if (!is_cut && now < began + nanoseconds(asked.duration + rest))
    return why = "the test of " + input() + " runs: its output comes to rest", std::nullopt;
  if (!cut_by.empty()) return why = "the test of " + input() + " was ended by " + cut_by, std::nullopt;
  if (lost_messages > 0)
    return why = std::to_string(lost_messages) +
                 " samples of the test were lost: run slower, or record it to a file",
           std::nullopt;
  if (u.size() < 2 || asked.output.samples.empty())
    return why = "the test has too few samples: was the run paused, or stopped?", std::nullopt;
  // The samples of the excitation give the times; between two of its own an output keeps the last.
  std::int64_t stride = std::numeric_limits<std::int64_t>::max();
  for (std::size_t i = 1; i < u.size(); ++i) stride = std::min(stride, u[i].first - u[i - 1].first);
  stride = std::max<std::int64_t>(stride, 1);
  const double rate = 1e9 / static_cast<double>(period * stride);
  const auto missing = asked.duration - static_cast<double>(u.back().first - u[0].first + stride) * 1e-9 *
                                            static_cast<double>(period);
  if (!is_cut && u.size() < most_samples && missing > 2 / rate)
    return why = "the signal ended " + number_text(missing) +
                 " s before its time: was the run stopped, or begun anew?",
           std::nullopt;
  const std::int64_t last = std::min(asked.output.samples.back().first,
                                     u.back().first + static_cast<std::int64_t>(1e9 * rest) / period);
  const auto record = [&](const port& of, double before, bool ends) {
    std::vector<double> values;
    std::size_t at = 0;
    double held = before;
    for (std::int64_t beat = u[0].first; beat <= last && values.size() < most_samples; beat += stride) {
      while (at < of.samples.size() && of.samples[at].first <= beat) held = of.samples[at++].second;
      values.push_back(ends && beat > u.back().first ? 0 : held);
    }
    return values;
  };
  const auto in = record(asked.excitation, 0, true);
  const auto first_of = [](const port& of) { return of.samples.empty() ? 0 : of.samples[0].second; };
  auto out = record(asked.output, first_of(asked.output), false);
  const json head{
      {"input", input()}, {"signal", asked.signal}, {"amplitude", asked.amplitude}, {"rate", rate}};
  json all = head;
  try {
    if (asked.signal == "step") {
      const auto steps =
          static_cast<std::size_t>(u.back().first - u[0].first) / static_cast<std::size_t>(stride) + 1;
      out.resize(std::min(out.size(), steps));
      const step_figures figures = step_response(out, rate, asked.amplitude);
      all["gain"] = json_of(figures.gain), all["rise_time"] = json_of(figures.rise_time);
      all["overshoot"] = json_of(figures.overshoot), all["settling_time"] = json_of(figures.settling_time);
      json times = json::array(), values = json::array();
      const std::size_t every = out.size() / 400 + 1;
      for (std::size_t i = 0; i < out.size(); i += every)
        times.push_back(static_cast<double>(i) / rate), values.push_back(json_of(out[i]));
      all["time"] = std::move(times), all["output"] = std::move(values);
      return all;
    }
    const auto of_port = [&](const std::vector<double>& values) {
      if (asked.signal == "sine") {
        const auto length = static_cast<std::size_t>(std::llround(asked.duration * rate));
        const std::size_t used = std::min(values.size(), length);
        return std::vector{
            sine_response(std::span(in).first(used), std::span(values).first(used), rate, asked.frequency)};
      }
      const double low = std::min(asked.frequency, asked.to), high = std::max(asked.frequency, asked.to);
      return chirp_response(in, values, rate, frequencies(low, std::max(high, low * 1.0001), 60));
    };
    auto points = of_port(out);
    if (asked.from) points = ratio_of(points, of_port(record(*asked.from, first_of(*asked.from), false)));
    for (const char* name : {"frequency", "gain", "phase", "coherence"}) all[name] = json::array();
    for (const response_point& one : points) {
      all["frequency"].push_back(json_of(one.frequency)), all["gain"].push_back(json_of(one.gain));
      all["phase"].push_back(json_of(one.phase)), all["coherence"].push_back(json_of(one.coherence));
    }
    return all;
  } catch (const refused& e) { return why = e.what(), std::nullopt; }
}

// ---- the services ----

inline void hub::begin_test(door_client& c, const service_call& one, const json& given, time_point now) {
  const auto refuse = [&](const std::string& why) {
    log(c.name, "refused: /cca/test: " + why, false);
    answer(c.id, one, {door_outcome::how::refused, "/cca/test: " + why});
  };
  if (requests.is_full()) return refuse("too many requests wait for the controller: try again");
  if (tested.is_running(channels.latest))
    return refuse("a test of " + tested.input() + " runs: wait for its end, or call /cca/end_test");
  input_test next;
  if (const std::string why = unknown_argument(services[one.service - 1], given); !why.empty())
    return refuse(why);
  if (const std::string why = next.read(given, controls.description().tests, channels); !why.empty())
    return refuse(why);
  tested.end(channels);
  replaced = std::exchange(tested, next);
  tested.begin(++last_id, controls.status().period, channels);
  door_task task{.client = c.id, .name = c.name, .what = "/cca/test " + next.input(), .may_set = true};
  task.request.about = door_request::what::set;
  task.prepare = [next](const values& all, door_request& request) { return next.fill(all, request); };
  task.test = next.node();
  task.answer = [this, client = c.id, id = tested.id(), one](const door_outcome& outcome) {
    if (id == tested.id()) {  // else it was cut, and another has begun
      if (outcome.is == door_outcome::how::done) {
        tested.begun(channels.latest);
      } else {
        tested.end(channels);
        tested = std::move(replaced);  // its record is still the newest
      }
      replaced = {};
    }
    answer(client, one, {outcome.is, outcome.why.empty() ? "" : "/cca/test: " + outcome.why});
  };
  requests.add(std::move(task), now);
  requests.tick(now);
}

// As a command that is held: it ends with the right to command.
inline void hub::cut_test(time_point now, const std::string& by) {
  requests.refuse_tests("it was ended before a beat began it");
  for (const std::string& node : std::exchange(driven, {})) switch_test_off(node, now);
  if (!tested.is_running(channels.latest)) return;
  tested.cut(by);
  switch_test_off(tested.node(), now);
}
inline void hub::switch_test_off(const std::string& node, time_point now) {
  const auto& all = controls.description().tests;
  const auto of = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.node == node; });
  door_task task{
      .name = "door", .what = "ends the test of " + (of == all.end() ? node : of->input), .may_set = true};
  task.request.about = door_request::what::set;
  task.request.values = {{node + ".signal", door_value{.what = door_value::kind::text, .text = "off"}}};
  task.test = node;
  requests.add_first(std::move(task), now);
}

// Their nodes, where a change of parameters or a file does it without /cca/test: they end in the same way.
inline std::vector<std::string> hub::tests_begun(const values& before, const values& after) {
  std::vector<std::string> begun;
  for (const auto& one : controls.description().tests) {
    const door_parameter* signal = parameter_of(after, one.node + ".signal");
    if (!signal || signal->value.text == "off") {
      driven.erase(one.node);
    } else if (std::any_of(after.begin(), after.end(), [&](const door_parameter& now) {
                 const door_parameter* was = parameter_of(before, now.path);
                 return now.path.starts_with(one.node + ".") && !(was && was->value == now.value);
               })) {
      begun.push_back(one.node);
    }
  }
  return begun;
}

inline void hub::end_test(door_client& c, const service_call& one, time_point now) {
  const bool runs = tested.is_running(channels.latest) || !driven.empty();
  if (runs) log(c.name, "/cca/end_test", true);
  cut_test(now);
  requests.tick(now);
  answer(c.id, one,
         {runs ? door_outcome::how::done : door_outcome::how::refused,
          runs ? "" : "/cca/end_test: no test runs"});
}

inline void hub::tell_response(door_client& c, const service_call& one) {
  std::string why;
  const auto response = tested.response(channels.latest, why);
  if (!response) return answer(c.id, one, {door_outcome::how::refused, "/cca/response: " + why});
  const json all{{"success", true}, {"message", ""}, {"response", *response}};
  if (!c.out.answer(frame_kind::binary, bytes_of_answer(one.service, one.call, written(all))))
    c.close(unwelcome, "this client does not read its answers");
}

}  // namespace cca::detail::door_network
