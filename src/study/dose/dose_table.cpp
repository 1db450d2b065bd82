#include "study/dose/dose_table.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/csv.h"
#include "base/printable.h"

namespace macula::study {

namespace {

constexpr double kPercent = 100.0;
constexpr double kTwentyGy = 20.0;

std::string number(const std::optional<double>& value, double factor = 1.0) {
    return value && std::isfinite(*value) ? fmt::format("{:.6g}", *value * factor) : std::string();
}

nlohmann::ordered_json json(const std::optional<double>& value, double factor = 1.0) {
    if (!value || !std::isfinite(*value)) return nullptr;
    return *value * factor;
}

}  // namespace

DoseFigures figuresOf(const RegionInDose& region, const DoseReport& report) {
    const DoseHistogram& histogram = region.dose.histogram;
    DoseFigures figures{.minimum = histogram.minimum(),
                        .mean = histogram.isEmpty() ? std::nan("") : histogram.mean(),
                        .maximum = histogram.maximum(),
                        .d98 = histogram.doseAt(0.98),
                        .d95 = histogram.doseAt(0.95),
                        .d50 = histogram.doseAt(0.5),
                        .d2 = histogram.doseAt(0.02)};
    if (report.isInGy) figures.v20Gy = histogram.shareAt(kTwentyGy);
    if (report.reference) {
        const double whole = report.reference->value;
        figures.v95 = histogram.shareAt(0.95 * whole);
        figures.v100 = histogram.shareAt(whole);
        figures.v107 = histogram.shareAt(1.07 * whole);
    }
    return figures;
}

std::string_view nameOf(DoseReference::Of of) {
    switch (of) {
        case DoseReference::Of::prescription:
            return "prescription";
        case DoseReference::Of::maximum:
            return "maximum";
        case DoseReference::Of::choice:
            return "choice";
    }
    return {};
}

std::string doseLines(const DoseReport& report) {
    constexpr std::size_t kWidest = 40;
    std::size_t width = 6;
    for (const RegionInDose& region : report.regions)
        width = std::max(width, std::min(printable(region.label).size(), kWidest));
    const auto fixed = [](const std::optional<double>& value, int decimals, double factor = 1.0) {
        return value && std::isfinite(*value) ? fmt::format("{:.{}f}", *value * factor, decimals)
                                              : std::string("-");
    };
    std::string lines = fmt::format("{:<{}}", "region", width);
    for (const char* name :
         {"mL", "outside%", "min", "mean", "max", "D98", "D95", "D50", "D2", "V20Gy%", "V95%", "V100%"})
        lines += fmt::format("  {:>8}", name);
    for (const RegionInDose& region : report.regions) {
        const DoseFigures f = figuresOf(region, report);
        lines += fmt::format("\n{:<{}}  {:>8}  {:>8}", printable(region.label), width,
                             fixed(region.volumeMl, 2), fixed(region.dose.outsideShare(), 1, kPercent));
        for (const double value : {f.minimum, f.mean, f.maximum, f.d98, f.d95, f.d50, f.d2})
            lines += fmt::format("  {:>8}", fixed(value, 2));
        for (const auto& share : {f.v20Gy, f.v95, f.v100})
            lines += fmt::format("  {:>8}", fixed(share, 1, kPercent));
    }
    lines += fmt::format("\nDoses in {}, V in percent of the region inside the dose.", report.unit);
    if (report.reference)
        lines += fmt::format(" V95% and V100% are of {:.4g} {} ({}).", report.reference->value, report.unit,
                             nameOf(report.reference->of));
    return lines + "\n";
}

std::string doseCsv(const DoseReport& report) {
    std::string csv =
        "set,region,volume_ml,voxels,samples,outside_percent,unit,minimum,mean,maximum,d98,d95,d50,d2,"
        "v20gy_percent,reference,reference_of,v95_percent,v100_percent,v107_percent\r\n";
    const std::string reference = report.reference ? number(report.reference->value) : std::string();
    const std::string of = report.reference ? std::string(nameOf(report.reference->of)) : std::string();
    for (const RegionInDose& region : report.regions) {
        const DoseFigures f = figuresOf(region, report);
        const std::vector<std::string> fields{csvWords(region.set),
                                              csvWords(region.label),
                                              number(region.volumeMl),
                                              fmt::format("{}", region.dose.voxels),
                                              fmt::format("{}", region.dose.samples),
                                              number(region.dose.outsideShare(), kPercent),
                                              csvWords(report.unit),
                                              number(f.minimum),
                                              number(f.mean),
                                              number(f.maximum),
                                              number(f.d98),
                                              number(f.d95),
                                              number(f.d50),
                                              number(f.d2),
                                              number(f.v20Gy, kPercent),
                                              reference,
                                              of,
                                              number(f.v95, kPercent),
                                              number(f.v100, kPercent),
                                              number(f.v107, kPercent)};
        for (std::size_t i = 0; i < fields.size(); ++i) csv += (i > 0 ? "," : "") + fields[i];
        csv += "\r\n";
    }
    return csv;
}

nlohmann::ordered_json doseJson(const DoseReport& report) {
    nlohmann::ordered_json all{{"version", 1}, {"unit", report.unit}};
    if (report.reference)
        all["reference"] = {{"value", report.reference->value},
                            {"of", std::string(nameOf(report.reference->of))}};
    all["regions"] = nlohmann::ordered_json::array();
    for (const RegionInDose& region : report.regions) {
        const DoseFigures f = figuresOf(region, report);
        all["regions"].push_back({{"set", region.set},
                                  {"region", region.label},
                                  {"volumeMl", json(region.volumeMl)},
                                  {"voxels", region.dose.voxels},
                                  {"samples", region.dose.samples},
                                  {"outsidePercent", json(region.dose.outsideShare(), kPercent)},
                                  {"minimum", json(f.minimum)},
                                  {"mean", json(f.mean)},
                                  {"maximum", json(f.maximum)},
                                  {"d98", json(f.d98)},
                                  {"d95", json(f.d95)},
                                  {"d50", json(f.d50)},
                                  {"d2", json(f.d2)},
                                  {"v20GyPercent", json(f.v20Gy, kPercent)},
                                  {"v95Percent", json(f.v95, kPercent)},
                                  {"v100Percent", json(f.v100, kPercent)},
                                  {"v107Percent", json(f.v107, kPercent)}});
    }
    all["notes"] = nlohmann::ordered_json::array();
    for (const Text& note : report.notes) all["notes"].push_back(note.english());
    return all;
}

}  // namespace macula::study
