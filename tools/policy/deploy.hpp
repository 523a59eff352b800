// deploy.yaml of unitree_rl_lab, and the configuration of rl_sar, as statements.
#pragma once

#include <yaml-cpp/yaml.h>

#include "statements.hpp"

namespace cca_policy {

class deploy_reader {
public:
  deploy_reader(const std::string& text, const std::string& file, statements& to, complaints& wrong)
      : file_(file), to_(to), wrong_(wrong) {
    YAML::Node root;
    try {
      if (text.size() > (1 << 20)) refuse(file + ": it is larger than 1 MB, which no such file is");
      root = YAML::Load(text);
    } catch (const YAML::Exception& e) {
      refuse(file + ":" + std::to_string(e.mark.line + 1) + ": it is no YAML: " + e.msg);
    }
    try {
      if (!root.IsMap())
        refuse(file + ": expected the keys of a deploy.yaml or of a configuration of rl_sar");
      if (root["observations"] && root["observations"].IsMap()) unitree(root);
      else if (root["observations"]) rl_sar(root);
      else if (root.size() == 1 && root.begin()->second.IsMap() && root.begin()->second["observations"])
        rl_sar(root.begin()->second);
      else refuse(file + ": it has no `observations`: expected a deploy.yaml or a configuration of rl_sar");
    } catch (const YAML::Exception& e) {
      refuse(file + ":" + std::to_string(e.mark.line + 1) + ": " + e.msg);
    }
  }

private:
  std::string where(const YAML::Node& n) const { return file_ + ":" + std::to_string(n.Mark().line + 1); }

  bool numbers(const YAML::Node& n, statement& s) {
    if (!n || n.IsNull()) return false;
    s.where = where(n);
    s.relative = relative_;
    const auto one = [&](const YAML::Node& item) {
      const auto value = item.IsScalar() ? number_in(item.Scalar()) : std::nullopt;
      if (!value)
        wrong_.add(where(item) + ": expected a number" +
                   (item.IsScalar() ? ", got `" + item.Scalar().substr(0, 40) + "`" : ""));
      else s.numbers.push_back(*value);
      return value.has_value();
    };
    if (n.IsSequence()) {
      for (const auto& item : n)
        if (!one(item)) return false;
      return !s.numbers.empty();
    }
    return one(n);
  }
  void add(const YAML::Node& n, const std::string& key) {
    if (statement s; numbers(n, s)) to_.add(key, s);
  }
  void add_words(const YAML::Node& n, const std::string& key) {
    statement s;
    if (!n || !n.IsSequence() || n.size() == 0) return;
    s.where = where(n);
    for (const auto& item : n) {
      if (!item.IsScalar()) return wrong_.add(where(item) + ": expected a name");
      s.words.push_back(item.Scalar());
    }
    to_.add(key, s);
  }
  // [lower, upper], or one such pair for each number.
  void add_clip(const YAML::Node& n, const std::string& key) {
    if (!n || n.IsNull()) return to_.add(key, {{}, {"none"}, n ? where(n) : file_, 0});
    if (!n.IsSequence() || n.size() == 0 || !n[0].IsSequence()) return add(n, key);
    statement first;
    for (const auto& pair : n) {
      statement s;
      if (!numbers(pair, s)) return;
      if (first.numbers.empty()) first = s;
      else if (s.numbers != first.numbers)
        return wrong_.add(where(pair) + ": `" + key +
                          "` differs from number to number, which is not possible here");
    }
    to_.add(key, first);
  }

  // All joints in their order: nothing, Python's slice(None), which is three nulls, or 0, 1, 2, ...
  static bool are_all(const YAML::Node& ids, const YAML::Node& map) {
    if (!ids || ids.IsNull()) return true;
    const std::size_t count = map && map.IsSequence() ? map.size() : 0;
    if (!ids.IsSequence()) return false;
    if (ids.Tag().ends_with("builtins.slice"))
      return std::ranges::all_of(ids, [](const YAML::Node& one) { return one.IsNull(); });
    std::size_t next = 0;
    for (const auto& one : ids)
      if (one.as<std::size_t>(count) != next++) return false;
    return next == count;
  }

