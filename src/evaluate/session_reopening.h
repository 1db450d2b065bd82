// What it takes to go on with a peripheral model that an earlier run of the program has kept.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/result.h"
#include "evaluate/stored_scene.h"
#include "pipeline/splat/model/splats.h"

namespace macula::evaluate {

// Each by itself; medians but for the first.
struct ReadingTimes {
    double openStoreMs = 0.0;
    double digestMs = 0.0;    // of the volume
    double drawableMs = 0.0;  // readDrawable
    double blobMs = 0.0;      // all of the blob read and checked
    double unpackMs = 0.0;    // readPeripheral of that
    std::uint64_t blobBytes = 0;
};

// As a keeper does it.
Result<ReadingTimes> measureReading(const StoredScene& scene);

// Times are since the keeper was told to look. What is found is asked for every 2 ms.
struct Reopening {
    // The keeper has opened the store and made the digest before, as while a window loads the study.
    bool isKeeperReady = false;
    double drawableMs = 0.0;      // it has found splats to be drawn
    double firstPictureMs = 0.0;  // they are drawn
    double wholeMs = 0.0;         // it has found the state
    double learningMs = 0.0;      // the model goes on with it
    std::uint64_t steps = 0;
    // PeripheralReport::error and shownError.
    std::optional<double> trainedError;
    std::optional<double> shownError;
    bool isSame = false;  // what is shown is `before`, to the bit
};

// With a keeper and a model of its own, on the device that has the volume.
Result<Reopening> measureReopening(StoredScene& scene, bool isKeeperReady, const Camera& camera,
                                   const splat::Splats& before);

}  // namespace macula::evaluate
