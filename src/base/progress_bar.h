// A progress bar in the terminal.
#pragma once

#include "base/progress.h"

namespace macula {

// Draws on stderr, one line redrawn in place, only when stderr is a terminal; otherwise prints nothing.
Progress::Listener terminalProgressBar();

}  // namespace macula
