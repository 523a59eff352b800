// cca-policy: from the ONNX file of a learned policy to its contract as types. docs/policies.md;
// `cca-policy --help`.
#include <iostream>
#include <string>
#include <vector>

#include <cca/base/file.hpp>
#include <cca/main/one_file.hpp>
#include <cca/main/run_program.hpp>

#include "exchange.hpp"

namespace {

struct settings {
  std::vector<std::string> words;
  std::string deploy, map, out, weights;
  bool in_double = false, python = false;
};

cca_policy::source_file read(const std::string& file) {
  if (file.empty()) return {};
  return {file, cca::detail::read_file(file)};
}

void write(const settings& s, const std::string& text) {
  if (s.out.empty()) std::cout << text;
  else cca::detail::write_file(s.out, text);
}

int run(const settings& s) {
  const bool imports = s.words.size() == 2 && s.words[0] == "import";
  if (!imports && (s.words.size() != 2 || s.words[0] != "contract"))
    throw cca::command_line_error("expected `import` or `contract`, and an ONNX file; see --help");
  if (imports && s.python) throw cca::command_line_error("--python belongs to `contract`");
  const std::string& file = s.words[1];
  cca_policy::complaints wrong;
  cca_policy::imported p = cca_policy::import_policy(read(file), read(s.deploy), read(s.map), wrong);
  p.in_double = s.in_double;
  for (const std::string& one : wrong.all()) std::cerr << file << ": " << one << "\n";
  if (!wrong.all().empty())
    throw cca::refused(file + ": " + (imports ? "no header" : "no contract") + " is written");
  const std::string weights = s.weights.empty() ? p.terms.name + ".policy" : s.weights;
  for (const std::string& other : {s.out, weights})
    for (const std::string& in : {file, s.deploy, s.map})
      if (!other.empty() && !in.empty() && cca::is_one_file(other, in))
        throw cca::refused(other + ": it would be written over " + in +
                           ", which is read: give it its own name");
  if (imports) {
    cca::detail::write_file(weights, cca_policy::weights_file(p));
    write(s, cca_policy::header(p).text());
  } else {
    write(s, s.python ? cca_policy::contract_python(p) : cca_policy::contract_json(p));
  }
  return std::cout.flush() ? cca::exit_code::done : cca::exit_code::error;
}

}  // namespace

int main(int count, char** words) {
  settings s;
  cca::command_line line("writes the contract of a learned policy as types, and its weights");
  line.words("COMMAND FILE", s.words, 2, "`import` or `contract` (JSON), and the ONNX file");
  line.text("--deploy FILE", s.deploy, "a deploy.yaml of unitree_rl_lab, or a configuration of rl_sar");
  line.text("--map FILE", s.map, "what these files do not say, in TOML");
  line.text("--out FILE", s.out, "the header or the contract (standard output)");
  line.text("--weights FILE", s.weights, "the weights (NAME.policy)");
  line.flag("--python", s.python, "`contract` writes a module of Python");
  line.flag("--double", s.in_double, "the network computes in double instead of float");
  return cca::run_program(count, words, line, [&] { return run(s); });
}
