// The metadata that exporters write into an ONNX file: IsaacLab, mjlab, rsl_rl and their like.
#pragma once

#include "statements.hpp"

namespace cca_policy {

inline void read_metadata(const onnx_model& m, const std::string& file, statements& to, complaints& wrong) {
  const auto where = [&](const std::string& key) { return file + " (" + key + ")"; };
  const auto words = [&](const char* key, const char* as) {
    const auto found = m.metadata.find(key);
    if (found == m.metadata.end() || found->second.empty()) return;
    to.add(as, {{}, parts_of(found->second), where(key), 0});
  };
  const auto read = [&](const std::string& key, statement& s) {
    const auto found = m.metadata.find(key);
    if (found == m.metadata.end() || found->second.empty()) return false;
    s.where = where(key);
    s.rounding = 5.1e-4;
    for (const std::string& part : parts_of(found->second)) {
      const auto n = number_in(part);
      if (!n) {
        wrong.add(s.where + ": `" + part.substr(0, 40) + "` is no number");
        return false;
      }
      s.numbers.push_back(*n);
    }
    return true;
  };
  const auto numbers = [&](const char* key, const char* as) {
    if (statement s; read(key, s)) to.add(as, s);
  };
  words("joint_names", "joints");
  words("action_joint_names", "joints");
  words("observation_names", "observations");
  numbers("joint_stiffness", "stiffness");
  numbers("joint_damping", "damping");
  numbers("default_joint_pos", "default_positions");
  numbers("action_scale", "action.scale");
  numbers("joint_ids_map", "joint_ids");
  if (statement s; read("clip_actions", s)) {
    if (s.numbers.size() == 1) s.numbers = {-s.numbers[0], s.numbers[0]};
    to.add("action.clip", s);
  }
  if (statement s; read("observation_history_lengths", s))
    if (const auto names = m.metadata.find("observation_names"); names != m.metadata.end()) {
      const auto all = parts_of(names->second);
      if (all.size() != s.numbers.size())
        wrong.add(s.where + ": it has " + std::to_string(s.numbers.size()) + " numbers for " +
                  std::to_string(all.size()) + " observations");
      else
        for (std::size_t i = 0; i < all.size(); ++i)  // 0 means no history, as 1 does
          to.add("observation." + all[i] + ".history", {{std::max(1.0, s.numbers[i])}, {}, s.where, 0});
    }
  statement step, decimation;
  if (read("sim_dt", step) && read("decimation", decimation) && step.numbers.size() == 1 &&
      decimation.numbers.size() == 1 && step.numbers[0] * decimation.numbers[0] > 0)
    to.add("rate", {{1 / (step.numbers[0] * decimation.numbers[0])}, {}, where("sim_dt, decimation"), 1e-3});
  if (const auto found = m.metadata.find("normalizer_embedded"); found != m.metadata.end()) {
    const std::string& said = found->second;
    const bool yes = said == "True" || said == "true" || said == "1";
    to.add("network.normaliser", {{}, {yes ? "inside" : "outside"}, where("normalizer_embedded"), 0});
  }
}

}  // namespace cca_policy
