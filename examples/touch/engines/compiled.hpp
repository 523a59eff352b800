#pragma once
// The arm in compiled physics, for main: a translation unit of its own, so both compile at once.

namespace touch {

int compiled_main(int count, char** words);

}  // namespace touch
