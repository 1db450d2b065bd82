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

}  // namespace macula::cli
