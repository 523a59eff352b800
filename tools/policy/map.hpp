// map.toml: what the other files do not say. Each key is a statement; an unknown key is refused with the
// nearest one that exists. docs/policies.md lists them.
#pragma once

#include <toml++/toml.h>

#include "statements.hpp"

namespace cca_policy {

// A `*` stands for a name.
inline constexpr std::string_view map_keys[] = {"name",
                                                "rate",
                                                "joints",
                                                "sdk_joints",
                                                "default_positions",
                                                "stiffness",
                                                "damping",
                                                "oldest",
                                                "joint.*.axis",
                                                "joint.*.sign",
                                                "history.length",
                                                "history.layout",
                                                "history.order",
                                                "history.start",
                                                "observations.order",
                                                "observations.scale",
                                                "observations.clip",
                                                "observations.clips",
                                                "observation.*.is",
                                                "observation.*.numbers",
                                                "observation.*.quaternion",
                                                "observation.*.relative_to",
                                                "observation.*.scale",
                                                "observation.*.clip",
                                                "observation.*.clips",
                                                "observation.*.seen",
                                                "observation.*.history",
                                                "action.is",
                                                "action.relative_to",
                                                "action.scale",
                                                "action.offset",
                                                "action.clip",
                                                "action.target_clip",
                                                "action.last_action",
                                                "network.normaliser",
                                                "network.mean",
                                                "network.deviation",
                                                "network.observations",
                                                "network.actions",
                                                "memory.*"};

inline bool fits(std::string_view key, std::string_view pattern) {
  while (true) {
    const auto end = key.find('.'), until = pattern.find('.');
    if (pattern.substr(0, until) != "*" && key.substr(0, end) != pattern.substr(0, until)) return false;
    if (end == key.npos || until == pattern.npos) return end == key.npos && until == pattern.npos;
    key.remove_prefix(end + 1);
    pattern.remove_prefix(until + 1);
  }
}

inline std::string nearest_key(const std::string& key) {
  std::string best;
  std::size_t least = 1000;
  for (const std::string_view pattern : map_keys) {
    std::string with_name(pattern);  // the name of the key in place of the star
    if (const auto star = with_name.find('*'); star != with_name.npos) {
      const auto parts = parts_of(key, '.');
      if (parts.size() < 2) continue;
      with_name.replace(star, 1, parts[1]);
    }
    std::vector<std::size_t> row(with_name.size() + 1);  // Levenshtein
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = i;
    for (std::size_t i = 0; i < key.size(); ++i) {
      std::size_t diagonal = row[0]++;
      for (std::size_t j = 0; j < with_name.size(); ++j) {
        const std::size_t here = std::min({row[j] + 1, row[j + 1] + 1, diagonal + (key[i] != with_name[j])});
        diagonal = row[j + 1];
        row[j + 1] = here;
      }
    }
    if (row.back() < least) {
      least = row.back();
      best = with_name;
    }
  }
  return best;
}

class map_reader {
public:
  map_reader(std::string_view text, const std::string& file, statements& to, complaints& wrong)
      : file_(file), to_(to), wrong_(wrong) {
    try {
      const toml::table root = toml::parse(text, std::string_view(file));
      read(root, "");
    } catch (const toml::parse_error& e) {
      refuse(file + ":" + std::to_string(e.source().begin.line) +
             ": it is no TOML: " + std::string(e.description()));
    }
  }

private:
  void read(const toml::table& table, const std::string& path) {
    for (const auto& [name, node] : table) {
      const std::string key = path.empty() ? std::string(name.str()) : path + "." + std::string(name.str());
      if (const auto* inner = node.as_table()) {
        read(*inner, key);
        continue;
      }
      statement s;
      s.where = file_ + ":" + std::to_string(node.source().begin.line);
      if (std::ranges::none_of(map_keys, [&](std::string_view p) { return fits(key, p); })) {
        const std::string last(name.str());  // below a table it belongs to the table
        const bool is_above = !path.empty() && std::ranges::find(map_keys, last) != std::end(map_keys);
        wrong_.add(s.where + ": there is no key `" + key + "`; " +
                   (is_above ? "`" + last + "` stands above the first [...] of the file"
                             : "is it `" + nearest_key(key) + "`?"));
        continue;
      }
      bool is_sound = true;
      if (const auto* list = node.as_array()) {
        for (const auto& item : *list) is_sound = is_sound && add(item, s);
        is_sound = is_sound && !list->empty();
      } else is_sound = add(node, s);
      if (is_empty_text(node))
        wrong_.add(s.where + ": `" + key + "` is an empty text: write one, or leave out the key");
      else if (!is_sound || (!s.words.empty() && !s.numbers.empty()))
        wrong_.add(s.where + ": `" + key + "` is neither numbers nor texts");
      else to_.add(key == "observations.order" ? "observations" : key, s);
    }
  }
  static bool is_empty_text(const toml::node& node) {
    if (const auto* list = node.as_array()) return std::ranges::any_of(*list, is_empty_text);
    const auto text = node.value<std::string>();
    return node.is_string() && text && text->empty();
  }
  static bool add(const toml::node& node, statement& s) {
    if (const auto number = node.value<double>(); number && node.is_number()) {
      if (!std::isfinite(*number)) return false;
      s.numbers.push_back(*number);
      return true;
    }
    if (const auto text = node.value<std::string>(); text && node.is_string() && !text->empty()) {
      s.words.push_back(*text);
      return true;
    }
    return false;
  }

  std::string file_;
  statements& to_;
  complaints& wrong_;
};

}  // namespace cca_policy
