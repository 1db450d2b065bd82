#include "scene/choice/clip_choice.h"

#include <algorithm>

#include "scene/choice/built_in_choice.h"

namespace macula::scene {

Result<std::vector<ClipPreset>> builtInClips() {
    return parseAll<ClipPreset>(presets::clipFiles(), clipPresetFromJson);
}

Result<ClipPreset> chooseClip(const std::string& nameOrFile) {
    if (nameOrFile.empty()) return ClipPreset{};
    MACULA_TRY(const ChosenText chosen,
               chooseText(presets::clipFiles(), Text("There is no such clip."), nameOrFile));
    return clipPresetFromJson(chosen.text, chosen.where);
}

std::string publicClipName(const std::string& nameOrFile) {
    return nameOrFile.empty() ? "none" : publicName(presets::clipFiles(), nameOrFile);
}

std::string publicClipName(const ClipPreset& clip) {
    if (clip == ClipPreset{}) return publicClipName(std::string());
    const Result<std::vector<ClipPreset>> all = builtInClips();
    // Compares as text, because writing rounds the last bits of a box.
    const auto isIt = [text = toJson(clip)](const ClipPreset& known) { return toJson(known) == text; };
    return all && std::ranges::any_of(*all, isIt) ? clip.name : "custom";
}

}  // namespace macula::scene
