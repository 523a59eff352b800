// The random architectures: what the library did and what the interpreter does, firing by firing, bit for
// bit.
#include <iostream>
#include <string>

#include "compare.hpp"

namespace semantics {

// The place of the first difference, or -1.
long difference(const log& a, const log& b) {
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i)
    if (i >= a.size() || i >= b.size() || !same(a[i], b[i])) return static_cast<long>(i);
  return -1;
}

std::unique_ptr<interpreter> interpreted(std::unique_ptr<interpreter> i, int count) {
  for (int k = 0; k < count; ++k) i->beat();
  return i;
}

std::unique_ptr<interpreter> interpreted(const graph& g, int count) {
  return interpreted(std::make_unique<interpreter>(g), count);
}

void comparison::add(const std::string& text, const outcome& o, int count) {
  const graph g = described(text);
  const auto i = interpreted(g, count);
  seen.add(*i);
  if (o.is_merged) i->firings = merged(i->firings);
  const long at = difference(o.firings, i->firings);
  if (at >= 0 || o.faulted != i->faulted || !o.copy_agrees || !o.processes_agree) {
    ++differences;
    if (differences <= 5) tell(text, o, *i, at);
    return;
  }
  for (std::size_t m = 0; m < all_mutants.size(); ++m) {
    if (caught_in[m] != 0) continue;
    const auto wrong = interpreted(all_mutants[m].made(g), count);
    if (o.is_merged) wrong->firings = merged(wrong->firings);
    if (difference(o.firings, wrong->firings) >= 0 || o.faulted != wrong->faulted)
      caught_in[m] = seen.architectures;
  }
}

void comparison::tell(const std::string& text, const outcome& o, const interpreter& i, long at) {
  std::cout << "\n---- a difference ----\n" << text;
  if (!o.copy_agrees)
    std::cout << (o.is_merged ? "stopped, started and resumed it did not do what the controller does\n"
                              : "a copy of the controller did not go on like the original\n");
  if (!o.processes_agree) std::cout << "in processes it did something else\n";
  if (o.faulted != i.faulted)
    std::cout << "the library " << (o.faulted ? "faulted" : "did not fault") << ", the interpreter did"
              << (i.faulted ? "" : " not") << '\n';
  if (at < 0) return;
  const auto place = static_cast<std::size_t>(at);
  for (std::size_t before = place > 6 ? place - 6 : 0; before < place; ++before)
    std::cout << o.firings[before] << '\n';
  std::cout << "firing " << at << "\n  the library:     ";
  if (place < o.firings.size()) std::cout << o.firings[place];
  else std::cout << "nothing more";
  std::cout << "\n  the interpreter: ";
  if (place < i.firings.size()) std::cout << i.firings[place];
  else std::cout << "nothing more";
  std::cout << '\n';
}

namespace {

// Of modes: also delays and what is asked for from outside.
bool is_about(const std::string& mistake, comparison::proof wanted) {
  const auto has = [&](const char* word) { return mistake.find(word) != std::string::npos; };
  if (wanted == comparison::proof::of_modes) return has("modes: ") || has("from outside") || has("a program");
  if (has("modes: ")) return false;
  return wanted != comparison::proof::of_environments || has("delayed") || has("from outside") ||
         has("a program");
}

}  // namespace

bool comparison::report(proof wanted) const {
  std::cout << "\nWhat was exercised:\n";
  const bool all_exercised = wanted == proof::of_environments
                                 ? seen.report(std::cout, coverage::wanted_of_environments)
                             : wanted == proof::of_modes ? seen.report(std::cout, coverage::wanted_of_modes)
                                                         : seen.report(std::cout);
  std::cout << "\nMutants, and the architecture that caught each:\n";
  bool all_caught = true;
  for (std::size_t m = 0; m < all_mutants.size(); ++m) {
    const std::string mistake = all_mutants[m].mistake;
    if (wanted != proof::none && !is_about(mistake, wanted)) continue;
    std::cout << std::setw(9) << caught_in[m] << "  " << mistake << (caught_in[m] ? "" : "   <- not caught")
              << '\n';
    all_caught = all_caught && caught_in[m];
  }
  std::cout << '\n'
            << seen.architectures << " architectures, " << seen.firings << " firings, " << seen.samples
            << " samples compared, " << differences << " differences\n";
  // A few architectures are for trying something out: they can't exercise everything.
  if (wanted == proof::none) std::cout << "no proof: what was not exercised or not caught is no failure\n";
  return differences == 0 && (wanted == proof::none || (all_exercised && all_caught));
}

}  // namespace semantics
