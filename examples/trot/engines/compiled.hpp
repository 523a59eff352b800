#pragma once
// The trot in compiled physics, for main: a translation unit of its own, so both compile at once.

namespace trot {

int compiled_main(int count, char** words);

}  // namespace trot
