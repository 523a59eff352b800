// Recordings: everything that flows in a graph, in an MCAP file, and back. Needs the target cca::record.
// docs/recordings.md.
#pragma once

#include <cca/graph/marks/recordable.hpp>
#include <cca/record/mcap/reader.hpp>
#include <cca/record/mcap/writer.hpp>
#include <cca/record/page.hpp>
#include <cca/record/program_recording.hpp>
#include <cca/record/recorder.hpp>
#include <cca/record/replay.hpp>
