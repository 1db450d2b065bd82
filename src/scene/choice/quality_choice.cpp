#include "scene/choice/quality_choice.h"

#include <algorithm>

#include "scene/choice/built_in_choice.h"

namespace macula::scene {

Result<std::vector<trace::Quality>> builtInQualities() {
    MACULA_TRY(std::vector<trace::Quality> qualities,
               parseAll<trace::Quality>(presets::qualityFiles(), trace::qualityFromJson));
    std::ranges::sort(qualities, {}, &trace::Quality::samplesPerPixel);
    return qualities;
}

Result<trace::Quality> chooseQuality(const std::string& nameOrFile) {
    MACULA_TRY(const ChosenText chosen,
               chooseText(presets::qualityFiles(), Text("There is no such quality."), nameOrFile));
    return trace::qualityFromJson(chosen.text, chosen.where);
}

}  // namespace macula::scene
