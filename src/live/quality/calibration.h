// Measures how fast this machine is, to compare it with the one that measured the quality front
// (quality_front.h): the time of one fixed trace of the phantom with `cinematic-bone`, 128 x 128 pixels, one
// sample, 16 bounces, trilinear, as `macula-bench trace-tradeoff` traces it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/gpu/device.h"

namespace macula::live {

struct Calibration {
    double traceMs = 0.0;  // the least of five, as other load only adds to it
    std::string device;    // name and driver
    std::string version;   // version of Macula
    bool operator==(const Calibration&) const = default;
};

// Takes some seconds on two cores. Fails with `cancelled`, and as trace::PathTracer.
Result<Calibration> measureCalibration(const std::shared_ptr<gpu::Device>& device, Progress& progress);

// The calibration as stored between runs, as JSON; reading fails with inputNotUsable for another text.
std::string toJson(const Calibration& calibration);
Result<Calibration> calibrationFromJson(std::string_view text);

// The calibration of this machine, for a device as gpu::chooseDevice. Reads it from `folder` (a
// session::Store) if that has one of the same device, driver and version; with `anew`, or if not, measures it
// and stores it there. A store that cannot be used, or no `folder`, means measuring without storing. Opens a
// device of its own.
Result<Calibration> calibrationOf(const std::string& preferredDevice,
                                  const std::optional<std::filesystem::path>& folder, bool anew,
                                  Progress& progress);

}  // namespace macula::live
