// The contract: what all files together say. Nothing is guessed: what none of them says is a complaint that
// names the key of the map.
#pragma once

#include "statements.hpp"

namespace cca_policy {

struct number_of_term {
  std::string name;
  double rest = 0, scale = 1;
  int sign = 1;
};

struct range {
  double lower = -HUGE_VAL, upper = HUGE_VAL;
  bool is_none() const { return lower == -HUGE_VAL && upper == HUGE_VAL; }
};

struct term {
  std::string name, is;
  std::vector<number_of_term> numbers;
  range clip, seen, target_clip;
  bool clips_scaled = false;
};

struct contract {
  std::string name;
  double rate = 0, oldest = 0;
  int history = 1;
  std::string layout = "by_term", order = "oldest_first", start = "repeated";
  std::vector<term> terms;
  term action;
  bool observes_clipped = false;
  std::vector<std::string> joints;  // the policy's names, in its order
  std::vector<std::size_t> moved;   // in the order of the action, each of these joints once
  std::vector<double> stiffness, damping;
};

class resolver {
public:
  resolver(const statements& said, complaints& wrong) : said_(said), wrong_(wrong) {}

  contract all(const std::string& name) {
    contract c;
    c.name = name;
    if (const auto* s = text("name", "")) c.name = *s;
    c.rate = one("rate", "the policy's steps a second");
    if (c.rate < 0 || c.rate > 1e5) wrong_.add("`rate` is " + text_of(c.rate) + " Hz: expected one above 0");
    c.oldest = said_.has("oldest") ? one("oldest", "") : 0;
    joints(c);
    moved(c);
    gains(c);
    observations(c);
    action(c);
    return c;
  }

  // What the network must have.
  void compare(const contract& c, const network& n) {
    int seen = 0;
    std::string sizes;
    for (const term& t : c.terms) {
      seen += static_cast<int>(t.numbers.size());
      sizes += (sizes.empty() ? "" : ", ") + t.name + " " + std::to_string(t.numbers.size());
    }
    if (seen * c.history != n.inputs)
      wrong_.add("the observations have " + std::to_string(seen) + " numbers (" + sizes + ")" +
                 (c.history > 1 ? ", times " + std::to_string(c.history) + " of history," : "") +
                 " and the input `" + n.observations + "` of the network has " + std::to_string(n.inputs));
    if (static_cast<int>(c.joints.size()) != n.outputs)
      wrong_.add("there are " + std::to_string(c.joints.size()) + " joints, and the output `" + n.actions +
                 "` of the network has " + std::to_string(n.outputs) + " numbers");
  }
  void compare_normaliser(const network& n) {
    const std::string* where = text("network.normaliser",
                                    "whether observations are normalised: \"inside\" of the file, "
                                    "\"none\", or \"outside\" with network.mean and network.deviation");
    if (!where) return;
    if (*where != "inside" && *where != "none" && *where != "outside")
      return wrong_.add("`network.normaliser` is " + *where + ": expected inside, none or outside");
    if (*where == "inside" && !n.begins_with_normaliser)
      wrong_.add(
          "`network.normaliser` is inside, and the network does not begin with Sub and Div of its "
          "observation: the normaliser is missing in the file; export it, or say \"outside\" with "
          "network.mean "
          "and network.deviation");
    if (*where != "inside" && n.begins_with_normaliser)
      wrong_.add("`network.normaliser` is " + *where +
                 ", and the network begins with a normaliser of its own (" + n.operators.front() +
                 "): " + (*where == "none" ? "say \"inside\"" : "it would be normalised twice"));
    if (*where == "outside" && (!said_.has("network.mean") || !said_.has("network.deviation")))
      wrong_.add(
          "`network.normaliser` is outside: write `network.mean` and `network.deviation`, one number for "
          "each observation");
  }

private:
  const statement* get(const std::string& key) { return said_.get(key, wrong_); }
  void missing(const std::string& key, const std::string& what) {
    wrong_.add("no file says `" + key + "`" + (what.empty() ? "" : ": " + what) + "; write it in the map");
  }
  const std::string* text(const std::string& key, const std::string& what) {
    const statement* s = get(key);
    if (!s) {
      if (!what.empty()) missing(key, what);
      return nullptr;
    }
    if (s->words.size() == 1) return &s->words[0];
    wrong_.add(s->where + ": `" + key + "` is one text");
    return nullptr;
  }
  // One of some words. Where the files say none: the first one if `what` is empty, else an error that asks.
  std::string choice(const std::string& key, const std::vector<std::string>& of, const std::string& what) {
    const std::string* said = text(key, what);
    if (!said) return of[0];
    for (const std::string& one : of)
      if (*said == one) return one;
    std::string list;
    for (const std::string& one : of) list += (list.empty() ? "" : ", ") + one;
    wrong_.add(get(key)->where + ": `" + key + "` is " + *said + ": expected one of " + list);
    return of[0];
  }
  double one(const std::string& key, const std::string& what) {
    const statement* s = get(key);
    if (!s) missing(key, what);
    else if (s->numbers.size() != 1) wrong_.add(s->where + ": `" + key + "` is one number");
    else return s->numbers[0];
    return 0;
  }
  // As many numbers as wanted, or one for all.
  std::vector<double> list(const std::string& key, std::size_t count, const std::string& what) {
    const statement* s = get(key);
    if (!s) {
      if (!what.empty()) missing(key, what);
      return std::vector<double>(count, 0);
    }
    if (count == 0) return {};  // the names of the joints or numbers are missing, which is another complaint
    if (s->numbers.size() == count) return s->numbers;
    if (s->numbers.size() == 1) return std::vector<double>(count, s->numbers[0]);
    wrong_.add(s->where + ": `" + key + "` has " + std::to_string(s->numbers.size()) + " numbers, expected " +
               std::to_string(count));
    return std::vector<double>(count, 0);
  }
  range bounds(const std::string& key, const std::string& what) {
    const statement* s = get(key);
    if (!s) {
      if (!what.empty()) missing(key, what);
      return {};
    }
    if (s->words.size() == 1 && s->words[0] == "none") return {};
    if (s->numbers.size() == 2 && s->numbers[0] < s->numbers[1]) return {s->numbers[0], s->numbers[1]};
    wrong_.add(s->where + ": `" + key + "` is [lower, upper] or \"none\"");
    return {};
  }
  // Of an observation, or of all of them.
  std::string key_of(const std::string& name, const std::string& what) {
    const std::string own = "observation." + name + "." + what;
    return !said_.has(own) && said_.has("observations." + what) ? "observations." + what : own;
  }

