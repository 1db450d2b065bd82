// Copies of presets for editing, each with a name of its own.
#pragma once

#include <set>
#include <string>

#include "pipeline/volume/transfer_function.h"

namespace macula::scene {

// A copy titled "CT-Bone (edited)", "(edited 2)" and so on, with a name made from the title
// ("ct-bone-edited") that neither `taken` nor the preset has, and without the preset's number. The document
// keeps author, licence and `source`, and loses `id` and `sha256`, which are true of the original only.
// `derivedFrom` names the original, and `provenance` says that it was edited. See presets/schema.
TransferFunction ownCopy(const TransferFunction& function, const std::set<std::string>& taken);

// The name of the preset that ownCopy made this one from, read from the document; empty for any other.
std::string copiedFrom(const TransferFunction& function);

}  // namespace macula::scene
