#include "scene/choice/lights_choice.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/atomic_file.h"
#include "image/image_file.h"
#include "pipeline/trace/light_rig_json.h"
#include "scene/choice/built_in_choice.h"
#include "scene/choice/nearest_name.h"

namespace macula::scene {

namespace fs = std::filesystem;

namespace {

Result<trace::Environment> fromPicture(const fs::path& path) {
    MACULA_TRY(const image::Image picture, image::readImage(path));
    if (picture.encoding != image::Encoding::linear) {
        return Error{ErrorCode::inputNotUsable, Text("The picture holds display colours, not light."),
                     path.string(), Text("Give a Radiance HDR or OpenEXR picture.")};
    }
    if (picture.width != 2 * picture.height) {
        return Error{
            ErrorCode::inputNotUsable,
            Text("The picture is {} by {} pixels, not twice as wide as high.", picture.width, picture.height),
            path.string(), Text("Give an equirectangular panorama.")};
    }
    if (const image::Faults faults = image::countFaults(picture); faults.total() > 0) {
        return Error{ErrorCode::inputNotUsable,
                     Text("The picture holds {} values that are not finite and {} negative ones.",
                          faults.notFinite, faults.negative),
                     path.string(), Text("Repair it, or give another one.")};
    }
    const std::size_t count =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    const auto channels = static_cast<std::size_t>(picture.channels);
    const bool grey = channels < 3;
    std::vector<glm::vec3> radiance(count);
    for (std::size_t i = 0; i < count; ++i) {
        const float* pixel = picture.pixels.data() + i * channels;
        radiance[i] = grey ? glm::vec3(pixel[0]) : glm::vec3(pixel[0], pixel[1], pixel[2]);
    }
    auto environment = trace::Environment::fromImage(picture.width, picture.height, radiance);
    if (!environment) {
        Error error = environment.error();
        error.where = path.string();
        return error;
    }
    return environment;
}

// Nothing if the name can only be that of a picture.
Result<std::optional<trace::LightRig>> rigNamed(const std::string& nameOrFile) {
    if (const presets::EmbeddedFile* file = findBuiltIn(presets::lightFiles(), nameOrFile)) {
        MACULA_TRY(trace::LightRig rig, trace::lightRigFromJson(file->text, std::string(file->name)));
        return std::optional(std::move(rig));
    }
    const fs::path path = nameOrFile;
    std::error_code error;
    if (!path.has_extension() && !fs::exists(path, error))
        return noSuchName(Text("There are no such lights."), nameOrFile, namesOf(presets::lightFiles()),
                          Text("Or give the path of a JSON, HDR or EXR file."));
    if (path.extension() != ".json") return std::optional<trace::LightRig>();
    MACULA_TRY(const std::string text, readText(path));
    MACULA_TRY(trace::LightRig rig, trace::lightRigFromJson(text, path.string()));
    return std::optional(std::move(rig));
}

}  // namespace

std::string_view defaultLightsFor(trace::Look look) {
    return look == trace::Look::clear ? "even" : kDefaultLights;
}

Result<std::vector<trace::LightRig>> builtInLights() {
    return parseAll<trace::LightRig>(presets::lightFiles(), trace::lightRigFromJson);
}

Result<trace::Environment> chooseLights(const std::string& nameOrFile) {
    MACULA_TRY(const std::optional<trace::LightRig> rig, rigNamed(nameOrFile));
    return rig ? trace::Environment::fromRig(*rig) : fromPicture(nameOrFile);
}

Result<trace::LightRig> chooseLightRig(const std::string& nameOrFile) {
    MACULA_TRY(std::optional<trace::LightRig> rig, rigNamed(nameOrFile));
    if (rig) return *std::move(rig);
    return Error{ErrorCode::usage, Text("A picture is no rig of lights."), nameOrFile,
                 Text("Choose lights by name, or those of a JSON file.")};
}

std::string publicLightsName(const std::string& nameOrFile) {
    return publicName(presets::lightFiles(), nameOrFile);
}

std::string publicLightsName(const trace::LightRig& rig) {
    const Result<std::vector<trace::LightRig>> all = builtInLights();
    return all && std::ranges::find(*all, rig) != all->end() ? rig.name : "custom";
}

Result<void> checkPatientLights(const trace::Environment& lights, const std::string& name) {
    if (lights.frame() == trace::LightFrame::patient) return {};
    return Error{
        ErrorCode::usage, Text("These lights hang on the camera."), name,
        Text("A peripheral model holds light that stays where it is: choose lights of the patient.")};
}

Result<trace::Environment> choosePatientLights(const std::string& nameOrFile) {
    MACULA_TRY(trace::Environment lights, chooseLights(nameOrFile));
    MACULA_TRY_VOID(checkPatientLights(lights, nameOrFile));
    return lights;
}

}  // namespace macula::scene
