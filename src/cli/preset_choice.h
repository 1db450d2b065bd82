// From what the user typed after --preset to a transfer function.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::cli {

// All built-in ones, by name.
Result<std::vector<TransferFunction>> builtInPresets();

// A built-in name, or a JSON file. usage when it is neither; inputNotUsable when the file is malformed.
Result<TransferFunction> choosePreset(const std::string& nameOrFile);

// What may be told of that choice in a picture or a report: a built-in name, else "custom", as the name of a
// user's file may say whose it is.
std::string publicPresetName(const std::string& nameOrFile);

}  // namespace macula::cli
