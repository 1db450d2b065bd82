#include "live/store/model_key_of_drawing.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/check.h"
#include "base/sha256.h"
#include "live/model/scene_digests.h"
#include "pipeline/splat/train/training_state.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/settings.h"

namespace macula::live {

namespace {

constexpr const char* kLights = "lights";
constexpr const char* kTrainer = "trainer";
constexpr const char* kTracer = "tracer";

}  // namespace

session::ModelKey modelKeyOf(const std::string& volumeDigest, const Volume& volume,
                             const scene::Drawing& drawing, PartDigests& parts) {
    MACULA_CHECK(drawing.transferFunction && drawing.lights);
    trace::Settings settings = scene::settingsOfLight(drawing);
    const std::string lights =
        sha256Hex(fmt::format("{} {:a} {:a}", digestOf(trace::Environment::fromRig(*drawing.lights)),
                              settings.lightRotationDeg, settings.lightStrength));
    settings.lightRotationDeg = trace::Settings{}.lightRotationDeg;
    settings.lightStrength = trace::Settings{}.lightStrength;
    return {.volume = volumeDigest,
            .trainer = splat::kTrainerVersion,
            .parts = {{"transfer-function", digestOf(*drawing.transferFunction)},
                      {"clip", digestOf(drawing.clip ? *drawing.clip : Clip{},
                                        drawing.additions ? *drawing.additions : Additions{}, volume, parts)},
                      {kLights, lights},
                      {"settings", digestOf(settings)},
                      {kTracer, sha256Hex(fmt::format("macula tracer {}", trace::kTracerVersion))}}};
}

Kinship kinshipOf(const session::ModelKey& wanted, const session::ModelKey& stored) {
    const std::vector<std::string> others = session::differences(wanted, stored);
    const auto isOfVersion = [](const std::string& part) { return part == kTrainer || part == kTracer; };
    const auto isKin = [&](const std::string& part) { return part == kLights || isOfVersion(part); };
    if (others.empty() || !std::ranges::all_of(others, isKin)) return Kinship::none;
    return std::ranges::any_of(others, isOfVersion) ? Kinship::otherVersion : Kinship::otherLights;
}

}  // namespace macula::live
