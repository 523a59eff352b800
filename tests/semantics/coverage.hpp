// What the random architectures exercised. It is counted from the interpreter after its run, so only what
// happened counts.
#pragma once

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <map>
#include <ostream>
#include <span>
#include <string>

#include "interpreter.hpp"

namespace semantics {

class coverage {
public:
  void add(const interpreter& i) {
    for (const auto& [name, n] : i.g.features) counts[name] += n;
    for (const node& n : i.g.nodes) {
      counts["nodes in a nested graph"] += n.path.find('.') != std::string::npos;
      counts["nodes three graphs deep"] += std::count(n.path.begin(), n.path.end(), '.') >= 3;
      counts["resource nodes"] += n.resource;
    }
    for (const call& t : i.g.calls) {
      const node& n = i.g.nodes[t.node];
      if (t.firings > 0) add(n.when, t.which == function::process ? "" : " (resource node)");
      for (const int p : n.parts) {
        const bool again = i.g.parts[p].start_in != never && i.g.parts[p].start_in < i.k && !t.is_new;
        counts["components that were stopped and fired again"] += again;
        counts["components of inner graphs that were stopped and fired again"] +=
            again && i.g.parts[p].path != n.path;
        counts["components of parts in parts"] += n.parts.size() > 1 && t.firings > 0;
      }
      if (!n.skeleton.empty() && t.firings > 1) ++counts["skeleton: " + n.skeleton];
      if (n.when.is == strategy::inactive && t.firings == 0) ++counts["inactive, never fired"];
      counts["halves of resource nodes that fired"] += t.which != function::process && t.firings > 0;
      counts["components with several outputs that fired"] += t.outputs.size() > 1 && t.firings > 0;
      for (const input& in : t.inputs) add(in, t, i);
      for (const output& out : t.outputs)
        if (out.is_maybe && t.firings > 0) {
          counts["maybe outputs that published"] += !out.history.empty();
          counts["maybe outputs that once did not"] += std::ssize(out.history) < t.firings;
        }
    }
    for (const part& p : i.g.parts) counts["parts that components stopped or started"] += p.changes > 0;
    counts["switches that components asked for"] += i.g.switched;
    counts["switches from outside"] += static_cast<long>(i.g.switches.size());
    bool component_fault = false;
    for (const firing& f : i.firings) {
      component_fault = component_fault || f.fault;
      if (f.fault)
        ++counts[f.which == function::sense ? "faults in sense"
                 : f.which == function::act ? "faults in act"
                                            : "faults in process"];
      counts["on_fault calls"] += f.which == function::on_fault;
      counts["samples that a program saw fresh"] += f.which == function::look && f.inputs[0].fresh;
      for (const recorded_output& t : f.outputs)
        counts["samples with an origin of the component's own"] += t.sets_origin;
      for (const recorded_input& s : f.inputs) ++samples, counts["samples seen fresh"] += s.fresh;
      samples += static_cast<long>(f.outputs.size());
      ++firings;
    }
    counts["faults of a full queue"] += i.faulted && !component_fault;
    ++architectures;
  }

  // False if anything was never exercised.
  bool report(std::ostream& to, std::span<const char* const> names = wanted) const {
    bool all = true;
    for (const char* name : names) {
      const auto found = counts.find(name);
      const long n = found == counts.end() ? 0 : found->second;
      to << std::setw(9) << n << "  " << name << (n ? "" : "   <- never exercised") << '\n';
      all = all && n;
    }
    return all;
  }

  long architectures = 0, samples = 0, firings = 0;

