#include "scene/second/dose_lines.h"

#include <algorithm>
#include <functional>

namespace macula::scene {

namespace {

constexpr double kPercent = 100.0;

}  // namespace

std::optional<study::DoseReference> doseReference(const study::OpenedStudy& dose,
                                                  const std::optional<Isodoses>& isodoses) {
    if (!dose.dose || !dose.volume) return std::nullopt;
    if (isodoses && isodoses->reference && isUsable(*isodoses))
        return study::DoseReference{.value = *isodoses->reference, .of = study::DoseReference::Of::choice};
    return study::usualReference(dose.dose, *dose.measured());
}

std::vector<DoseLine> doseLines(const Isodoses& isodoses,
                                const std::optional<study::DoseReference>& reference) {
    std::vector<DoseLine> lines;
    if (!isUsable(isodoses)) return lines;
    for (const Isodose& each : isodoses.levels) {
        DoseLine line{.value = each.level, .percent = {}, .rgb = each.rgb};
        if (isodoses.areInPercent) {
            if (!reference) continue;
            line.value = each.level / kPercent * reference->value;
            line.percent = each.level;
        } else if (reference) {
            line.percent = kPercent * each.level / reference->value;
        }
        lines.push_back(line);
    }
    std::ranges::stable_sort(lines, std::greater(), &DoseLine::value);
    return lines;
}

}  // namespace macula::scene
