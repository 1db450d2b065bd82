#include "dicom/stack/suv.h"

#include <algorithm>
#include <cmath>

#include "dicom/read/date_time.h"

namespace macula::dicom {

namespace {

std::optional<double> secondsOf(const Dataset& header, Tag dateTag, Tag timeTag) {
    const auto date = header.text(dateTag);
    const auto time = header.text(timeTag);
    if (!date || !time) return {};
    const auto days = daysOfDate(*date);
    const auto seconds = secondsOfTime(*time);
    if (!days || !seconds) return {};
    return 86400.0 * double(*days) + *seconds;
}

// Whether dose and weight are in Bq and kg, as they have to be (PS3.3 C.8.9.2, C.7.2.2). Files that were
// edited or converted have kBq, MBq or g, and uptake values that are false by a factor of a thousand or more.
// Doses for mice and men lie between 0.1 and 1000 MBq/kg; the limits are ten times wider.
bool isPlausibleDose(double doseBq, double weightKg) {
    constexpr double kLeastBqPerKg = 1e4;
    constexpr double kMostBqPerKg = 1e10;
    const double bqPerKg = doseBq / weightKg;
    return bqPerKg >= kLeastBqPerKg && bqPerKg <= kMostBqPerKg;
}

// The time that the decay correction START refers to: the start of the series, unless that was rewritten
// after the acquisition, as workstations do.
std::optional<double> scanSeconds(const Dataset& header) {
    const auto series = secondsOf(header, tag::kSeriesDate, tag::kSeriesTime);
    const auto acquisition = secondsOf(header, tag::kAcquisitionDate, tag::kAcquisitionTime);
    if (series && acquisition && *series > *acquisition) return {};
    return series;
}

}  // namespace

Suv suvOf(const Dataset& header) {
    const auto without = [](Text what) { return Suv{{}, std::move(what)}; };
    const std::string units = header.text(tag::kUnits).value_or("");
    if (units == "GML") {
        const std::string type =
            header.text(tag::kSuvType).value_or("BW");  // absent means BW: PS3.3 C.8.9.1.1.3
        return type == "BW" ? Suv{1.0, {}} : without(Text("SUV by body weight"));
    }
    if (units != "BQML") return without(Text("Units of Bq/mL"));
    const auto corrected = header.texts(tag::kCorrectedImage);
    const auto has = [&](const char* what) {
        return std::find(corrected.begin(), corrected.end(), what) != corrected.end();
    };
    if (!has("DECY") || !has("ATTN")) return without(Text("correction for decay and attenuation"));
    const auto weightKg = header.number(tag::kPatientWeight);
    if (!weightKg || *weightKg <= 0.0) return without(Text::verbatim("PatientWeight"));
    const auto tracers = header.items(tag::kRadiopharmaceuticalInformation);
    if (tracers.empty()) return without(Text::verbatim("RadiopharmaceuticalInformationSequence"));
    const Dataset& tracer = tracers.front();
    const auto doseBq = tracer.number(tag::kRadionuclideTotalDose);
    if (!doseBq || *doseBq <= 0.0) return without(Text::verbatim("RadionuclideTotalDose"));
    if (!isPlausibleDose(*doseBq, *weightKg))
        return without(Text("a RadionuclideTotalDose in Bq that fits PatientWeight"));
    const double gramsPerBq = 1000.0 * *weightKg / *doseBq;
    const std::string correction = header.text(tag::kDecayCorrection).value_or("");
    if (correction == "ADMIN") return {gramsPerBq, {}};
    if (correction != "START") return without(Text::verbatim("DecayCorrection"));

    const auto halfLife = tracer.number(tag::kRadionuclideHalfLife);
    if (!halfLife || *halfLife <= 0.0) return without(Text::verbatim("RadionuclideHalfLife"));
    const auto scan = scanSeconds(header);
    if (!scan) return without(Text("time of the scan"));
    std::optional<double> injected;
    if (const auto text = tracer.text(tag::kRadiopharmaceuticalStartDateTime)) {
        // A time with an offset from UTC can only be compared with times of the same offset.
        const std::size_t offset = text->find_first_of("+-");
        if (offset == std::string::npos || header.text(tag::kTimezoneOffsetFromUtc) == text->substr(offset)) {
            injected = secondsOfDateTime(*text);
        }
    }
    if (!injected) {
        if (const auto text = tracer.text(tag::kRadiopharmaceuticalStartTime)) {
            // A time without a date is on the day of the scan, or the day before when that would lie after
            // it.
            if (const auto time = secondsOfTime(*text)) {
                injected = std::floor(*scan / 86400.0) * 86400.0 + *time;
                if (*injected > *scan) *injected -= 86400.0;
            }
        }
    }
    if (!injected) return without(Text::verbatim("RadiopharmaceuticalStartTime"));
    const double elapsed = *scan - *injected;
    if (elapsed < 0.0 || elapsed > 10.0 * *halfLife)
        return without(Text("plausible time between injection and scan"));
    return {gramsPerBq * std::exp2(elapsed / *halfLife), {}};
}

}  // namespace macula::dicom