  static constexpr const char* wanted[] = {"default",
                                           "timed",
                                           "timed with a phase",
                                           "restless",
                                           "moderate",
                                           "timeout",
                                           "port_triggered",
                                           "coordinated",
                                           "full_speed",
                                           "inactive, never fired",
                                           "any_of",
                                           "all_of",
                                           "stoppable",
                                           "components that were stopped and fired again",
                                           "components of inner graphs that were stopped and fired again",
                                           "components of parts in parts",
                                           "inner graphs that may be stopped",
                                           "parts that components stopped or started",
                                           "user: on_beats",
                                           "user: patient",
                                           "user: above",
                                           "user: older",
                                           "user: fresh_on_odd",
                                           "user: every_nth",
                                           "user: while_waiting",
                                           "latest",
                                           "delayed<1>",
                                           "delayed<N>",
                                           "delayed, its own writer",
                                           "queue, drop_oldest",
                                           "queue, drop_oldest: lost",
                                           "queue, drop_newest",
                                           "queue, drop_newest: lost",
                                           "queue, reject",
                                           "queue, delayed",
                                           "merged, drop_oldest",
                                           "merged, drop_oldest: lost",
                                           "merged, drop_newest",
                                           "merged, drop_newest: lost",
                                           "merged: samples of two or more wires",
                                           "merged, some of them delayed",
                                           "merged, all of them delayed",
                                           "merged, some of them close a loop",
                                           "faults of a full queue",
                                           "queue, read empty after a sample",
                                           "initial",
                                           "policies left out",
                                           "samples kept for a later beat",
                                           "samples seen fresh",
                                           "optional_in, wired",
                                           "optional_in, not wired",
                                           "maybe outputs that published",
                                           "maybe outputs that once did not",
                                           "components with several outputs that fired",
                                           "samples with an origin of the component's own",
                                           "resource nodes",
                                           "halves of resource nodes that fired",
                                           "default (resource node)",
                                           "timed (resource node)",
                                           "full_speed (resource node)",
                                           "wires from sense to sense",
                                           "wires from act to act",
                                           "nodes in a nested graph",
                                           "nodes three graphs deep",
                                           "exposes",
                                           "graphs used twice",
                                           "observers",
                                           "observers that hear inputs",
                                           "observers with a queue",
                                           "heard where it waits in a queue",
                                           "heard after it was taken from a queue",
                                           "patterns from the outermost graph",
                                           "patterns found in a graph around",
                                           "patterns with **",
                                           "observed by a graph: no policy",
                                           "observed by a graph: latest",
                                           "observed by a graph: delayed",
                                           "observed by a graph: queue",
                                           "observed by a graph: queue, delayed",
                                           "observed by a graph: several outputs with a policy",
                                           "observed by a graph: inputs",
                                           "samples that a program saw fresh",
                                           "rated ports",
                                           "rate from the spaces",
                                           "faults in sense",
                                           "faults in process",
                                           "faults in act",
                                           "on_fault calls",
                                           "of skeletons: pipeline",
                                           "of skeletons: pipeline_over",
                                           "of skeletons: farm",
                                           "of skeletons: farm with inner wires",
                                           "skeleton: by_priority",
                                           "skeleton: by_freshness",
                                           "skeleton: switch",
                                           "skeleton: blend",
                                           "skeleton: blend_of",
                                           "skeleton: hold",
                                           "of skeletons: freeze",
                                           "skeleton: decimate",
                                           "skeleton: interpolate",
                                           "skeleton: splitter",
                                           "skeleton: collector",
                                           "skeleton: share_out",
                                           "skeleton: gather"};
  static constexpr const char* wanted_of_environments[] = {
      "environments",
      "wires between environments",
      "wires between environments, longer than a beat",
      "observers across environments",
      "heard after it was taken from a queue",
      "free-running environments",
      "wires without delay to or from a free-running environment",
      "queue wires without delay to or from a free-running environment",
      "merged wires without delay to or from a free-running environment",
      "components of free-running environments that may be stopped",
      "inner graphs that may be stopped, partly in a free-running environment",
      "inner graphs that may be stopped",
      "parts that components stopped or started",
      "components that were stopped and fired again",
      "components of inner graphs that were stopped and fired again",
      "observed by a graph: no policy",
      "observed by a graph: delayed",
      "observed by a graph: queue",
      "observed by a graph: queue, delayed",
      "observed by a graph: several outputs with a policy",
      "samples that a program saw fresh",
      "queue, drop_oldest: lost",
      "queue, delayed",
      "merged: samples of two or more wires",
      "queues between environments",
      "merged wires between environments",
      "faults in process",
      "on_fault calls"};

