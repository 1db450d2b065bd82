// Parts of Macula that are loaded when they are needed, because they bring many libraries along: a program
// that does without them starts at once.
#pragma once

#include "base/result.h"

namespace macula {

// What the module of this name, made by the same build, exports under `symbol`. Looked for beside the program
// or library that this is part of, and where it is installed. Stays loaded. Fails with deviceNotUsable when
// it is not there or does not fit.
Result<void*> symbolOfModule(const char* module, const char* symbol);

}  // namespace macula
