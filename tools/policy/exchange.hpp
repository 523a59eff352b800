// The contract as JSON and as a module of Python, for the program that trains.
#pragma once

#include "writing.hpp"

namespace cca_policy {

// JSON, which is also Python where no value is null, true or false.
inline std::string contract_json(const imported& p) {
  const contract& c = p.terms;
  const auto list = [](const auto& all, const auto& text) {
    std::string written;
    for (const auto& one : all) written += (written.empty() ? "[" : ", ") + text(one);
    return written.empty() ? std::string("[]") : written + "]";
  };
  const auto names = [&](const std::vector<std::string>& all) { return list(all, quoted); };
  const auto reals = [&](const std::vector<double>& all) { return list(all, text_of); };
  const auto bounds = [&](const range& r) {
    return r.is_none() ? std::string("[]") : reals({r.lower, r.upper});
  };
  const auto term_text = [&](const term& t) {
    const auto of = [&](auto member) {
      return list(t.numbers, [&](const number_of_term& n) { return text_of(n.*member); });
    };
    return "{\"name\": " + quoted(t.name) + ", \"is\": " + quoted(t.is) +
           ", \"numbers\": " + list(t.numbers, [](const number_of_term& n) { return quoted(n.name); }) +
           ",\n     \"rest\": " + of(&number_of_term::rest) + ", \"scale\": " + of(&number_of_term::scale) +
           ", \"sign\": " + list(t.numbers, [](const number_of_term& n) { return std::to_string(n.sign); }) +
           ",\n     \"clip\": " + bounds(t.clip) +
           ", \"clips\": " + quoted(t.clips_scaled ? "after_scale" : "before_scale") +
           ", \"target_clip\": " + bounds(t.target_clip) + "}";
  };
  std::string terms;
  for (const term& t : c.terms) terms += (terms.empty() ? "" : ",\n    ") + term_text(t);
  return "{\n  \"name\": " + quoted(c.name) + ",\n  \"rate\": " + text_of(c.rate) +
         ",\n  \"joints\": " + names(c.joints) + ",\n  \"stiffness\": " + reals(c.stiffness) +
         ",\n  \"damping\": " + reals(c.damping) +
         ",\n  \"history\": {\"length\": " + std::to_string(c.history) + ", \"layout\": " + quoted(c.layout) +
         ", \"order\": " + quoted(c.order) + ", \"start\": " + quoted(c.start) +
         "},\n  \"observations\": [\n    " + terms + "],\n  \"action\": " + term_text(c.action) +
         ",\n  \"last_action\": " + quoted(c.observes_clipped ? "clipped" : "raw") +
         ",\n  \"inputs\": " + std::to_string(p.net.inputs) +
         ",\n  \"outputs\": " + std::to_string(p.net.outputs) + "\n}\n";
}

inline std::string contract_python(const imported& p) {
  return "\"\"\"The contract of the policy '" + p.terms.name + "', from " + p.made_from +
         " by cca-policy. A term's number is sign * (q - rest), clipped, times scale.\"\"\"\n\nCONTRACT = " +
         contract_json(p) +
         "\nJOINTS = CONTRACT[\"joints\"]\nOBSERVATIONS = [one[\"name\"] for one in "
         "CONTRACT[\"observations\"]]\n"
         "RATE = CONTRACT[\"rate\"]  # Hz\n";
}

}  // namespace cca_policy
