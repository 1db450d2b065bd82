// Presets that somebody has changed: each is a copy, with a name of its own.
#pragma once

#include <set>
#include <string>

#include "pipeline/volume/transfer_function.h"

namespace macula::app {

// The same curves as a preset of one's own: titled "CT-Bone (edited)", "(edited 2)" and so on, named after
// that ("ct-bone-edited"), not as any of `taken` nor as the preset itself, and without its number. Who wrote
// it and under which licence stays in the document as it is, and so does `source`; `id` and `sha256`, which
// are true of the original only, go. `derivedFrom` names the original, and `provenance` says that it was
// edited. See presets/schema.
TransferFunction ownCopy(const TransferFunction& function, const std::set<std::string>& taken);

// The name of the preset that this one was copied from by ownCopy; empty for any other. Reads the document.
std::string copiedFrom(const TransferFunction& function);

}  // namespace macula::app
