// cca-policy: from the ONNX file of a learned policy to its contract as types, and from a robot's types to a
// contract for the training. docs/policies.md; `cca-policy --help`.
#include <iostream>
#include <string>
#include <vector>

#include <cca/base/file.hpp>
#include <cca/main/one_file.hpp>
#include <cca/main/run_program.hpp>

#include "exchange.hpp"
#include "of_header.hpp"

namespace {

struct settings {
  std::vector<std::string> words;
  std::vector<std::string> includes;
  std::string deploy, map, out, weights, policy, at, compiler = CCA_COMPILE;
  bool in_double = false, python = false, quiet = false;
};

cca_policy::source_file read(const std::string& file) {
  if (file.empty()) return {};
  return {file, cca::detail::read_file(file)};
}

void write(const settings& s, const std::string& text) {
  if (s.out.empty()) std::cout << text;
  else cca::detail::write_file(s.out, text);
}

bool is_header(const std::string& file) {
  for (const char* end : {".hpp", ".h", ".hh", ".hxx"})
    if (file.ends_with(end)) return true;
  return false;
}

int contract_of_header(const settings& s, const std::string& file) {
  if (s.policy.empty())
    throw cca::command_line_error(
        file + " is a header: name the policy's type with --policy, or a graph's with --policy and --at");
  if (!s.deploy.empty() || !s.map.empty() || !s.weights.empty() || s.in_double)
    throw cca::command_line_error("--deploy, --map, --weights and --double belong to an ONNX file, and " +
                                  file + " is a header");
  if (!s.out.empty() && cca::is_one_file(s.out, file))
    throw cca::refused(s.out + ": it would be written over " + file +
                       ", which is read: give it its own name");
  const std::string json = cca_policy::contract_of_header({file, s.policy, s.at, s.compiler, s.includes});
  const std::string name = s.policy.substr(s.policy.rfind(':') + 1);
  write(s, s.python ? cca_policy::contract_python(name, file.substr(file.rfind('/') + 1), json) : json);
  if (!s.quiet && !s.out.empty())
    std::cerr << s.out << ": the contract of " << s.policy << " in " << file << "\n";
  return std::cout.flush() ? cca::exit_code::done : cca::exit_code::error;
}

int run(const settings& s) {
  const bool imports = s.words.size() == 2 && s.words[0] == "import";
  if (!imports && (s.words.size() != 2 || s.words[0] != "contract"))
    throw cca::command_line_error(
        "expected `import` or `contract`, and an ONNX file or a header; see --help");
  if (imports && s.python) throw cca::command_line_error("--python belongs to `contract`");
  const std::string& file = s.words[1];
  if (!imports && is_header(file)) return contract_of_header(s, file);
  if (!s.policy.empty() || !s.at.empty() || !s.includes.empty())
    throw cca::command_line_error("--policy, --at and --include belong to `contract` and a header");
  cca_policy::complaints wrong;
  std::vector<std::string> read_files{file, s.deploy, s.map};
  const auto beside = [&](const std::string& other) {
    read_files.push_back(file.substr(0, file.rfind('/') + 1) + other);
    return cca::detail::read_file(read_files.back());
  };
  cca_policy::imported p = cca_policy::import_policy(read(file), read(s.deploy), read(s.map), wrong, beside);
  p.in_double = s.in_double;
  for (const std::string& one : wrong.all()) std::cerr << file << ": " << one << "\n";
  if (!wrong.all().empty())
    throw cca::refused(file + ": " + (imports ? "no header" : "no contract") + " is written");
  const std::string weights = s.weights.empty() ? p.terms.name + ".policy" : s.weights;
  for (const std::string& other : {s.out, weights})
    for (const std::string& in : read_files)
      if (!other.empty() && !in.empty() && cca::is_one_file(other, in))
        throw cca::refused(other + ": it would be written over " + in +
                           ", which is read: give it its own name");
  if (imports) {
    cca::detail::write_file(weights, cca_policy::weights_file(p));
    write(s, cca_policy::header(p).text());
    if (!s.quiet)
      std::cerr << (s.out.empty() ? "standard output" : s.out) << ": " << cca_policy::summary(p) << weights
                << ": " << p.net.weights.size() << " weights, "
                << cca::detail::checksum_of(cca_policy::weights_text(p)) << "\n";
  } else {
    const std::string json = cca_policy::contract_json(p);
    write(s, s.python ? cca_policy::contract_python(p.terms.name, p.made_from, json) : json);
    if (!s.quiet && !s.out.empty()) std::cerr << s.out << ": " << cca_policy::summary(p);
  }
  return std::cout.flush() ? cca::exit_code::done : cca::exit_code::error;
}

}  // namespace

int main(int count, char** words) {
  settings s;
  cca::command_line line("writes the contract of a learned policy as types, and its weights");
  line.words("COMMAND FILE", s.words, 2,
             "`import` or `contract` (JSON), and the ONNX file; of `contract` also a header");
  line.text("--deploy FILE", s.deploy, "a deploy.yaml of unitree_rl_lab, or a configuration of rl_sar");
  line.text("--map FILE", s.map, "what these files do not say, in TOML");
  line.text("--out FILE", s.out, "the header or the contract (standard output)");
  line.text("--weights FILE", s.weights, "the weights (NAME.policy)");
  line.flag("--python", s.python, "`contract` writes a module of Python");
  line.text("--policy TYPE", s.policy, "of a header: the type of the policy, or of a graph with one");
  line.text("--at PATH", s.at, "the path of the policy's node in that graph");
  line.texts("--include DIR", s.includes, "where the header finds others");
  line.text("--compiler COMMAND", s.compiler, "compiles the header");
  line.flag("--quiet", s.quiet, "does not say what was written");
  line.flag("--double", s.in_double, "the network computes in double instead of float");
  return cca::run_program(count, words, line, [&] { return run(s); });
}