  static constexpr const char* wanted_of_modes[] = {"sets of modes",
                                                    "components that a mode lacks",
                                                    "components that are the same in all modes",
                                                    "components that ask for modes",
                                                    "switches that components asked for",
                                                    "switches from outside",
                                                    "inner graphs of modes that may be stopped",
                                                    "components of modes that ask for parts",
                                                    "parts that components stopped or started",
                                                    "components that were stopped and fired again",
                                                    "observers in modes",
                                                    "modes that programs look at",
                                                    "observed by a graph: queue",
                                                    "observed by a graph: delayed",
                                                    "samples that a program saw fresh",
                                                    "queue, drop_oldest: lost",
                                                    "queue, drop_newest: lost",
                                                    "queue, delayed",
                                                    "merged: samples of two or more wires",
                                                    "faults in process",
                                                    "on_fault calls"};

private:
  void add(const strategy& s, const std::string& where) {
    ++counts[(s.is == strategy::user ? "user: " + s.names[0] : strategy_names[s.is]) + where];
    if (s.is == strategy::timed && s.phase != 0) ++counts["timed with a phase" + where];
    for (const strategy& part : s.parts) add(part, where);
  }

  void add(const input& in, const call& t, const interpreter& i) {
    if (!in.wired()) {
      counts["optional_in, not wired"] += in.reads > 0;
      return;
    }
    counts["optional_in, wired"] += in.optional && in.fresh_reads > 0;
    if (in.fresh_reads == 0) return;
    counts["initial"] += std::any_of(in.initial.begin(), in.initial.end(), [](double x) { return x != 0; });
    counts["samples kept for a later beat"] += in.reads > in.fresh_reads;
    const bool is_delayed = in.ways[0].delay > 0;
    if (in.shown_call >= 0) ++counts["heard where it waits in a queue"];
    if (in.ways[0].is_taken) ++counts["heard after it was taken from a queue"];
    if (in.is == policy::latest)
      ++counts[is_delayed ? in.ways[0].delay == 1 ? "delayed<1>" : "delayed<N>" : "latest"];
    counts["delayed, its own writer"] += is_delayed && i.g.calls[in.ways[0].writer].node == t.node;
    if (in.is != policy::queue) return;
    if (!in.is_merged) counts["queue, delayed"] += is_delayed;
    if (in.is_merged) add_merged(in, t, i);
    constexpr const char* full[] = {"drop_oldest", "drop_newest", "reject"};
    const std::string name =
        std::string(in.is_merged ? "merged, " : "queue, ") + full[static_cast<int>(in.full)];
    ++counts[name];
    counts[name + ": lost"] += in.full != when_full::reject && in.dropped > 0;
    counts["queue, read empty after a sample"] += in.taken && in.reads > in.fresh_reads;
  }

  // Samples of several of its ways have been read.
  void add_merged(const input& in, const call& t, const interpreter& i) {
    int delayed = 0, closing = 0;
    for (const way& w : in.ways) {
      delayed += w.delay > 0;
      closing += w.delay > 0 && i.feeds(t.node, i.g.calls[w.writer].node);
    }
    const int ways = static_cast<int>(in.ways.size());
    const bool is_whole = in.ways_taken == (1 << ways) - 1;
    counts["merged: samples of two or more wires"] += ways > 1 && is_whole;
    counts["merged, some of them delayed"] += delayed > 0 && delayed < ways && is_whole;
    counts["merged, all of them delayed"] += ways > 1 && delayed == ways && is_whole;
    counts["merged, some of them close a loop"] += closing > 0 && closing < ways && is_whole;
  }

  std::map<std::string, long> counts;
};

}  // namespace semantics
