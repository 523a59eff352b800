// The contract of a policy in a header of C++: a small program that includes the header is compiled and run.
// No text of C++ is read here, so whatever a compiler takes is right.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <cca/base/file.hpp>
#include <cca/base/refused.hpp>

namespace cca_policy {

struct header_of_policy {
  std::string file;
  std::string policy;    // its type, or that of the graph
  std::string at;        // the path of its node in the graph; empty: `policy` is its type
  std::string compiler;  // and its options
  std::vector<std::string> includes;
};

inline std::string shell_quoted(const std::string& text) {
  std::string all = "'";
  for (const char c : text) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return all + "'";
}

inline std::string program_of(const header_of_policy& h) {
  const std::string name = h.policy.substr(h.policy.rfind(':') + 1);
  std::string all = "#include \"" + std::filesystem::absolute(h.file).string() +
                    "\"\n\n#include <iostream>\n#include <type_traits>\n#include <utility>\n\n#include "
                    "<cca/cca.hpp>\n#include <cca/mapping/imported/policy_description.hpp>\n\n";
  if (h.at.empty()) all += "using policy = " + h.policy + ";\n";
  else
    all += "using graph = " + h.policy +
           ";\nusing policy = std::remove_cvref_t<decltype(std::declval<cca::controller<graph>&>().get<\"" +
           h.at + "\">())>;\n";
  return all + "\nint main() { std::cout << cca::json_of(cca::describe_policy<policy>(\"" + name +
         "\")); }\n";
}

// JSON. Throws cca::refused; what the compiler says goes where it always goes.
inline std::string contract_of_header(const header_of_policy& h) {
  namespace fs = std::filesystem;
  if (!fs::exists(h.file)) throw cca::refused(h.file + ": there is no such file");
  struct folder {
    fs::path path;
    folder() {
      std::string name = (fs::temp_directory_path() / "cca-policy-XXXXXX").string();
      if (!mkdtemp(name.data())) throw cca::refused("cca-policy: no temporary folder can be made");
      path = name;
    }
    ~folder() {
      std::error_code ignored;
      fs::remove_all(path, ignored);
    }
  } const work;
  const fs::path source = work.path / "contract.cpp", program = work.path / "contract",
                 json = work.path / "contract.json";
  cca::detail::write_file(source.string(), program_of(h));
  std::string compile = h.compiler;
  for (const std::string& one : h.includes) compile += " -I" + shell_quoted(one);
  compile += " " + shell_quoted(source.string()) + " -o " + shell_quoted(program.string());
  if (std::system(compile.c_str()) != 0)
    throw cca::refused(
        h.file +
        ": no contract is written, because this program of it does not compile; --policy names the "
        "type of a policy or, with --at, of a graph, and --compiler what to compile with:\n" +
        program_of(h));
  if (std::system((shell_quoted(program.string()) + " > " + shell_quoted(json.string())).c_str()) != 0)
    throw cca::refused(h.file + ": no contract is written, because the program of it failed");
  return cca::detail::read_file(json.string());
}

}  // namespace cca_policy
