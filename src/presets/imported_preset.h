// The result of importing one preset of another program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::presets {

struct ImportedPreset {
    TransferFunction function;
    std::vector<Text> notes;  // sentences: what was assumed, changed or left out
};

// The presets of a file in its order; never empty.
using ImportedPresets = std::vector<ImportedPreset>;

// The input of every importer.
struct PresetText {
    std::string_view text;
    std::string where;         // the file, for errors
    std::string fallbackName;  // for formats without names: the file's, without folder and extension
};

}  // namespace macula::presets
