#include "live/quality/calibration.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/log.h"
#include "base/phantom.h"
#include "live/device/open_device.h"
#include "live/store/machine_documents.h"
#include "pipeline/gpu/device_info.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/json_writer.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/preset_choice.h"

namespace macula::live {

namespace {

constexpr const char* kPreset = "cinematic-bone";
constexpr int kSidePx = 128;
constexpr int kBounces = 16;
constexpr int kTimes = 5;
constexpr double kFovDeg = 30.0;
constexpr const char* kName = "live frame";  // name of the document
constexpr std::int64_t kVersion = 1;

std::string nameOf(const gpu::DeviceInfo& device) {
    return device.name + ", " + device.driver;
}

// The device that gpu::Device::create opens: if none is preferred, that of $MACULA_DEVICE.
std::string meantDevice(const std::string& preferred) {
    const char* usual = std::getenv("MACULA_DEVICE");
    return preferred.empty() && usual != nullptr ? usual : preferred;
}

Result<trace::PathTracer> tracerOf(const std::shared_ptr<gpu::Device>& device,
                                   const TransferFunction& function) {
    const auto volume = std::make_shared<const Volume>(phantom::make());
    MACULA_TRY(const trace::Environment lights, scene::chooseLights(scene::kDefaultLights));
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device));
    MACULA_TRY_VOID(tracer.scene().setVolume(volume));
    MACULA_TRY_VOID(tracer.scene().setTransferFunction(function));
    MACULA_TRY_VOID(tracer.scene().setEnvironment(lights));
    MACULA_TRY_VOID(tracer.setSettings({.bounces = kBounces, .seed = 1, .filter = trace::Filter::trilinear}));
    MACULA_TRY_VOID(
        tracer.setView({.camera = frameBox(volume->worldBox(), ViewDirection::anterior, kFovDeg, 1.0),
                        .width = kSidePx,
                        .height = kSidePx}));
    return tracer;
}

session::DocumentId documentId() {
    return {.kind = session::DocumentKind::calibration, .study = {}, .name = kName};
}

// Nothing if none is stored, or if it belongs to another device, driver or version.
std::optional<Calibration> keptCalibration(const std::filesystem::path& folder, const std::string& device) {
    const auto json = machineDocument(folder, documentId());
    if (!json || !*json) return std::nullopt;
    const auto kept = calibrationFromJson(**json);
    if (!kept || kept->device != device || kept->version != MACULA_VERSION) return std::nullopt;
    return *kept;
}

}  // namespace

Result<Calibration> measureCalibration(const std::shared_ptr<gpu::Device>& device, Progress& progress) {
    using Clock = std::chrono::steady_clock;
    const auto stopped = [&]() -> Result<void> {
        if (!progress.cancelled()) return {};
        return Error{ErrorCode::cancelled, Text("The measurement was stopped."), {}, {}};
    };
    MACULA_TRY_VOID(stopped());
    progress.beginStage(Text("Measuring this machine"), kTimes + 1);
    MACULA_TRY(const presets::ImportedPreset preset, scene::choosePreset(kPreset));
    MACULA_TRY(trace::PathTracer tracer, tracerOf(device, preset.function));
    const auto keepGoing = [&] { return !progress.cancelled(); };
    Calibration calibration{.traceMs = std::numeric_limits<double>::infinity(),
                            .device = nameOf(device->info()),
                            .version = MACULA_VERSION};
    // The first trace does not count: it compiles the kernels.
    for (int i = 0; i <= kTimes; ++i) {
        MACULA_TRY_VOID(tracer.scene().setTransferFunction(preset.function));
        const Clock::time_point start = Clock::now();
        MACULA_TRY_VOID(tracer.trace(1, keepGoing));
        MACULA_TRY_VOID(stopped());
        MACULA_TRY_VOID(device->waitForAll());
        const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        if (i > 0) calibration.traceMs = std::min(calibration.traceMs, ms);
        progress.advance();
    }
    return calibration;
}

std::string toJson(const Calibration& calibration) {
    return prettyJson(
        {{"traceMs", calibration.traceMs}, {"device", calibration.device}, {"version", calibration.version}});
}

Result<Calibration> calibrationFromJson(std::string_view text) {
    const JsonDocument document(text, {});
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    const Calibration calibration{.traceMs = root["traceMs"].number({1e-6, 1e9}),
                                  .device = root["device"].text(),
                                  .version = root["version"].text()};
    MACULA_TRY_VOID(document.status());
    return calibration;
}

Result<Calibration> calibrationOf(const std::string& preferredDevice,
                                  const std::optional<std::filesystem::path>& folder, bool anew,
                                  Progress& progress) {
    MACULA_TRY(gpu::Instance instance, gpu::Instance::create());
    MACULA_TRY(const gpu::DeviceInfo info,
               gpu::chooseDevice(gpu::listDevices(instance), meantDevice(preferredDevice)));
    if (folder && !anew) {
        if (auto kept = keptCalibration(*folder, nameOf(info))) return *std::move(kept);
    }
    MACULA_TRY(const std::shared_ptr<gpu::Device> device,
               gpu::Device::create(instance, deviceOptions(preferredDevice)));
    MACULA_TRY(Calibration calibration, measureCalibration(device, progress));
    if (!folder) return calibration;
    if (const auto kept = keepMachineDocument(*folder, documentId(), kVersion, toJson(calibration)); !kept)
        log::warning("The measurement of this machine is not kept: {}", kept.error().message.english());
    return calibration;
}

}  // namespace macula::live