  void joints(contract& c) {
    const statement* names = get("joints");
    const statement* ids = get("joint_ids");
    const statement* sdk = get("sdk_joints");
    if (ids && sdk && !motor_places(*ids, *sdk)) return;
    if (ids && sdk) {
      statement matched{{}, {}, ids->where + " with sdk_joints", 0};
      for (const double i : ids->numbers) matched.words.push_back(sdk->words[static_cast<std::size_t>(i)]);
      if (names) {
        for (std::size_t i = 0; i < std::max(names->words.size(), matched.words.size()); ++i)
          if (i >= names->words.size() || i >= matched.words.size() || names->words[i] != matched.words[i]) {
            wrong_.add("`joints` is said twice, and differs: joint " + std::to_string(i) + " is " +
                       (i < names->words.size() ? names->words[i] : "missing") + " (" + names->where +
                       ") and " + (i < matched.words.size() ? matched.words[i] : "missing") + " (" +
                       matched.where + ")");
            break;
          }
      }
      c.joints = matched.words;
    } else if (names && names->is_text()) {
      c.joints = names->words;
    } else {
      missing("joints",
              "the names of the joints in the policy's order" +
                  std::string(ids ? ", or `sdk_joints` in the order of the motors, for joint_ids_map" : ""));
    }
    std::set<std::string> once;
    for (const std::string& j : c.joints)
      if (!once.insert(j).second) wrong_.add("`joints` names " + j + " twice");
    for (const auto& [key, all] : said_.all())
      if (key.starts_with("joint.") && !once.empty() && !once.contains(parts_of(key, '.')[1]))
        wrong_.add(all.front().where + ": `" + key + "`: the policy has no joint of this name");
    for (const std::string& j : c.joints) {
      const std::string key = "joint." + j;
      const std::string* axis = text(key + ".axis", "");
      axes_.push_back(axis ? *axis : j);
      const double sign = said_.has(key + ".sign") ? one(key + ".sign", "") : 1;
      if (sign != 1 && sign != -1)
        wrong_.add(get(key + ".sign")->where + ": `" + key + ".sign` is " + text_of(sign) +
                   ": expected 1 or -1");
      signs_.push_back(sign < 0 ? -1 : 1);
    }
  }
  // An action that says nothing moves all joints in their order.
  void moved(contract& c) {
    const statement* ids = get("action.joint_ids");
    for (std::size_t i = 0; i < c.joints.size(); ++i) c.moved.push_back(i);
    if (!ids || c.joints.empty()) return;
    std::vector<std::size_t> order;
    std::set<std::size_t> left(c.moved.begin(), c.moved.end());
    for (const double id : ids->numbers) {
      if (!(id >= 0 && id < static_cast<double>(c.joints.size())) || id != std::floor(id))
        return wrong_.add(ids->where + ": an action moves joint " + text_of(id) +
                          ", and the joints are 0 to " + std::to_string(c.joints.size() - 1));
      order.push_back(static_cast<std::size_t>(id));
      if (left.erase(order.back()) == 0)
        return wrong_.add(ids->where + ": `joint_ids` has " + c.joints[order.back()] + " twice");
    }
    std::string still;
    for (const std::size_t i : left) still += (still.empty() ? "" : ", ") + c.joints[i];
    if (!still.empty())
      return wrong_.add(ids->where + ": no action moves " + still + ", and here all joints are moved");
    c.moved = order;
  }
  bool motor_places(const statement& ids, const statement& sdk) {
    for (const double i : ids.numbers)
      if (i < 0 || i >= static_cast<double>(sdk.words.size()) || i != std::floor(i)) {
        wrong_.add(ids.where + ": joint_ids_map has " + text_of(i) + ", and `sdk_joints` " +
                   std::to_string(sdk.words.size()) + " names");
        return false;
      }
    return true;
  }

