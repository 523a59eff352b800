#pragma once
// The walk in compiled physics, for main: a translation unit of its own, so both compile at once.

namespace walking {

int compiled_main(int count, char** words);

}  // namespace walking
