#include "cli/clip_choice.h"

#include "cli/built_in_choice.h"

namespace macula::cli {

Result<std::vector<ClipPreset>> builtInClips() {
    return parseAll<ClipPreset>(presets::clipFiles(), clipPresetFromJson);
}

Result<ClipPreset> chooseClip(const std::string& nameOrFile) {
    MACULA_TRY(const ChosenText chosen, chooseText(presets::clipFiles(), "clip", nameOrFile));
    return clipPresetFromJson(chosen.text, chosen.where);
}

std::string publicClipName(const std::string& nameOrFile) {
    return nameOrFile.empty() ? "none" : publicName(presets::clipFiles(), nameOrFile);
}

}  // namespace macula::cli
