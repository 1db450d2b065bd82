#include "scene/slices/time_curve.h"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "base/csv.h"

namespace macula::scene {

Result<TimeCurves> timeCurves(std::span<const slices::Measurement> measurements,
                              std::vector<study::Phase> phases,
                              const std::vector<std::shared_ptr<const study::OpenedStudy>>& studies,
                              const CancelToken& token) {
    MACULA_CHECK(phases.size() == studies.size() && !studies.empty());
    TimeCurves all{
        .phases = std::move(phases), .unit = studies.front()->measured()->unitName(), .curves = {}};
    for (const auto& study : studies)
        if (study->measured()->unitName() != all.unit)
            return Error{ErrorCode::usage,
                         Text("The phases have values of different units."),
                         {},
                         Text("Measure each phase by itself.")};
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        if (!slices::hasArea(measurements[i])) continue;
        TimeCurve curve{.label = measurements[i].label,
                        .kind = std::string(slices::kindOf(measurements[i])),
                        .number = i + 1,
                        .values = {}};
        for (const auto& study : studies) {
            if (token.cancelled())
                return Error{ErrorCode::cancelled, Text("The curve was cancelled."), {}, {}};
            curve.values.push_back(slices::valuesIn(measurements[i], *study->measured()));
        }
        all.curves.push_back(std::move(curve));
    }
    if (all.curves.empty())
        return Error{ErrorCode::usage,
                     Text("No ellipse or outline is drawn."),
                     {},
                     Text("Draw an ellipse (E) on a slice: the curve has the mean of the values in it.")};
    return all;
}

std::string toCsv(const TimeCurves& curves) {
    std::string csv = "phase,label,ms";
    for (const TimeCurve& curve : curves.curves) {
        const std::string label =
            curve.label.empty() ? fmt::format("{} {}", curve.kind, curve.number) : curve.label;
        csv += fmt::format(",{},{}", csvWords(label + " mean " + curves.unit),
                           csvWords(label + " deviation " + curves.unit));
    }
    csv += "\r\n";
    for (std::size_t i = 0; i < curves.phases.size(); ++i) {
        const study::Phase& phase = curves.phases[i];
        csv += fmt::format("{},{},{}", i + 1, csvWords(phase.label.english()),
                           phase.atMs ? fmt::format("{:.9g}", *phase.atMs) : std::string());
        for (const TimeCurve& curve : curves.curves) {
            const auto& values = curve.values[i];
            csv += values ? fmt::format(",{:.9g},{:.9g}", values->mean, values->deviation) : ",,";
        }
        csv += "\r\n";
    }
    return csv;
}

}  // namespace macula::scene
