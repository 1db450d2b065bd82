// An own preset as JSON:
//   { "version": 1, "title": "Bone, warm", "preset": {as presets/transfer},
//     "seen": {as study_state_json.cpp, without what belongs to a study},
//     "camera": { "eye": [x, y, z], "target": [x, y, z], "up": [x, y, z], "verticalFovDeg": 30,
//                 "parallelHeight": 0.5 } }
// Eye and target are relative to the centre of the volume's box; all lengths are in units of its diagonal.
// "seen", "camera" and "parallelHeight" may be missing; without parallelHeight the camera is in perspective.
#include "live/store/own_preset.h"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "pipeline/volume/json_reader.h"
#include "pipeline/volume/json_writer.h"
#include "pipeline/volume/transfer_function_json.h"
#include "scene/transfer/same_transfer.h"

namespace macula::live {

namespace {

using Json = nlohmann::ordered_json;

constexpr double kVersion = 1.0;
constexpr JsonRange kDiagonals{-1e6, 1e6};
constexpr JsonRange kHeightInDiagonals{1e-12, 1e12};
constexpr char32_t kNoLetter = 0xffffffff;

// Takes the first character off a UTF-8 text that is not empty; a malformed one stays, and gives kNoLetter.
char32_t takeLetter(std::string_view& text) {
    const auto byte = [&](std::size_t i) { return char32_t(static_cast<unsigned char>(text[i])); };
    const char32_t first = byte(0);
    const std::size_t size = first < 0x80 ? 1 : first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
    if (size == 0 || size > text.size() || first > 0xf4) return kNoLetter;
    char32_t letter = size == 1 ? first : first & (0x7fu >> size);
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0u) != 0x80u) return kNoLetter;
        letter = (letter << 6u) | (byte(i) & 0x3fu);
    }
    constexpr std::array<char32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
    if (letter < kSmallest.at(size) || letter > 0x10ffff || (letter >= 0xd800 && letter <= 0xdfff))
        return kNoLetter;
    text.remove_prefix(size);
    return letter;
}

bool isBlank(char32_t c) {
    return c == ' ' || (c >= 0x09 && c <= 0x0d) || c == 0xa0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200a) ||
           c == 0x2028 || c == 0x2029 || c == 0x202f || c == 0x205f || c == 0x3000;
}

// Control characters, and characters that are invisible or change the direction of the text after them.
bool isUnseen(char32_t c) {
    return c < 0x20 || (c >= 0x7f && c <= 0x9f) || c == 0xad || (c >= 0x200b && c <= 0x200f) ||
           (c >= 0x202a && c <= 0x202e) || (c >= 0x2060 && c <= 0x206f) || c == 0xfeff ||
           (c >= 0xfff9 && c <= 0xfffb);
}

struct Cleaned {
    std::string text;
    std::size_t letters = 0;
    bool hasUnseen = false;
    bool isUtf8 = true;
};

// Up to `most` letters. Leaves out invisible characters and bytes that are not UTF-8.
Cleaned cleaned(std::string_view typed, std::size_t most) {
    Cleaned name;
    bool isBlankDue = false;
    while (!typed.empty()) {
        const std::string_view before = typed;
        const char32_t letter = takeLetter(typed);
        if (letter == kNoLetter) {
            name.isUtf8 = false;
            typed.remove_prefix(1);
        } else if (isBlank(letter)) {
            isBlankDue = !name.text.empty();
        } else if (isUnseen(letter)) {
            name.hasUnseen = true;
        } else {
            const std::size_t added = isBlankDue ? 2 : 1;
            if (added > most - name.letters) break;
            if (std::exchange(isBlankDue, false)) name.text += ' ';
            name.text += before.substr(0, before.size() - typed.size());
            name.letters += added;
        }
    }
    return name;
}

Error wrongName(Text message, Text hint) {
    return {ErrorCode::usage, std::move(message), {}, std::move(hint)};
}

Json listOf(const glm::dvec3& v) {
    return Json::array({v.x, v.y, v.z});
}

glm::dvec3 vectorFrom(const JsonNode& node) {
    const std::vector<double> v = node.numbers(3, kDiagonals);
    return {v[0], v[1], v[2]};
}

RelativeCamera cameraFrom(const JsonNode& node) {
    RelativeCamera relative{{.positionMm = vectorFrom(node["eye"]),
                             .targetMm = vectorFrom(node["target"]),
                             .up = vectorFrom(node["up"]),
                             .verticalFovDeg = node["verticalFovDeg"].number({0.1, 170.0})}};
    if (!basis(relative.camera)) node.fail(Text("an eye, a target and an upright that make a camera"));
    if (const auto height = node.find("parallelHeight"))
        relative.camera.parallelHeightMm = height->number(kHeightInDiagonals);
    return relative;
}

// Only the parts that belong to no study, even if a document holds others.
scene::StudyState withoutStudy(const scene::StudyState& state) {
    scene::StudyState seen;
    seen.clip = state.clip;
    seen.lights = state.lights;
    seen.settings = state.settings;
    seen.windows = state.windows;
    seen.slices.window = state.slices.window;
    return seen;
}

}  // namespace

