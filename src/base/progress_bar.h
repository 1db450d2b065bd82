// Progress in the terminal, or in what stderr goes to.
#pragma once

#include <string>

#include "base/progress.h"

namespace macula {

// On a terminal one line redrawn in place, as wide as that is at most. Elsewhere, and on one that understands
// no control characters (TERM=dumb), a line every ten seconds.
Progress::Listener terminalProgressBar();

// Makes room for a line in the place of a bar that has not come to its end.
void clearProgressBar();

// What a bar shows in so many columns; `secondsLeft` below 0 is not known. The stage is shortened first.
std::string progressLine(const ProgressUpdate& update, double secondsLeft, int columns);

}  // namespace macula
