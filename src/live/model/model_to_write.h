// The peripheral model of a window, as a file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/hybrid/model/peripheral_state.h"
#include "pipeline/splat/model/splats.h"
#include "scene/drawing/drawing.h"

namespace macula::live {

// The model as drawn at one moment, with its volume and drawing.
struct ModelToWrite {
    std::shared_ptr<const splat::Splats> splats;  // valid
    double gain = 1.0;                            // as hybrid::LiveModel::gain
    std::shared_ptr<const hybrid::PeripheralState>
        state{};  // all that resuming the training needs; null: not requested
    std::shared_ptr<const Volume> volume{};
    scene::Drawing drawing{};  // complete
};

// Writes the format of the name's ending (splat::kModelFormats). .macula holds the training, which `macula
// train --resume` continues, and needs `state`; other formats hold splats alone, as bright as traced
// pictures, display-encoded with `displayColours`. Returns how many splats had numbers that the format cannot
// hold, and were clamped. Fails with usage for another ending, or for display colours of .macula; with
// inputNotUsable without a state; with `cancelled`; and as writeAtomically.
Result<std::size_t> writeModelFile(const std::filesystem::path& path, const ModelToWrite& model,
                                   bool displayColours, Progress& progress);

// The same splats with their light multiplied by `gain`.
splat::Splats asBright(splat::Splats splats, double gain);

}  // namespace macula::live
