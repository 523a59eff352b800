// What a door's clients change: parameters, and everything that is a service. hub.hpp
#pragma once

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <cca/door/network/hub.hpp>
#include <cca/door/network/messages_functions.hpp>
#include <cca/door/network/rights_functions.hpp>

namespace cca::detail::door_network {

inline const door_parameter* parameter_of(const std::vector<door_parameter>& all, const std::string& path) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.path == path; });
  return found == all.end() ? nullptr : &*found;
}

inline void hub::set_parameters(door_client& c, const json& m, time_point now) {
  const json* given = member(m, "parameters");
  const json id = member(m, "id") ? *member(m, "id") : json();
  std::vector<std::pair<std::string, json>> wanted;
  bool is_list = given && given->is_array() && !given->empty();
  for (std::size_t i = 0; is_list && i < given->size(); ++i) {
    const json& one = (*given)[i];
    is_list = one.is_object() && !text_member(one, "name").empty();
    if (is_list)
      wanted.emplace_back(text_member(one, "name"), member(one, "value") ? *member(one, "value") : json());
  }
  // The values as they are go back with a refusal: the form of a viewer shows them again.
  const auto refuse = [this, client = c.id, wanted, id](const std::string& why) {
    door_client* to = client_of(client);
    if (!to) return;
    to->say(status_message(2, "setParameters: " + why));
    const auto is_wanted = [&](const std::string& path) {
      return std::any_of(wanted.begin(), wanted.end(), [&](const auto& one) { return one.first == path; });
    };
    if (const auto all = controls.parameters()) to->say(parameter_values(*all, is_wanted, &id));
  };
  std::string why = why_not(c, true);
  if (why.empty() && !is_list) why = "expected a list `parameters` of objects with name and value";
  std::set<std::string> names;
  for (const auto& one : wanted)
    if (why.empty() && !names.insert(one.first).second) why = text_of(one.first) + " is set twice";
  if (why.empty() && requests.is_full()) why = "too many requests wait for the controller: try again";
  if (!why.empty()) {
    log(c.name, "refused: set: " + why, false);
    return refuse(why);
  }
  door_task task{.client = c.id, .name = c.name, .what = "set", .may_set = true};
  task.request.about = door_request::what::set;
  task.prepare = [wanted](const values& all, door_request& request) {
    request.values.clear();
    for (const auto& [path, value] : wanted) {
      const door_parameter* of = parameter_of(all, path);
      if (!of) return "there is no parameter " + text_of(path);
      std::string wrong;
      const auto one = value_for(*of, &value, wrong);
      if (!one) return wrong;
      request.values.emplace_back(path, *one);
    }
    return std::string();
  };
  task.answer = [refuse, wanted, id, client = c.id, this](const door_outcome& outcome) {
    if (outcome.is == door_outcome::how::refused) return refuse(outcome.why);
    door_client* to = client_of(client);
    if (to && id.is_string())
      to->say(parameter_values(
          known,
          [&](const std::string& path) {
            return std::any_of(wanted.begin(), wanted.end(),
                               [&](const auto& one) { return one.first == path; });
          },
          &id));
  };
  requests.add(std::move(task), now);
  requests.tick(now);
}

inline void hub::answer(std::uint64_t client, const service_call& of, const door_outcome& outcome) {
  door_client* c = client_of(client);
  if (!c) return;
  const bool done = outcome.is == door_outcome::how::done;
  if (!c->out.answer(frame_kind::binary, answer_of_call(of.service, of.call, done, outcome.why)))
    c->close(unwelcome, "this client does not read its answers");
}

inline void hub::call(door_client& c, const service_call& one, time_point now) {
  const auto fail = [&](const std::string& why) {
    c.say(written(
        {{"op", "serviceCallFailure"}, {"serviceId", one.service}, {"callId", one.call}, {"message", why}}));
  };
  if (one.service == 0 || one.service > services.size())
    return fail("there is no service " + std::to_string(one.service));
  if (one.encoding != "json") return fail("the services of this door speak json");
  const auto given = read_json(one.payload.empty() ? "{}" : one.payload, limits.depth);
  if (!given) return fail("expected an object of JSON, at most " + std::to_string(limits.depth) + " deep");

  const door_service& of = services[one.service - 1];
  using does = door_service::does;
  const bool about_rights = of.what == does::take_command || of.what == does::give_command;
  const bool is_stop = of.what == does::request && of.about == door_request::what::end_run;
  std::string why = why_not(c, !about_rights && !is_stop && of.what != does::response);
  if (why.empty() && of.what == does::take_command) why = take_command(c);
  else if (why.empty() && of.what == does::give_command) {
    if (commander == &c) give_command(c, now);
    else why = "this client does not command";
  }
  if (why.empty() && of.what == does::test) return begin_test(c, one, *given, now);
  if (why.empty() && of.what == does::end_test) return end_test(c, one, now);
  if (why.empty() && of.what == does::response) return tell_response(c, one);
  if (why.empty() && !about_rights)
    return of.what == does::undo ? undo(c, one, now) : request(c, one, of, *given, now);
  if (!why.empty()) log(c.name, "refused: " + of.name + ": " + why, false);
  answer(c.id, one, {why.empty() ? door_outcome::how::done : door_outcome::how::refused, why});
}

