// An import: files to a contract and a network, or to complaints.
#pragma once

#include "../urdf/names.hpp"
#include "contract.hpp"
#include "deploy.hpp"
#include "exporters.hpp"
#include "map.hpp"
#include "network_of.hpp"

namespace cca_policy {

struct source_file {
  std::string name, text;  // no name: there is none
};

struct imported {
  contract terms;
  network net;
  std::string made_from;
  bool in_double = false;
};

// C's headers declare it as a function, so no namespace can have the name.
inline bool is_declared(const std::string& id) {
  static const std::set<std::string> functions{
      "sin",   "cos",   "tan",  "asin",  "acos", "atan", "atan2", "sinh",  "cosh", "tanh",   "asinh", "acosh",
      "atanh", "exp",   "exp2", "expm1", "log",  "log2", "log10", "log1p", "pow",  "sqrt",   "cbrt",  "hypot",
      "erf",   "floor", "ceil", "round", "abs",  "div",  "gamma", "jn",    "yn",   "signal", "main"};
  return functions.contains(id) || cca_urdf::is_global(id);
}

// A name of C++ from that of a file.
inline std::string name_from(const std::string& file) {
  const std::string base = file.substr(file.rfind('/') + 1);
  const std::string id = cca_urdf::identifier_of(base.substr(0, base.find('.')));
  return is_declared(id) ? id + "_policy" : id;
}

// Throws cca::refused for a file that cannot be read; what is missing or differs goes to `wrong`. `beside`
// gives the text of another file in the folder of the ONNX file, where its weights may lie.
inline imported import_policy(const source_file& onnx,
                              const source_file& deploy,
                              const source_file& map,
                              complaints& wrong,
                              std::function<std::string(const std::string&)> beside = {}) {
  const auto base = [](const std::string& file) { return file.substr(file.rfind('/') + 1); };
  imported r;
  statements said;
  onnx_model model;
  try {
    model = read_onnx(onnx.text, std::move(beside));
    read_metadata(model, base(onnx.name), said, wrong);
  } catch (const cca::refused& e) { refuse(onnx.name + ": " + e.what()); }
  if (!deploy.name.empty()) deploy_reader(deploy.text, base(deploy.name), said, wrong);
  if (!map.name.empty()) map_reader(map.text, base(map.name), said, wrong);

  network_options how;
  const auto word = [&](const char* key) {
    const statement* s = said.get(key, wrong);
    return s && s->words.size() == 1 ? s->words[0] : std::string();
  };
  how.observations = word("network.observations");
  how.actions = word("network.actions");
  if (word("network.normaliser") == "outside") {
    if (const statement* s = said.get("network.mean", wrong)) how.mean = s->numbers;
    if (const statement* s = said.get("network.deviation", wrong)) how.deviation = s->numbers;
  }
  for (const auto& [key, all] : said.all())
    if (key.starts_with("memory.") && all.front().words.size() == 1)
      how.memory.push_back({key.substr(7), all.front().words[0]});
  try {
    r.net = lowering(model, how).run();
  } catch (const cca::refused& e) { refuse(onnx.name + ": " + e.what()); }
  r.made_from = base(onnx.name) + (deploy.name.empty() ? "" : ", " + base(deploy.name)) +
                (map.name.empty() ? "" : ", " + base(map.name));
  resolver rules(said, wrong);
  r.terms = rules.all(name_from(onnx.name));
  if (!cca_urdf::is_namespace(r.terms.name) || is_declared(r.terms.name) ||
      r.terms.name.find(':') != std::string::npos)
    wrong.add("`name` is " + r.terms.name + ": expected a name of C++ that C does not declare");
  if (wrong.all().empty()) rules.compare(r.terms, r.net);
  rules.compare_normaliser(r.net);
  return r;
}

}  // namespace cca_policy
