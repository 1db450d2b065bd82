// Questions to whoever sits at the terminal.
#pragma once

#include <string_view>

#include "base/result.h"

namespace macula::cli {

// Whether somebody can read a question and answer it: standard input and stderr are a terminal.
bool canAsk();

// True for "y" and "yes"; false for all else, and for no answer. Fails with cancelled when the program is
// told to stop meanwhile.
Result<bool> ask(std::string_view question);

}  // namespace macula::cli
