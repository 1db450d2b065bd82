// How fast this machine is, beside the one that measured the quality front (quality_front.h): the time of one
// small trace that never changes. It is the phantom with `cinematic-bone`, 128 x 128 pixels, one sample, 16
// bounces, trilinear, as `macula bench trace-tradeoff` traces it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"

namespace macula::app {

struct Calibration {
    double traceMs = 0.0;  // the least of a few, as whatever else the machine does only adds to it
    std::string device;    // name and driver
    std::string version;   // of the program
    bool operator==(const Calibration&) const = default;
};

// Some seconds on two cores. `cancelled`, and as trace::PathTracer.
Result<Calibration> measureCalibration(const std::shared_ptr<gpu::Device>& device, Progress& progress);

// What is kept of it between runs, as JSON, and back: inputNotUsable for another text.
std::string toJson(const Calibration& calibration);
Result<Calibration> calibrationFromJson(std::string_view text);

// That of this machine, for a device as gpu::chooseDevice: the one that is kept in `folder` (a
// session::Store) if it is of the same device, driver and version, unless it is to be made `anew`; else
// measured and kept there. Nothing: it is kept nowhere. Where the store cannot be used it is measured all the
// same. Opens a device of its own.
Result<Calibration> calibrationOf(const std::string& preferredDevice,
                                  const std::optional<std::filesystem::path>& folder, bool anew,
                                  Progress& progress);

}  // namespace macula::app
