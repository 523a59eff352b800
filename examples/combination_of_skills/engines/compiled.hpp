#pragma once
// The Combination of Skills in compiled physics, for main: a translation unit of its own, so both compile at
// once.

namespace skills {

int compiled_main(int count, char** words);

}  // namespace skills