  // Gains are in the order of the motors, everything else in that of the policy.
  void unitree(const YAML::Node& root) {
    relative_ = 5.1e-3;  // three significant digits
    add(root["joint_ids_map"], "joint_ids");
    add(root["default_joint_pos"], "default_positions");
    add(root["stiffness"], "motor_stiffness");
    add(root["damping"], "motor_damping");
    statement step;
    if (numbers(root["step_dt"], step) && step.numbers[0] > 0)
      to_.add("rate", {{1 / step.numbers[0]}, {}, step.where, 1e-6});
    if (const YAML::Node actions = root["actions"]; actions && actions.IsMap()) {
      if (actions.size() != 1)
        wrong_.add(where(actions) + ": it has " + std::to_string(actions.size()) +
                   " actions; one is possible");
      for (const auto& entry : actions) {
        if (const YAML::Node ids = entry.second["joint_ids"]; !are_all(ids, root["joint_ids_map"]))
          wrong_.add(where(ids) +
                     ": the action moves some of the joints, or in another order; here it moves all that are "
                     "observed, in their order");
        add(entry.second["scale"], "action.scale");
        add(entry.second["offset"], "action.offset");
        add_clip(entry.second["clip"], "action.target_clip");
      }
    }
    statement order;
    for (const auto& entry : root["observations"]) {
      const std::string name = entry.first.Scalar(), key = "observation." + name;
      if (name == "use_gym_history") continue;
      order.words.push_back(name);
      order.where = where(root["observations"]);
      if (!entry.second.IsMap()) {
        wrong_.add(where(entry.second) + ": the observation `" + name + "` has no keys");
        continue;
      }
      add(entry.second["scale"], key + ".scale");
      add_clip(entry.second["clip"], key + ".clip");
      if (statement s; numbers(entry.second["history_length"], s)) {
        s.numbers[0] = std::max(1.0, s.numbers[0]);
        to_.add(key + ".history", s);
      }
    }
    if (!order.words.empty()) to_.add("observations", order);
  }

  void rl_sar(const YAML::Node& root) {
    add_words(root["observations"], "observations");
    add(root["default_dof_pos"], "default_positions");
    add(root["rl_kp"], "stiffness");
    add(root["rl_kd"], "damping");
    add(root["action_scale"], "action.scale");
    // It states scales of terms that the policy need not observe.
    const auto observes = [&](const std::string& term) {
      for (const auto& one : root["observations"])
        if (one.IsScalar() && one.Scalar() == term) return true;
      return false;
    };
    for (const char* term : {"lin_vel", "ang_vel", "dof_pos", "dof_vel", "commands"})
      if (observes(term))
        add(root[std::string(term) + "_scale"], "observation." + std::string(term) + ".scale");
    for (const char* term : {"gravity_vec", "actions"})
      if (observes(term))
        to_.add("observation." + std::string(term) + ".scale",
                {{1}, {}, file_ + " (rl_sar scales it by 1)", 0});
    if (statement s; numbers(root["clip_obs"], s)) {
      to_.add("observations.clip", {{-s.numbers[0], s.numbers[0]}, {}, s.where, 0});
      to_.add("observations.clips", {{}, {"after_scale"}, s.where, 0});
    }
    statement lower, upper;
    if (numbers(root["clip_actions_lower"], lower) && numbers(root["clip_actions_upper"], upper)) {
      for (const statement* s : {&lower, &upper})
        for (const double number : s->numbers)
          if (number != s->numbers[0])
            return wrong_.add(s->where +
                              ": clip_actions differs from joint to joint, which is not possible here");
      to_.add("action.clip", {{lower.numbers[0], upper.numbers[0]}, {}, lower.where, 0});
    }
    statement step, decimation;
    if (numbers(root["dt"], step) && numbers(root["decimation"], decimation) &&
        step.numbers[0] * decimation.numbers[0] > 0)
      to_.add("rate", {{1 / (step.numbers[0] * decimation.numbers[0])}, {}, step.where, 1e-6});
    rl_sar_joints(root);
    const YAML::Node past = root["observations_history"];
    if (past && past.IsSequence() && past.size() == 0)
      to_.add("history.length", {{1}, {}, where(past), 0});  // only the latest
    if (statement s; past && past.size() > 0 && numbers(past, s)) {
      to_.add("history.length", {{static_cast<double>(s.numbers.size())}, {}, s.where, 0});
      if (s.numbers.size() > 1) {
        const bool newest = s.numbers.front() == 0;  // 0 is the latest observation
        for (std::size_t i = 0; i < s.numbers.size(); ++i)
          if (s.numbers[i] != static_cast<double>(newest ? i : s.numbers.size() - 1 - i))
            return wrong_.add(s.where + ": observations_history has gaps, which is not possible here");
        to_.add("history.order", {{}, {newest ? "newest_first" : "oldest_first"}, s.where, 0});
      }
    }
    if (const YAML::Node n = root["observations_history_priority"]; n && n.IsScalar()) {
      if (n.Scalar() == "time" || n.Scalar() == "term")
        to_.add("history.layout", {{}, {n.Scalar() == "time" ? "by_time" : "by_term"}, where(n), 0});
      else wrong_.add(where(n) + ": expected time or term, got `" + n.Scalar().substr(0, 40) + "`");
    }
  }

  // Its names are in the order of the robot. They are the policy's only where the mapping changes nothing:
  // which way a mapping goes differs between versions.
  void rl_sar_joints(const YAML::Node& root) {
    for (const char* key : {"joint_mapping", "state_mapping", "command_mapping"})
      if (const YAML::Node n = root[key]; n && n.IsSequence())
        for (std::size_t i = 0; i < n.size(); ++i)
          if (n[i].as<std::string>() != std::to_string(i)) return;
    add_words(root["joint_names"], "joints");
  }

  std::string file_;
  double relative_ = 1e-6;
  statements& to_;
  complaints& wrong_;
};

}  // namespace cca_policy
