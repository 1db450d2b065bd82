#include "app/choice/clip_choice.h"

#include "app/choice/built_in_choice.h"

namespace macula::app {

Result<std::vector<ClipPreset>> builtInClips() {
    return parseAll<ClipPreset>(presets::clipFiles(), clipPresetFromJson);
}

Result<ClipPreset> chooseClip(const std::string& nameOrFile) {
    if (nameOrFile.empty()) return ClipPreset{};
    MACULA_TRY(const ChosenText chosen, chooseText(presets::clipFiles(), "clip", nameOrFile));
    return clipPresetFromJson(chosen.text, chosen.where);
}

std::string publicClipName(const std::string& nameOrFile) {
    return nameOrFile.empty() ? "none" : publicName(presets::clipFiles(), nameOrFile);
}

}  // namespace macula::app