inline void hub::request(
    door_client& c, const service_call& one, const door_service& of, const json& given, time_point now) {
  std::string why;
  const auto wanted = request_of(of, given, why);
  const bool is_stop = of.about == door_request::what::end_run;
  if (wanted && !is_stop && requests.is_full()) why = "too many requests wait for the controller: try again";
  if (!wanted || !why.empty()) {
    log(c.name, "refused: " + why, false);
    return answer(c.id, one, {door_outcome::how::refused, why});
  }
  door_task task{.client = c.id, .name = c.name, .what = text_of(*wanted, of.name), .request = *wanted};
  if (is_stop) task.request.text = c.name + " has ended the run through the door";
  task.may_set = of.about == door_request::what::load;
  task.is_held = of.is_held;
  if (of.about == door_request::what::speed) task.speed = controls.status().speed;
  task.answer = [this, client = c.id, one](const door_outcome& outcome) { answer(client, one, outcome); };
  if (is_stop) requests.add_first(std::move(task), now);
  else requests.add(std::move(task), now);
  requests.tick(now);
}

inline void hub::undo(door_client& c, const service_call& one, time_point now) {
  if (changes.empty()) {
    log(c.name, "refused: /cca/undo: nothing was changed", false);
    return answer(c.id, one, {door_outcome::how::refused, "/cca/undo: nothing was changed"});
  }
  if (requests.is_full())
    return answer(c.id, one,
                  {door_outcome::how::refused, "too many requests wait for the controller: try again"});
  door_task task{.client = c.id, .name = c.name, .what = "/cca/undo", .may_set = true, .is_undo = true};
  task.request.about = door_request::what::set;
  task.prepare = [this](const values&, door_request& request) -> std::string {
    if (changes.empty()) return "/cca/undo: nothing was changed";
    request.values = changes.back();
    return {};
  };
  task.answer = [this, client = c.id, one](const door_outcome& outcome) { answer(client, one, outcome); };
  requests.add(std::move(task), now);
  requests.tick(now);
}

inline void hub::end(
    door_task& task, const door_outcome& outcome, const values* before, const values* after, bool is_late) {
  const bool done = outcome.is == door_outcome::how::done;
  std::string what = task.what;
  if (done && after && before) {
    std::string differs;
    for (const auto& one : *after)
      if (const door_parameter* was = parameter_of(*before, one.path); was && was->value != one.value)
        differs += (differs.empty() ? " " : ", ") + one.path + " from " + text_of(json_of(was->value)) +
                   " to " + text_of(json_of(one.value)) + (one.unit.empty() ? "" : " " + one.unit);
    what += differs.empty() ? " nothing" : differs;
    if ((!differs.empty() && task.test.empty()) || task.is_undo) remember(*before, *after, task.is_undo);
  }
  log(task.name,
      (done ? "" : "refused: ") + what + (done ? "" : ": " + outcome.why) + (is_late ? " (late)" : ""), done);
  if (after) tell_changed(*after);
  const bool has_lost = !(commander && commander->id == task.client);  // the right, meanwhile
  if (done && after && before && task.test.empty())
    for (const std::string& node : tests_begun(*before, *after)) {
      if (has_lost) switch_test_off(node, task.since);
      else driven.insert(node);
    }
  if (task.answer && !is_late) task.answer(outcome);
  // Its client was told that it is refused, or may not any more: nobody else ends it.
  if (done && !task.test.empty() && task.client != 0 && (is_late || has_lost))
    switch_test_off(task.test, task.since);
  const bool is_call = task.request.about == door_request::what::call;
  if (done && task.is_held && is_call) {
    if (has_lost) release(task.request.text, task.since);  // the effect ends at once
    else held.insert(task.request.text);
  }
  if (done && task.request.about == door_request::what::release) held.erase(task.request.text);
  if (done && task.request.about == door_request::what::speed && task.client != 0) {
    if (has_lost) set_speed_back(task.speed, task.since);
    else if (!speed_before) speed_before = task.speed;
  }
  if (done && task.request.about == door_request::what::step) has_stepped = true;
  // Components begin anew, so a signal that one of them added is over.
  if (done && task.request.about == door_request::what::start) cut_test(task.since, "a start");
}

// The values before a change, for undo; and a step of it is used up.
inline void hub::remember(const values& before, const values& after, bool is_undo) {
  if (is_undo) {
    if (!changes.empty()) changes.pop_back();
    return;
  }
  undo_step step;
  for (const auto& one : before)
    if (const door_parameter* is = parameter_of(after, one.path); is && is->value != one.value)
      step.emplace_back(one.path, one.value);
  if (changes.size() == 64) changes.pop_front();
  changes.push_back(std::move(step));
}

}  // namespace cca::detail::door_network
