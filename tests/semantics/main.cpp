// Runs all architectures that generate.py made, or only those whose seeds are arguments, and then prints all
// differences. With --proof it also fails if something was not exercised or a mutant was not caught.
#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "compare.hpp"

int main(int count, char** arguments) {
  using namespace semantics;
  auto all = registered::all();
  std::sort(all.begin(), all.end(),
            [](const registered* a, const registered* b) { return a->seed < b->seed; });
  std::vector<std::string> wanted(arguments + 1, arguments + count);
  const bool as_proof = std::erase(wanted, "--proof") > 0;
  comparison c;
  int copy_at = 0;
  for (const registered* one : all) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), std::to_string(one->seed)) == wanted.end())
      continue;
    copy_at = (copy_at + 37) % beats;
    c.add(one->text, one->run(copy_at), beats);
  }
  return c.report(as_proof) ? 0 : 1;
}