  void gains(contract& c) {
    c.stiffness = gain(c, "stiffness");
    c.damping = gain(c, "damping");
    if (!has_gains_) return;
    const auto complain = [&](const char* key, const std::vector<double>& of, auto is_wrong, const char* unit,
                              const char* why) {
      std::string found;
      for (std::size_t i = 0; i < of.size(); ++i)
        if (is_wrong(of[i])) found += (found.empty() ? "" : ", ") + c.joints[i] + " " + text_of(of[i]);
      if (!found.empty()) wrong_.add("`" + std::string(key) + "` is " + why + ": " + found + unit);
    };
    complain(
        "stiffness", c.stiffness, [](double k) { return !(k > 0); },
        " N m/rad: it was baked in, and there the robot would hang", "zero or less");
    complain(
        "damping", c.damping, [](double d) { return !(d >= 0); },
        " N m s/rad: there the robot would swing itself up", "below zero");
  }
  std::vector<double> gain(const contract& c, const std::string& key) {
    const statement* motors = get("motor_" + key);
    const statement* ids = get("joint_ids");
    const std::string what = "of each joint, in the policy's order";
    if (!motors || !ids) {
      has_gains_ = has_gains_ && said_.has(key);
      return list(key, c.joints.size(), what);
    }
    std::vector<double> all;
    for (const double i : ids->numbers)
      if (i >= 0 && i < static_cast<double>(motors->numbers.size()))
        all.push_back(motors->numbers[static_cast<std::size_t>(i)]);
    all.resize(c.joints.size(), 0);
    if (said_.has(key)) {
      const auto own = list(key, c.joints.size(), what);
      for (std::size_t i = 0; i < all.size(); ++i)
        if (std::abs(own[i] - all[i]) > 1e-3 + 5.1e-3 * std::abs(all[i])) {
          wrong_.add("`" + key + "` is said twice, and differs: that of " + c.joints[i] + " is " +
                     text_of(own[i]) + " (" + get(key)->where + ") and " + text_of(all[i]) + " (" +
                     motors->where + ")");
          break;
        }
      return own;
    }
    return all;
  }

