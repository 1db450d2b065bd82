// Any text as a file that Macula writes and people edit, pass on and keep: the first letter says of which
// kind. What is read can be used, and written and read again.
#include <array>
#include <string_view>

#include "fuzz/file_of_bytes.h"
#include "live/store/own_preset.h"
#include "pipeline/trace/light_rig_json.h"
#include "pipeline/trace/quality.h"
#include "scene/camera/camera_file.h"
#include "scene/camera/camera_path.h"
#include "scene/camera/splat_cameras.h"
#include "scene/clip/scissor_cut.h"
#include "scene/slices/own_windows.h"
#include "scene/state/study_state.h"

namespace macula::app {
namespace {

template <class T>
bool isTold(const Result<T>& result) {
    return !result.error().message.empty() && !result.error().hint.empty();
}

void checkCuts(const Cuts& cuts) {
    for (const ScissorCut& cut : cuts.scissors) {
        MACULA_CHECK(validate(cut).ok());
        const ScissorBlades blades(cut);
        for (const double mm : {-1e3, 0.0, 20.0}) (void)blades.removesPoint({mm, -mm, 0.5 * mm});
    }
}

void readState(const std::string& text) {
    const auto state = studyStateFromJson(text, "state");
    if (!state) return MACULA_CHECK(isTold(state));
    if (state->camera) MACULA_CHECK(basis(*state->camera).ok());
    checkCuts(state->cuts);
    for (const NamedClip& named : state->namedClips) checkCuts(named.cuts);
    if (state->preset) MACULA_CHECK(validate(*state->preset).ok());
    const std::string written = toJson(*state);
    const auto again = studyStateFromJson(written, "written");
    MACULA_CHECK(again.ok());
    MACULA_CHECK(*again == *state);
    MACULA_CHECK(toJson(*again) == written);
}

void readOwnPreset(const std::string& text) {
    const auto preset = ownPresetFromJson("own-1", text);
    if (!preset) return MACULA_CHECK(isTold(preset));
    const auto again = ownPresetFromJson("own-1", toJson(*preset));
    MACULA_CHECK(again.ok());
    MACULA_CHECK(*again == *preset);
}

void readWindows(const std::string& text) {
    const auto windows = ownWindowsFromJson(text);
    if (!windows) return MACULA_CHECK(isTold(windows));
    const auto again = ownWindowsFromJson(toJson(*windows));
    MACULA_CHECK(again.ok());
    MACULA_CHECK(*again == *windows);
}

void readClip(const std::string& text) {
    const auto clip = clipPresetFromJson(text, "clip");
    if (!clip) return MACULA_CHECK(isTold(clip));
    MACULA_CHECK(clipPresetFromJson(toJson(*clip), "written").ok());
}

void readLights(const std::string& text) {
    const auto rig = trace::lightRigFromJson(text, "lights");
    if (!rig) return MACULA_CHECK(isTold(rig));
    const auto again = trace::lightRigFromJson(trace::toJson(*rig), "written");
    MACULA_CHECK(again.ok() && *again == *rig);
    constexpr std::size_t kMostMade = 3;  // more lights are the same code, only slower
    if (rig->lights.size() > kMostMade) return;
    const trace::Environment environment = trace::Environment::fromRig(*rig);
    for (const trace::EnvironmentTexel& texel : environment.texels()) {
        MACULA_CHECK(texel.pdfPerSr >= 0.0f);
        for (int c = 0; c < 3; ++c) MACULA_CHECK(texel.radiance[c] >= 0.0f);
    }
}

void readQuality(const std::string& text) {
    const auto quality = trace::qualityFromJson(text, "quality");
    if (!quality) return MACULA_CHECK(isTold(quality));
    MACULA_CHECK(quality->samplesPerPixel >= 1);
}

std::filesystem::path fileWith(const std::string& text) {
    return fuzz::fileOf(reinterpret_cast<const std::uint8_t*>(text.data()), text.size(), "camera.json");
}

void readOneCamera(const std::string& text) {
    const std::filesystem::path file = fileWith(text);
    (void)readSplatCamera(file, std::nullopt);
    const auto camera = readCamera(file);
    if (!camera) return MACULA_CHECK(isTold(camera));
    (void)basis(*camera);
    const auto again = readCamera(fileWith(toJson(*camera).dump()));
    MACULA_CHECK(again.ok() && *again == *camera);
}

void readCameras(const std::string& text) {
    const std::filesystem::path file = fileWith(text);
    const std::array<std::optional<glm::ivec2>, 2> sizes{std::nullopt, glm::ivec2(64, 48)};
    for (const auto& size : sizes) {
        const auto cameras = readSplatCameras(file, size);
        if (!cameras) {
            MACULA_CHECK(isTold(cameras));
            continue;
        }
        MACULA_CHECK(!cameras->empty());
        for (const SplatCamera& camera : *cameras) MACULA_CHECK(splat::validate(camera.view).ok());
    }
}

void readPath(const std::string& text) {
    const auto path = readCameraPath(fileWith(text));
    if (!path) return MACULA_CHECK(isTold(path));
    const double end = path->seconds();
    for (const double atS : {-1.0, 0.0, 0.3 * end, 0.5 * end, 0.99 * end, end, 2.0 * end})
        MACULA_CHECK(basis(cameraAt(*path, atS)).ok());
    MACULA_CHECK(readCameraPath(fileWith(toJson(*path))).ok());
}

struct Kind {
    char letter;
    void (*read)(const std::string& text);
};
constexpr std::array<Kind, 9> kKinds{{{'s', readState},
                                      {'o', readOwnPreset},
                                      {'w', readWindows},
                                      {'k', readClip},
                                      {'l', readLights},
                                      {'q', readQuality},
                                      {'c', readOneCamera},
                                      {'3', readCameras},
                                      {'p', readPath}}};

}  // namespace
}  // namespace macula::app

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::app;
    (void)macula::fuzz::folder();
    if (size == 0) return 0;
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    for (const Kind& kind : kKinds)
        if (kind.letter == static_cast<char>(data[0])) kind.read(text);
    return 0;
}
