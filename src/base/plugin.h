// Plug-ins: shared libraries of Macula that are loaded on demand (dlopen), because they depend on many other
// libraries. A program that does not need them starts without that delay.
#pragma once

#include "base/result.h"

namespace macula {

// Returns the symbol that the plug-in `name` (without ".so"), made by the same build, exports. Looks in the
// folder of the program or library that contains this code, and then in the folder of installed plug-ins. The
// plug-in stays loaded. Fails with deviceNotUsable when it is missing or does not load; `where` says why.
Result<void*> symbolOfPlugin(const char* name, const char* symbol);

}  // namespace macula