  // The numbers of a term over joints.
  void over_joints(const contract& c, term& t, bool from_default) {
    std::vector<double> rest(c.joints.size(), 0);
    if (from_default)
      rest = list("default_positions", c.joints.size(), "of each joint in rad, in the policy's order");
    if (from_default)
      for (std::size_t i = 0; i < rest.size(); ++i)
        if (std::abs(rest[i]) > 6.3 && !told_degrees_) {
          told_degrees_ = true;
          wrong_.add("`default_positions` of " + c.joints[i] + " is " + text_of(rest[i]) +
                     ": more than a turn; angles are in rad, and these look like degrees");
        }
    for (std::size_t i = 0; i < c.joints.size(); ++i)
      t.numbers.push_back({axes_[i], signs_[i] * rest[i] + 0.0, 1, signs_[i]});
  }

  void observations(contract& c) {
    const statement* order = get("observations");
    if (!order || !order->is_text())
      return missing("observations.order", "the names of the observations, as the network sees them");
    std::set<std::string> once(order->words.begin(), order->words.end());
    if (once.size() != order->words.size()) wrong_.add(order->where + ": an observation is named twice");
    for (const auto& [key, all] : said_.all())
      if (key.starts_with("observation.") && !once.contains(parts_of(key, '.')[1]))
        wrong_.add(all.front().where + ": `" + key + "`: the policy has no observation of this name");
    double history = 0;
    for (const std::string& name : order->words) {
      c.terms.push_back(observation(c, name));
      if (const std::string key = "observation." + name + ".history"; said_.has(key)) {
        const double own = one(key, "");
        if (history != 0 && own != history)
          wrong_.add("`" + key + "` is " + text_of(own) + ", and that of others is " + text_of(history) +
                     ": all have the same history here");
        history = own;
      }
    }
    if (said_.has("history.length")) {
      const double all = one("history.length", "");
      if (history != 0 && history != all)
        wrong_.add("`history.length` is " + text_of(all) + " (" + get("history.length")->where +
                   "), and the observations have a history of " + text_of(history));
      history = all;
    } else if (history == 0) {
      missing("history.length", "how many observations the network sees, 1 without a history");
    }
    if (history != std::floor(history) || history < 0 || history > 1000)
      wrong_.add("`history.length` is " + text_of(history) + ": expected a number from 1 to 1000");
    c.history = std::max(1, static_cast<int>(std::min(1000.0, std::max(0.0, history))));
    const bool has = c.history > 1;
    c.layout = choice("history.layout", {"by_term", "by_time"},
                      has ? "\"by_term\" (all of one term side by side) or \"by_time\"" : "");
    c.order = choice("history.order", {"oldest_first", "newest_first"},
                     has ? "\"oldest_first\" or \"newest_first\"" : "");
    c.start = choice("history.start", {"repeated", "zero"},
                     has ? "what stands before the first observation: \"repeated\" or \"zero\"" : "");
  }

  static bool has_frame(const std::string& is) { return is.ends_with('>') && is.find('<') != is.npos; }
  static bool needs_frame(const std::string& is) {
    for (const char* one : {"angular_velocity", "linear_acceleration", "orientation", "pose", "twist",
                            "wrench", "cartesian_position", "cartesian_force"})
      if (is == one) return true;
    return false;
  }

