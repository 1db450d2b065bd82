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

namespace macula::app {

// As it was drawn at a moment, and whose it is.
struct TakenModel {
    std::shared_ptr<const splat::Splats> splats;  // valid
    double gain = 1.0;                            // as hybrid::LiveModel::gain
    std::shared_ptr<const hybrid::PeripheralState>
        state{};  // all that learning goes on with; null: not asked
    std::shared_ptr<const Volume> volume{};
    Drawing drawing{};  // complete
};

// By the ending of the name (splat::kModelFormats). .macula holds its training, which `macula train --resume`
// goes on with, and needs the state; the others hold splats alone, as bright as what is traced, with
// `displayColours` as they are displayed. Returns how many splats had numbers that the format cannot hold,
// and were limited. usage for another ending, or for display colours of .macula; inputNotUsable without a
// state; `cancelled`; fails as writeAtomically.
Result<std::size_t> writeTakenModel(const std::filesystem::path& path, const TakenModel& model,
                                    bool displayColours, Progress& progress);

// The same model with `gain` times its light.
splat::Splats asBright(splat::Splats splats, double gain);

}  // namespace macula::app
