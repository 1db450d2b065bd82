// What is drawn with a volume or left out of it by segments, as options of the verbs that draw a study: the
// same names and words in each.
#pragma once

#include <CLI/App.hpp>

#include "pictures/addition_request.h"

namespace macula::cli {

// --segments, --second and what is said of it. `request` must outlive the parsing.
void addAdditions(CLI::App& command, pictures::AdditionRequest& request);

}  // namespace macula::cli
