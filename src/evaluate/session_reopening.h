// Measures how long it takes to continue with a peripheral model from an earlier run of the program.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/result.h"
#include "evaluate/stored_scene.h"
#include "pipeline/splat/model/splats.h"

namespace macula::evaluate {

// Times of the separate steps; medians, except openStoreMs.
struct ReadingTimes {
    double openStoreMs = 0.0;
    double digestMs = 0.0;    // of the volume
    double drawableMs = 0.0;  // readDrawable
    double blobMs = 0.0;      // the whole blob, read and checked
    double unpackMs = 0.0;    // readPeripheral of that blob
    std::uint64_t blobBytes = 0;
};

// Does these steps as a StudyKeeper does.
Result<ReadingTimes> measureReading(const StoredScene& scene);

// Times are since the keeper began to look. The store is polled every 2 ms.
struct Reopening {
    // The keeper opened the store and made the digest before, as while a window loads the study.
    bool isKeeperReady = false;
    double drawableMs = 0.0;      // the keeper has found drawable splats
    double firstPictureMs = 0.0;  // the splats are drawn
    double wholeMs = 0.0;         // the keeper has read the state
    double learningMs = 0.0;      // the model continues with that state
    std::uint64_t steps = 0;
    // PeripheralReport::error and PeripheralReport::shownError.
    std::optional<double> trainedError;
    std::optional<double> shownError;
    bool isSame = false;  // the shown splats are `before`, bit for bit
};

// Makes a new keeper and a new model, on the device that has the volume.
Result<Reopening> measureReopening(StoredScene& scene, bool isKeeperReady, const Camera& camera,
                                   const splat::Splats& before);

}  // namespace macula::evaluate
