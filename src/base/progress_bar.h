// Progress on stderr, for a terminal or a file.
#pragma once

#include <string>

#include "base/progress.h"

namespace macula {

// On a terminal the bar redraws one line, at most as wide as the terminal. Elsewhere, and on a terminal that
// understands no control characters (TERM=dumb), it prints a line every ten seconds.
Progress::Listener terminalProgressBar();

// Clears an unfinished bar, so that other output can take its line.
void clearProgressBar();

// The text of a bar that is `columns` wide; `secondsLeft` below 0 means unknown. If space is short, the stage
// is cut first.
std::string progressLine(const ProgressUpdate& update, double secondsLeft, int columns);

}  // namespace macula
