// Writes what other processes publish, and environments here read, into the exchange of this one, after it
// has checked it. A status waits here until the samples that it counts have come: so no reader sees a
// position before the samples that belong to it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/dds/deployment/deployment_facts.hpp>
#include <cca/dds/deployment/presence.hpp>
#include <cca/dds/deployment/refusals.hpp>
#include <cca/runtime/pace.hpp>

namespace cca::dds::detail {

// How long an environment may be silent before its process counts as gone. Only where this process listened:
// after a standstill of its own (SIGSTOP, a debugger) what others have said meanwhile is still to be read.
inline constexpr std::int64_t lease = 2'000'000'000, standstill = lease / 4;

class receiver {
public:
  receiver(const participant& of,
           const deployment_facts& all,
           exchange_of_process& to,
           contacts& others,
           presence& who,
           refusals& counted)
      : in(of),
        facts(all),
        numbers(to),
        peers(others),
        known(who),
        refused(counted),
        wakes(dds_create_waitset(in.get()), "no waitset") {
    attach(known.reads());
    for (std::size_t e = 0; e < facts.environments.size(); ++e)
      if (!facts.is_here(e)) environments.push_back(std::make_unique<environment>(e, facts));
  }

  // All environments have a process.
  bool is_complete() const {
    for (const auto& e : environments)
      if (e->holder.token == 0) return false;
    return true;
  }
  // The newest run that others began before they listened to this process.
  std::int64_t newest_run_before() const { return run_before.load(std::memory_order_acquire); }

  // An environment that was heard then is silent for longer than it may be, and this process would have heard
  // it. In any thread.
  bool is_silent_since(std::int64_t heard) const {
    return listened_at.load(std::memory_order_acquire) -
               std::max(heard, listens_since.load(std::memory_order_acquire)) >
           lease;
  }

  // Waits until something comes, but not for long (ns). Then does what there is to do.
  void work(std::int64_t longest) {
    dds_attach_t some[8];
    dds_waitset_wait(wakes.get(), some, 8, longest);
    const std::int64_t now = cca::detail::monotonic_clock::now();
    if (now - listened_at.load(std::memory_order_relaxed) > standstill)
      listens_since.store(now, std::memory_order_release);
    if (now - cleared_at > lease / 10) {
      known.forget_the_lost();
      cleared_at = now;
    }
    for (auto& e : environments) {
      choose(*e, now);
      if (!e->statuses) continue;
      e->statuses->take_all([&](auto message, const identity& from) { hear(*e, message, from, now); });
      for (auto& o : e->outputs)
        o.reader.take_all([&](auto message, const identity& from) { hear(*e, o, message, from); });
      apply(*e);
    }
    listened_at.store(now, std::memory_order_release);
  }

private:
  struct output {
    std::size_t number, place;  // among all, and among those of its environment
    channel_reader reader;
    arriving_numbers arrived{};
  };
  struct dated_status {
    status message;
    std::int64_t at;
  };
  struct environment {
    environment(std::size_t e, const deployment_facts& facts)
        : number(e), scratch(facts.environments.size(), facts.outputs_of(e).size(), facts.limits.parts) {}
    std::size_t number;
    identity holder{};
    std::int64_t accepted_at = 0;
    status scratch;
    bool has_status = false;
    std::unique_ptr<channel_reader> statuses{};
    std::vector<output> outputs{};
    std::optional<dated_status> held{}, newest{};  // what waits for samples, and the newest after that
  };

  void attach(dds_entity_t reader) {
    const auto condition = checked(dds_create_readcondition(reader, DDS_ANY_STATE), "no condition");
    checked(dds_waitset_attach(wakes.get(), condition, 0), "no waitset");
  }

  // ---- which process runs an environment ----

  bool is_lost(const environment& e) const {
    const contact& c = peers[e.number];
    const peer* const holder = known.find(e.holder);
    return !holder || holder->is_refused || c.has_left ||
           is_silent_since(std::max<std::int64_t>(c.heard, e.accepted_at));
  }
  void choose(environment& e, std::int64_t now) {
    if (e.holder.token != 0 && !is_lost(e)) return;
    const peer* best = nullptr;
    for (const peer& p : known.peers())
      if (!(p.id == e.holder) && (p.claims >> e.number & 1) && !p.is_refused &&
          (!best || is_before(p, *best)))
        best = &p;
    if (best) accept(e, best->id, now);
  }
  // New readers: they get what the writers keep for those that come late.
  void accept(environment& e, const identity& who, std::int64_t now) {
    e.held.reset();
    e.newest.reset();
    e.outputs.clear();
    e.statuses.reset();
    e.has_status = false;
    e.holder = who;
    e.accepted_at = now;
    const std::vector<std::size_t> outputs = facts.outputs_of(e.number);
    for (std::size_t place = 0; place < outputs.size(); ++place) {
      const leaving_output& out = facts.outputs[outputs[place]];
      if ((out.readers & facts.here) == 0) continue;
      e.outputs.push_back(
          {outputs[place], place, {in, out.topic, out.type, sample_message::head + out.size}});
      attach(e.outputs.back().reader.get());
    }
    e.statuses = std::make_unique<channel_reader>(
        in, facts.status_topic(e.number), facts.status_type(),
        status::size(facts.environments.size(), outputs.size(), facts.limits.parts));
    attach(e.statuses->get());
    contact& c = peers[e.number];
    c.has_left = false;
    c.heard = 0;
    c.accepted_in.store(numbers.run_ready(facts.first_here()), std::memory_order_relaxed);
    c.accepted.store(who.token, std::memory_order_release);
  }

