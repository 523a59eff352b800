// What the target cca::record compiles once for a project: cca/base/separate/compiled.hpp.
#include <cca/record/mcap/reader_functions.hpp>
#include <cca/record/mcap/writer_functions.hpp>
#include <cca/record/messages/body_transforms_functions.hpp>
#include <cca/record/messages/parameter_message_functions.hpp>
#include <cca/record/messages/sample_message_functions.hpp>
#include <cca/record/messages/urdf_functions.hpp>
#include <cca/record/messages/viewer_message_functions.hpp>
#include <cca/record/page_functions.hpp>
#include <cca/record/replay/architecture_difference_functions.hpp>
#include <cca/record/replay/parameter_difference_functions.hpp>
