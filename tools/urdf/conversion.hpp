// The whole way: the text of a URDF file in, the text of a header out, or what speaks against it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cylinders.hpp"
#include "locked.hpp"
#include "masses.hpp"
#include "reading.hpp"
#include "writing.hpp"

namespace cca_urdf {

struct options {
  header_options header{};
  bool floats = false;              // nothing holds the base
  bool strict = false;              // notes are errors
  bool accept_inertia = false;      // the nearest sound one becomes of one that no body has
  std::vector<std::string> ends{};  // links in which a part ends
};

struct conversion {
  std::string header;  // empty: refused
  std::vector<remark> said;
};

inline conversion convert(std::string_view text, const options& wanted) {
  remarks said;
  const auto end = [&](std::string header) { return conversion{std::move(header), said.sorted()}; };
  robot r = read_robot(text, said);
  if (r.name.empty() || (r.links.empty() && said.has_error())) return end({});
  lock_joints(r, said);
  const structure tree(r, said);
  if (tree.root() < 0) return end({});
  bodies moving(r, tree, wanted.floats, said);
  check_masses(moving, wanted.accept_inertia, said);
  replace_cylinders(r, moving, said);
  const followers coupled(r, said);
  if (said.has_error()) return end({});
  const limbs parts(moving, wanted.ends, said);
  if (said.has_error()) return end({});
  const header written(r, parts, coupled, wanted.header, said);
  if (wanted.strict && said.has_note()) return end({});
  return end(written.text(said.sorted()));
}

}  // namespace cca_urdf