  // ---- what comes ----

  void hear(environment& e, std::span<const std::uint64_t> message, const identity& from, std::int64_t now) {
    if (!is_holder(e, from, now)) return;
    if (message.empty()) return refuse(e, "a status of another length");
    e.scratch.read_from(message);
    if (const auto why = e.scratch.complaint(facts.limits, newest_beat(e)); !why.empty())
      return refuse(e, why);
    if (e.scratch.accepted[facts.first_here()] != in.id().token)
      return;  // it does not know of this process yet
    const std::int64_t before = e.scratch.accepted_in[facts.first_here()];
    if (before > run_before.load(std::memory_order_relaxed))
      run_before.store(before, std::memory_order_release);
    (e.held ? e.newest : e.held) = dated_status{e.scratch, now};
  }
  void hear(environment& e, output& o, std::span<const std::uint64_t> message, const identity& from) {
    if (!is_holder(e, from, no_time)) return;
    if (const auto why = o.arrived.complaint(message, facts.limits, newest_beat(e)); !why.empty())
      return refuse(e, why);
    if (!sample_message::is_finite(message)) refused.add_not_finite();
    numbers.put(o.number, message);
  }
  void apply(environment& e) {
    while (e.held) {
      for (const output& o : e.outputs)
        if (!o.arrived.has_come(e.held->message.published[o.place])) return;
      if (peers[e.number].has_left) return;
      numbers.write(e.number, e.held->message, e.held->at);
      e.has_status = true;
      contact& c = peers[e.number];
      c.heard.store(e.held->at, std::memory_order_release);
      if (e.held->message[status::flags] & status::is_leaving)
        c.has_left.store(true, std::memory_order_release);
      e.held = std::exchange(e.newest, std::nullopt);
    }
  }

  // Before its first status an environment that goes on with a run may be at any beat.
  std::int64_t newest_beat(const environment& e) const { return e.has_status ? numbers.newest_beat() : -1; }

  bool is_holder(const environment& e, const identity& from, std::int64_t now) {
    if (from == e.holder && from.token != 0) {
      const peer* const holder = known.find(from);
      return holder && !holder->is_refused;
    }
    const peer* const other = known.find(from);
    if (other && !other->is_refused && (other->claims >> e.number & 1)) return false;  // it may take over
    if (!other && now != no_time && is_new(from, now)) return false;
    refused.add(other ? other->name : "participant " + std::to_string(from.token),
                "it does not run environment `" + std::string(facts.environments[e.number].name) + "`");
    return false;
  }
  // A status may come before the presence of its sender.
  bool is_new(const identity& from, std::int64_t now) {
    for (const auto& [token, since] : strangers)
      if (token == from.token) return now - since < lease;
    if (strangers.size() == most_strangers) strangers.erase(strangers.begin());
    strangers.emplace_back(from.token, now);
    return true;
  }
  // A process that sends an impossible message is ignored from then on: contact with it is lost.
  void refuse(environment& e, std::string_view why) {
    peer* const liar = known.find(e.holder);
    if (!liar) return;
    liar->is_refused = true;
    refused.add(liar->name, why);
    for (auto& other : environments)
      if (other->holder == e.holder) {
        peers[other->number].has_left.store(true, std::memory_order_release);
        numbers.forget(other->number);  // so its samples are late in a wall-clock run, too
      }
  }

  static constexpr std::int64_t no_time = -1;
  static constexpr std::size_t most_strangers = 64;

  const participant& in;
  const deployment_facts& facts;
  exchange_of_process& numbers;
  contacts& peers;
  presence& known;
  refusals& refused;
  entity wakes;
  std::vector<std::unique_ptr<environment>> environments;
  std::vector<std::pair<std::uint64_t, std::int64_t>> strangers;
  std::atomic<std::int64_t> run_before{0};
  std::atomic<std::int64_t> listened_at{0}, listens_since{0};  // ns
  std::int64_t cleared_at = 0;
};

}  // namespace cca::dds::detail