  term observation(const contract& c, const std::string& name) {
    term t;
    const std::string key = "observation." + name;
    t.name = name;
    const std::string* is = text(key + ".is",
                                 "the domain type with its frame, as angular_velocity<trunk>, joint_angles, "
                                 "number or last_action");
    if (!is) return t;
    t.is = *is;
    if (needs_frame(t.is))
      wrong_.add(get(key + ".is")->where + ": `" + key + ".is` lacks its frame: write " + t.is + "<FRAME>");
    const bool joints = t.is.starts_with("joint_");
    if (t.is == "last_action")
      for (const std::size_t i : c.moved) t.numbers.push_back({c.joints[i], 0, 1, 1});
    else if (joints && !said_.has(key + ".numbers")) {
      bool from_default = false;
      if (t.is == "joint_angles")
        from_default = choice(key + ".relative_to", {"zero", "default"},
                              "\"default\" (minus the default positions) or \"zero\"") == "default";
      over_joints(c, t, from_default);
    } else if (t.is.starts_with("orientation")) {
      const std::string order =
          choice(key + ".quaternion", {"wxyz", "xyzw"}, "the order of its numbers, \"wxyz\" or \"xyzw\"");
      for (const char n : order) t.numbers.push_back({std::string("q") + n, 0, 1, 1});
    } else if (const statement* s = get(key + ".numbers"); s && s->is_text()) {
      for (const std::string& n : s->words) t.numbers.push_back({n, 0, 1, 1});
    } else if (has_frame(t.is)) {
      for (const char* n : {"x", "y", "z"}) t.numbers.push_back({n, 0, 1, 1});
    } else {
      missing(key + ".numbers", "the names of its numbers, in its order");
    }
    const auto scale =
        list(key_of(name, "scale"), t.numbers.size(), "what its numbers are multiplied by, 1 for nothing");
    for (std::size_t i = 0; i < t.numbers.size(); ++i) t.numbers[i].scale = scale[i];
    check_scale(key, scale);
    t.clip = bounds(key_of(name, "clip"), "[lower, upper], or \"none\"");
    if (!t.clip.is_none())
      t.clips_scaled = choice(key_of(name, "clips"), {"before_scale", "after_scale"},
                              "\"before_scale\" or \"after_scale\"") == "after_scale";
    if (said_.has(key + ".seen")) t.seen = bounds(key + ".seen", "");
    return t;
  }
  void check_scale(const std::string& key, const std::vector<double>& scale) {
    for (const double s : scale) {
      if (s == 0 && said_.has(key + ".scale"))
        return wrong_.add("`" + key + ".scale` is 0: the network would see nothing");
      if (std::abs(s - 57.29577951308232) < 0.01 || std::abs(s - 0.017453292519943295) < 1e-5)
        return wrong_.add("`" + key + ".scale` is " + text_of(s) +
                          ", which turns rad and degrees into each other: spaces are in rad, and a policy "
                          "that sees degrees "
                          "needs numbers of a space of its own (`is = \"number\"`)");
    }
  }

  void action(contract& c) {
    const std::string* is = text("action.is", "the domain type of what the policy commands, as joint_angles");
    term& t = c.action;
    t.name = "action";
    if (is) t.is = *is;
    const std::string relative = choice("action.relative_to", {"zero", "default", "offset"},
                                        "\"default\" (plus the default positions), \"zero\" or \"offset\"");
    over_joints(c, t, relative == "default");
    const auto by_joint = t.numbers;
    for (std::size_t i = 0; i < c.moved.size(); ++i) t.numbers[i] = by_joint[c.moved[i]];
    if (said_.has("action.offset")) {
      const auto offset = list("action.offset", c.joints.size(), "");
      for (std::size_t i = 0; i < c.joints.size(); ++i) {
        number_of_term& n = t.numbers[i];
        if (relative != "offset" &&
            std::abs(offset[i] - n.sign * n.rest) > 1e-3 + 5.1e-3 * std::abs(offset[i])) {
          wrong_.add("the action's offset of " + c.joints[c.moved[i]] + " is " + text_of(offset[i]) + " (" +
                     get("action.offset")->where + "), and relative to " + relative + " it is " +
                     text_of(n.sign * n.rest));
          break;
        }
        if (relative == "offset") n.rest = n.sign * offset[i];
      }
    } else if (relative == "offset") {
      missing("action.offset", "of each joint");
    }
    const auto scale = list("action.scale", c.joints.size(), "of each joint");
    for (std::size_t i = 0; i < scale.size(); ++i) t.numbers[i].scale = scale[i];
    check_scale("action", scale);
    t.clip = bounds("action.clip", "of the network's numbers, [lower, upper] or \"none\"");
    if (said_.has("action.target_clip")) t.target_clip = bounds("action.target_clip", "");
    const bool asks = !t.clip.is_none() &&
                      std::ranges::any_of(c.terms, [](const term& o) { return o.is == "last_action"; });
    c.observes_clipped =
        choice("action.last_action", {"raw", "clipped"},
               asks ? "whether the last action is seen \"raw\" or \"clipped\"" : "") == "clipped";
  }

  const statements& said_;
  complaints& wrong_;
  std::vector<std::string> axes_;
  std::vector<int> signs_;
  bool has_gains_ = true, told_degrees_ = false;
};

}  // namespace cca_policy
