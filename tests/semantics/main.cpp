// Runs all architectures that generate.py made, or only those whose seeds are arguments, and then prints all
// differences. With --proof, --proof-of-environments or --proof-of-modes it also fails if something was not
// exercised or a mutant was not caught.
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
  auto proof = comparison::proof::none;
  if (std::erase(wanted, "--proof") > 0) proof = comparison::proof::of_all;
  if (std::erase(wanted, "--proof-of-environments") > 0) proof = comparison::proof::of_environments;
  if (std::erase(wanted, "--proof-of-modes") > 0) proof = comparison::proof::of_modes;
  comparison c;
  for (const registered* one : all) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), std::to_string(one->seed)) == wanted.end())
      continue;
    c.add(one->text, one->run(one->seed * 37 % beats), beats);  // the same alone as among others
  }
  return c.report(proof) ? 0 : 1;
}