Result<std::string> checkedPresetName(std::string_view typed) {
    const Cleaned name = cleaned(typed, std::numeric_limits<std::size_t>::max());
    if (!name.isUtf8)
        return wrongName(Text("The name has letters that cannot be read."), Text("Type it anew."));
    if (name.hasUnseen)
        return wrongName(Text("The name has letters that cannot be seen."),
                         Text("Type it anew, without pasting."));
    if (name.letters == 0) return wrongName(Text("The preset needs a name."), Text("Type one."));
    if (name.letters > kMostPresetNameLetters)
        return wrongName(Text("The name is too long."),
                         Text("Use at most {} letters.", kMostPresetNameLetters));
    return name.text;
}

std::string nearestPresetName(std::string_view text) {
    const Cleaned name = cleaned(text, kMostPresetNameLetters);
    return name.text.empty() ? "Preset" : name.text;
}

bool isSamePresetName(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
    return std::ranges::equal(a, b, {}, lower, lower);
}

RelativeCamera relativeTo(const Camera& camera, const Volume& volume) {
    const Box box = volume.worldBox();
    RelativeCamera relative{camera};
    relative.camera.positionMm = (camera.positionMm - box.centre()) / box.diagonal();
    relative.camera.targetMm = (camera.targetMm - box.centre()) / box.diagonal();
    relative.camera.parallelHeightMm = camera.parallelHeightMm / box.diagonal();
    return relative;
}

Camera cameraIn(const RelativeCamera& relative, const Volume& volume) {
    const Box box = volume.worldBox();
    Camera camera = relative.camera;
    camera.positionMm = box.centre() + box.diagonal() * relative.camera.positionMm;
    camera.targetMm = box.centre() + box.diagonal() * relative.camera.targetMm;
    if (isParallel(relative.camera))
        camera.parallelHeightMm =
            std::clamp(box.diagonal() * relative.camera.parallelHeightMm, kLeastParallelMm, kMostParallelMm);
    return camera;
}

SeenLook seenOf(const scene::StudyState& state, const Volume& volume) {
    SeenLook seen{.state = withoutStudy(state)};
    // The explanation of a window is text from the DICOM file, and may contain a name.
    if (auto& window = seen.state.slices.window) window->explanation.clear();
    for (auto& window : seen.state.windows)
        if (window) window->explanation.clear();
    if (state.camera) seen.camera = relativeTo(*state.camera, volume);
    return seen;
}

bool OwnPreset::operator==(const OwnPreset& b) const {
    return id == b.id && scene::isSame(*function, *b.function) && seen == b.seen;
}

void use(const OwnPreset& preset, const Volume& volume, scene::StudyState& next) {
    next.preset = preset.function;
    if (!preset.seen) return;
    const scene::StudyState& seen = preset.seen->state;
    next.settings = seen.settings;
    next.lights = seen.lights;
    next.clip = seen.clip;
    // Raw values have no unit: a window for those of one study means nothing in another.
    if (volume.unit() == Unit::raw || !suits(*preset.function, volume.unit())) return;
    next.windows = seen.windows;
    next.slices.window = seen.slices.window;
}

std::string toJson(const OwnPreset& preset) {
    Json json{{"version", kVersion}, {"title", preset.title()}};
    json["preset"] = Json::parse(toJson(*preset.function));
    if (preset.seen) {
        json["seen"] = Json::parse(toJson(preset.seen->state));
        if (preset.seen->camera) {
            const Camera& camera = preset.seen->camera->camera;
            json["camera"] = {{"eye", listOf(camera.positionMm)},
                              {"target", listOf(camera.targetMm)},
                              {"up", listOf(camera.up)},
                              {"verticalFovDeg", camera.verticalFovDeg}};
            if (isParallel(camera)) json["camera"]["parallelHeight"] = camera.parallelHeightMm;
        }
    }
    return prettyJson(json);
}

Result<OwnPreset> ownPresetFromJson(const std::string& id, std::string_view text) {
    const JsonDocument document(text, {});
    MACULA_TRY_VOID(document.status());
    const JsonNode root = document.root();
    if (root["version"].number() != kVersion)
        root["version"].fail(Text("version 1; newer ones need a newer Macula"));
    const std::string title = root["title"].text();
    std::optional<RelativeCamera> camera;
    if (const auto node = root.find("camera")) camera = cameraFrom(*node);
    root["preset"]["volumeProperties"].items(1, 64);
    MACULA_TRY_VOID(document.status());
    MACULA_TRY(const std::string name, checkedPresetName(title));

    // The text is valid JSON by now, and an object.
    const Json all = Json::parse(text);
    MACULA_TRY(TransferFunction function, transferFunctionFromJson(all["preset"].dump(), {}));
    function.title = name;
    OwnPreset preset{.id = id, .function = std::make_shared<const TransferFunction>(std::move(function))};
    if (all.contains("seen")) {
        MACULA_TRY(const scene::StudyState state, scene::studyStateFromJson(all["seen"].dump(), {}));
        preset.seen = SeenLook{.state = withoutStudy(state), .camera = camera};
    }
    return preset;
}

}  // namespace macula::live
