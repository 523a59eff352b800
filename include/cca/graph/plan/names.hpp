// Finds ports by path in one open-addressing table of hashes. The hash of a path continues the hash of its
// scope.
#pragma once

#include <cstdint>
#include <string_view>

#include <cca/graph/plan/flat.hpp>

namespace cca::detail {

// One table holds inputs, outputs and nodes; a different salt for each keeps them apart.
inline constexpr std::uint64_t as_input = 0x9e3779b97f4a7c15ull, as_output = 0xc2b2ae3d27d4eb4full,
                               as_node = 0;

struct name_table {
  table_entry* entries = nullptr;
  std::uint64_t mask = 0;

  constexpr void insert(std::uint64_t key, int index) {
    auto at = key & mask;
    while (entries[at].index >= 0) at = (at + 1) & mask;
    entries[at] = {key, index};
  }
  // Returns false and adds nothing if the key exists.
  constexpr bool add(std::uint64_t key, int index) {
    auto at = key & mask;
    for (; entries[at].index >= 0; at = (at + 1) & mask)
      if (entries[at].hash == key) return false;
    entries[at] = {key, index};
    return true;
  }
};

// Visits all entries of one key.
struct name_search {
  const table_entry* entries;
  std::uint64_t mask, key, at;

  constexpr name_search(const table_entry* table, std::uint64_t table_mask, std::uint64_t wanted)
      : entries(table), mask(table_mask), key(wanted), at(wanted & table_mask) {}

  constexpr int next() {
    while (entries[at].index >= 0) {
      const auto& entry = entries[at];
      at = (at + 1) & mask;
      if (entry.hash == key) return entry.index;
    }
    return -1;
  }
};

constexpr int find(const table_entry* entries, std::uint64_t mask, std::uint64_t key) {
  return name_search(entries, mask, key).next();
}

constexpr std::uint64_t table_size(int entries) {
  std::uint64_t size = 16;
  while (size < 2u * static_cast<unsigned>(entries)) size *= 2;
  return size;
}

// The hash of a path: `name` begins in the scope, the hash is that of the path from the outermost graph.
constexpr std::uint64_t path_hash(const scope& from, std::string_view name, std::uint64_t in_outermost) {
  return from.parent < 0 ? in_outermost : hash(name, after_dot(from.hash));
}

// Dots join names to paths, and `*` stands for any name.
constexpr bool is_name(std::string_view name) {
  for (const char c : name)
    if (c == '.' || c == '*') return false;
  return !name.empty();
}

// A wire names `node.port`, where the node is one of its own graph.
constexpr bool names_port(std::string_view path) {
  int dots = 0;
  for (const char c : path) dots += c == '.';
  return dots == 1;
}

}  // namespace cca::detail
