// Plug-ins: shared libraries of Macula that are loaded when they are needed (dlopen), because they depend on
// many others. A program that does without them starts at once.
#pragma once

#include "base/result.h"

namespace macula {

// Returns what the plug-in `name` (without ".so"), made by the same build, exports under `symbol`. Looks
// beside the program or library that this code is part of, and then in the folder where plug-ins are
// installed. The plug-in stays loaded. Fails with deviceNotUsable when it is missing, or does not load;
// `where` says why.
Result<void*> symbolOfPlugin(const char* name, const char* symbol);

}  // namespace macula
