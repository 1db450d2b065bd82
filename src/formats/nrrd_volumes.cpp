#include "formats/nrrd_volumes.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/parsing.h"
#include "base/printable.h"

namespace macula::formats {

namespace {

constexpr std::size_t kAxes = 4;
constexpr std::size_t kMostInterleaved = 10'000;

// "(1, 0, 0) none" as "(1,0,0) none": one word for each axis.
std::string withoutBlanksInBrackets(const std::string& text) {
    std::string joined;
    bool isInside = false;
    for (const char c : text) {
        isInside = c == '(' || (isInside && c != ')');
        if (!isInside || (c != ' ' && c != '\t')) joined += c;
    }
    return joined;
}

// Words in quotes, which may be empty: "mm" "mm" "mm" "s".
std::vector<std::string> quotedWords(const std::string& text) {
    std::vector<std::string> found;
    std::size_t at = 0;
    while ((at = text.find('"', at)) != std::string::npos) {
        const std::size_t end = text.find('"', at + 1);
        if (end == std::string::npos) break;
        found.push_back(text.substr(at + 1, end - at - 1));
        at = end + 1;
    }
    return found;
}

// ITK writes four axes in a space of four: takes the time out of "(1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,2)"
// and of the origin. Nothing where time and space are mixed.
struct SpaceAndTime {
    std::string directions = {};
    std::string origin = {};
    double first = 0.0;
    double step = 1.0;
};

std::optional<SpaceAndTime> spaceAndTime(const Fields& fields) {
    const auto numbersOf = [](std::string text, std::size_t count) {
        std::replace_if(
            text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
        return parseNumbers(text, count);
    };
    const auto all = numbersOf(valueOf(fields, "spacedirections"), kAxes * kAxes);
    const auto origin = numbersOf(valueOf(fields, "spaceorigin"), kAxes);
    if (!all || !origin) return std::nullopt;
    SpaceAndTime both{.first = (*origin)[3], .step = (*all)[15]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if ((*all)[kAxes * axis + 3] != 0.0 || (*all)[kAxes * 3 + axis] != 0.0) return std::nullopt;
        both.directions += fmt::format("({},{},{}) ", (*all)[kAxes * axis], (*all)[kAxes * axis + 1],
                                       (*all)[kAxes * axis + 2]);
    }
    both.origin = fmt::format("({},{},{})", (*origin)[0], (*origin)[1], (*origin)[2]);
    return both;
}

// Which axis does not lie in space; nothing where all do, or nobody says.
std::optional<std::size_t> axisOutsideOfSpace(const Fields& fields) {
    const auto directions = words(lowerCase(withoutBlanksInBrackets(valueOf(fields, "spacedirections"))));
    if (directions.size() == kAxes) {
        if (directions.back() == "none") return kAxes - 1;
        if (directions.front() == "none") return 0;
        return std::nullopt;
    }
    const auto kinds = words(lowerCase(valueOf(fields, "kinds")));
    if (!directions.empty() || kinds.size() != kAxes) return std::nullopt;
    const auto isOfVolumes = [](const std::string& kind) { return kind == "time" || kind == "list"; };
    if (isOfVolumes(kinds.back())) return kAxes - 1;
    if (isOfVolumes(kinds.front())) return 0;
    return std::nullopt;
}

// The factor to ms; nothing for what is no unit of time.
std::optional<double> msIn(const std::string& unit) {
    const std::string name = lowerCase(unit);
    if (name == "s" || name == "sec" || name == "second" || name == "seconds") return 1000.0;
    if (name == "ms" || name == "msec" || name == "millisecond" || name == "milliseconds") return 1.0;
    if (name == "us" || name == "usec" || name == "microsecond" || name == "microseconds") return 0.001;
    if (name == "min" || name == "minute" || name == "minutes") return 60000.0;
    return std::nullopt;
}

// Rising numbers, one for each volume.
std::vector<double> listedAlong(std::size_t axis, std::size_t count, const Fields& notes) {
    std::string text = valueOf(notes, fmt::format("axis {} index values", axis));
    if (text.empty()) text = valueOf(notes, "MultiVolume.FrameLabels");
    std::replace(text.begin(), text.end(), ',', ' ');
    const auto numbers = parseNumbers(text, count);
    if (!numbers) return {};
    for (std::size_t n = 1; n < count; ++n)
        if (!((*numbers)[n] > (*numbers)[n - 1])) return {};
    return *numbers;
}

VolumeAxis axisOf(std::size_t axis, std::size_t count, const Fields& fields, const Fields& notes) {
    VolumeAxis found;
    const auto units = quotedWords(valueOf(fields, "units"));
    std::string unit = units.size() == kAxes ? units[axis] : std::string();
    if (unit.empty()) unit = valueOf(notes, "MultiVolume.FrameIdentifyingDICOMTagUnits");
    const auto ms = msIn(std::string(trimmed(unit)));
    found.unit = ms ? "ms" : printable(std::string(trimmed(unit).substr(0, 16)));
    const double factor = ms.value_or(1.0);
    found.listed = listedAlong(axis, count, notes);
    for (double& each : found.listed) each *= factor;
    const auto numberOf = [&](const char* field) -> std::optional<double> {
        const auto each = words(valueOf(fields, field));
        return each.size() == kAxes ? finiteNumber(each[axis]) : std::nullopt;
    };
    if (const auto step = numberOf("spacings"); step && *step > 0.0) found.step = *step * factor;
    if (const auto first = numberOf("axismins")) found.first = *first * factor;
    return found;
}

void leaveOut(Fields& fields, std::size_t axis) {
    for (const char* key : {"sizes", "spacedirections", "kinds", "spacings"}) {
        auto each = words(withoutBlanksInBrackets(valueOf(fields, key)));
        if (each.size() != kAxes) continue;
        each.erase(each.begin() + std::ptrdiff_t(axis));
        std::string joined;
        for (const std::string& word : each) joined += (joined.empty() ? "" : " ") + word;
        fields[key] = joined;
    }
    // The spacings of axes with a direction in space are nan.
    if (!valueOf(fields, "spacedirections").empty()) fields.erase("spacings");
    fields["dimension"] = "3";
}

}  // namespace

Error severalValues() {
    return headerNotUsable(
        Text("The image has several values in each voxel, such as colours or the components of a vector, "
             "which are no times; a volume needs one value."),
        Text("Write each of them to a file of its own."));
}

Result<NrrdVolumes> takeNrrdVolumes(Fields& fields, const Fields& notes) {
    const auto sizes = words(valueOf(fields, "sizes"));
    if (valueOf(fields, "dimension") != "4" || sizes.size() != kAxes) return NrrdVolumes();
    std::optional<std::size_t> axis = axisOutsideOfSpace(fields);
    const std::optional<SpaceAndTime> both = axis ? std::nullopt : spaceAndTime(fields);
    if (both) axis = kAxes - 1;
    if (!axis) return NrrdVolumes();
    const auto count = parseNumber<std::size_t>(sizes[*axis]);
    if (!count || *count < 1) return headerDamaged();
    const auto kinds = words(lowerCase(valueOf(fields, "kinds")));
    constexpr std::array<std::string_view, 6> kOfVolumes{"time", "list", "domain", "space", "none", "???"};
    const bool isOfVolumes =
        kinds.size() != kAxes || std::ranges::find(kOfVolumes, kinds[*axis]) != kOfVolumes.end();
    if (!isOfVolumes) return severalValues();
    NrrdVolumes volumes{.count = *count, .isInterleaved = *axis == 0 && *count > 1};
    if (volumes.count > (volumes.isInterleaved ? kMostInterleaved : kMostVolumes))
        return headerNotUsable(Text("The file holds more volumes than Macula reads: {}.", volumes.count),
                               Text("Write one volume to a file of its own."));
    volumes.axis = axisOf(*axis, *count, fields, notes);
    leaveOut(fields, *axis);
    if (both) {
        fields["spacedirections"] = both->directions;
        fields["spaceorigin"] = both->origin;
        volumes.axis.first = both->first;
        if (both->step > 0.0) volumes.axis.step = both->step;
        if (lowerCase(valueOf(fields, "space")) == "left-posterior-superior-time") fields["space"] = "lps";
        if (lowerCase(valueOf(fields, "space")) == "right-anterior-superior-time") fields["space"] = "ras";
        if (lowerCase(valueOf(fields, "space")) == "left-anterior-superior-time") fields["space"] = "las";
    }
    return volumes;
}

}  // namespace macula::formats
