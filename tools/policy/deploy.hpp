// deploy.yaml of unitree_rl_lab, and the configuration of rl_sar, as statements.
#pragma once

#include <tuple>

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

  // The joints that an action moves: nothing, which is all in their order, as Python's slice(None), three
  // nulls; or their numbers. False: neither.
  static bool joints_of(const YAML::Node& ids, std::size_t count, std::vector<double>& to) {
    to.clear();
    const bool none = !ids || ids.IsNull();
    if (none || (ids.IsSequence() && ids.Tag().ends_with("builtins.slice"))) {
      for (std::size_t i = 0; i < count; ++i) to.push_back(static_cast<double>(i));
      return none || std::ranges::all_of(ids, [](const YAML::Node& one) { return one.IsNull(); });
    }
    if (!ids.IsSequence() || ids.size() == 0) return false;
    for (const auto& one : ids) {
      const auto id = one.IsScalar() ? number_in(one.Scalar()) : std::nullopt;
      if (!id) return false;
      to.push_back(*id);
    }
    return true;
  }
  // What an action commands, by its name: those of two kinds are no list of targets.
  static std::string kind_of(const std::string& action) {
    for (const char* kind : {"Position", "Velocity", "Effort", "Torque"})
      if (action.find(kind) != action.npos) return kind;
    return "Position";
  }
  // One after the other, as the network's numbers stand.
  void actions_of(const YAML::Node& all, const YAML::Node& map) {
    const std::size_t count = map && map.IsSequence() ? map.size() : 0;
    statement order, scale, offset;
    std::map<double, std::string> mover;
    std::string first;
    int scaled = 0, shifted = 0;
    for (const auto& entry : all) {
      const std::string name = entry.first.Scalar();
      const YAML::Node& keys = entry.second;
      const std::string line = where(entry.first);
      if (!keys.IsMap()) return wrong_.add(line + ": the action `" + name + "` has no keys");
      if (first.empty()) first = name;
      if (kind_of(name) != kind_of(first))
        return wrong_.add(line + ": the actions `" + first + "` and `" + name +
                          "` command different things; here all joints get targets of one kind");
      std::vector<double> ids;
      if (const YAML::Node said = keys["joint_ids"]; !joints_of(said, count, ids))
        return wrong_.add(where(said) + ": `joint_ids` of the action `" + name +
                          "`: expected nothing for all joints, or their numbers in joint_ids_map");
      const bool lists =
          keys["joint_ids"] && keys["joint_ids"].IsSequence() && keys["joint_ids"][0].IsScalar();
      if (ids.empty() && all.size() > 1)
        return wrong_.add(line + ": the action `" + name +
                          "` moves all joints, and there is another action: each needs joints of its own");
      for (const double id : ids)
        if (const auto& by = mover.emplace(id, name).first->second; by != name)
          return wrong_.add(line + ": the actions `" + by + "` and `" + name + "` both move joint " +
                            text_of(id) + ": actions stand one after the other, each with joints of its own");
      order.where = order.numbers.empty() ? line : order.where;
      order.numbers.insert(order.numbers.end(), ids.begin(), ids.end());
      scaled += append(keys["scale"], name, ids.size(), lists, scale);
      shifted += append(keys["offset"], name, ids.size(), lists, offset);
      add_clip(keys["clip"], "action.target_clip");
    }
    const int actions = static_cast<int>(all.size());
    if (actions == 0) return;
    if (!order.numbers.empty()) to_.add("action.joint_ids", order);
    for (const auto& [said, what, list] :
         {std::tuple(scaled, "scale", &scale), std::tuple(shifted, "offset", &offset)}) {
      if (said == actions) to_.add(std::string("action.") + what, *list);
      else if (said > 0)
        wrong_.add(list->where + ": not all actions have a `" + what + "`, and some have one");
    }
  }
  // A list of an action behind those of the ones before, one number for all its joints written out.
  bool append(
      const YAML::Node& n, const std::string& action, std::size_t count, bool lists_joints, statement& to) {
    statement s;
    if (!numbers(n, s)) return false;
    if (const double one = s.numbers[0]; s.numbers.size() == 1 && count > 0) s.numbers.assign(count, one);
    if (lists_joints && s.numbers.size() != count)
      wrong_.add(s.where + ": the action `" + action + "` moves " + std::to_string(count) +
                 " joints, and this has " + std::to_string(s.numbers.size()) + " numbers");
    if (to.numbers.empty()) to.where = s.where, to.relative = s.relative;
    to.numbers.insert(to.numbers.end(), s.numbers.begin(), s.numbers.end());
    return true;
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
    if (const YAML::Node actions = root["actions"]; actions && actions.IsMap())
      actions_of(actions, root["joint_ids_map"]);
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
