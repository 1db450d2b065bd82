// Ctrl-C asks a long job to stop, so that it can clean up; a second one ends the program at once.
#pragma once

#include "base/progress.h"

namespace macula::cli {

// Cancelled by SIGINT, SIGTERM or SIGHUP. Installs the handlers on the first call.
const CancelToken& interruptToken();

}  // namespace macula::cli
