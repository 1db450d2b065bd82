#include "study/open/stack_label_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "base/parsing.h"
#include "dicom/read/date_time.h"

namespace macula::study {

namespace {

// `text` has {} in place of the value.
struct Words {
    std::string_view attribute;
    std::string_view text;
};
constexpr std::array kWords{
    Words{"Modality", "{}"},
    Words{"StackID", "stack {}"},
    Words{"Repetition", "repetition {}"},
    Words{"Copy", "copy {}"},
    Words{"AcquisitionNumber", "acquisition {}"},
    Words{"ContrastBolusAgent", "contrast agent {}"},
    Words{"SeriesNumber", "series {}"},
    Words{"SeriesDescription", "{}"},
    Words{"Manufacturer", "made by {}"},
    Words{"BodyPartExamined", "{}"},
    Words{"ConvolutionKernel", "kernel {}"},
    Words{"KVP", "{} kV"},
    Words{"GantryDetectorTilt", "gantry tilted by {}°"},
    Words{"ReconstructionDiameter", "field of view {} mm"},
    Words{"SliceThickness", "slices {} mm thick"},
    Words{"EchoTime", "TE {} ms"},
    Words{"EchoNumbers", "echo {}"},
    Words{"RepetitionTime", "TR {} ms"},
    Words{"InversionTime", "TI {} ms"},
    Words{"FlipAngle", "flip angle {}°"},
    Words{"DiffusionBValue", "b {} s/mm²"},
    Words{"SequenceName", "sequence {}"},
    Words{"TriggerTime", "trigger time {} ms"},
    Words{"TemporalPositionIndex", "time point {}"},
    Words{"TemporalPositionIdentifier", "time point {}"},
    Words{"NominalPercentageOfCardiacPhase", "{} % of the heartbeat"},
    Words{"NominalPercentageOfRespiratoryPhase", "{} % of the breath"},
    Words{"FrameReferenceTime", "frame at {} ms"},
};

std::vector<std::string> valuesOf(std::string_view text) {
    std::vector<std::string> values;
    while (true) {
        const std::size_t end = text.find('\\');
        values.emplace_back(trimmed(text.substr(0, end)));
        if (end == std::string_view::npos) return values;
        text.remove_prefix(end + 1);
    }
}

std::optional<std::vector<double>> numbersOf(std::string_view text) {
    std::vector<double> numbers;
    for (const std::string& value : valuesOf(text)) {
        const auto number = finiteNumber(value);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

// "10:05:30" for "100530" and "19910520100530.25", with enough decimals of a second to tell phases apart.
std::optional<std::string> clockText(std::string_view value) {
    constexpr std::size_t kDateDigits = 8;
    const std::size_t digits = std::min(value.find_first_not_of("0123456789"), value.size());
    std::string_view time = value;
    if (digits > kDateDigits) time.remove_prefix(kDateDigits);
    time = time.substr(0, time.find_first_of("+-"));
    const auto seconds = dicom::secondsOfTime(time);
    if (!seconds || digits == kDateDigits) return std::nullopt;
    const long hundredths = std::lround(*seconds * 100.0);
    std::string text =
        fmt::format("{:02}:{:02}:{:02}", hundredths / 360000, hundredths / 6000 % 60, hundredths / 100 % 60);
    if (hundredths % 100 != 0) text += fmt::format(".{:02}", hundredths % 100);
    return text;
}

// The nearest standard plane, "oblique" if it is off by a degree or more.
std::optional<Text> planeText(std::string_view value) {
    constexpr double kStraight = 0.99985;  // the cosine of a degree
    const auto numbers = numbersOf(value);
    if (!numbers || numbers->size() != 6) return std::nullopt;
    const auto& n = *numbers;
    const glm::dvec3 normal = glm::cross(glm::dvec3(n[0], n[1], n[2]), glm::dvec3(n[3], n[4], n[5]));
    const double length = glm::length(normal);
    if (!(length > 0.5)) return std::nullopt;
    int axis = 0;
    for (const int other : {1, 2})
        if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
    const bool isStraight = std::abs(normal[axis]) / length >= kStraight;
    if (isStraight) return axis == 0 ? Text("sagittal") : axis == 1 ? Text("coronal") : Text("axial");
    return axis == 0 ? Text("oblique sagittal") : axis == 1 ? Text("oblique coronal") : Text("oblique axial");
}

std::optional<Text> spacingText(std::string_view value) {
    const auto numbers = numbersOf(value);
    if (!numbers || numbers->size() != 2) return std::nullopt;
    return Text("pixels {:.4g} × {:.4g} mm", numbers->at(0), numbers->at(1));
}

// Returns "contrast bolus agent" for "ContrastBolusAgent".
std::string takenApart(std::string_view keyword) {
    std::string words;
    for (std::size_t i = 0; i < keyword.size(); ++i) {
        const bool isCapital = std::isupper(static_cast<unsigned char>(keyword[i])) != 0;
        const bool endsWord =
            i > 0 && isCapital &&
            (std::islower(static_cast<unsigned char>(keyword[i - 1])) != 0 ||
             (i + 1 < keyword.size() && std::islower(static_cast<unsigned char>(keyword[i + 1])) != 0));
        if (endsWord) words += ' ';
        const bool isOfAbbreviation =
            isCapital &&
            ((i + 1 < keyword.size() && std::isupper(static_cast<unsigned char>(keyword[i + 1])) != 0) ||
             (i > 0 && !endsWord && std::isupper(static_cast<unsigned char>(keyword[i - 1])) != 0));
        words += isOfAbbreviation ? keyword[i]
                                  : static_cast<char>(std::tolower(static_cast<unsigned char>(keyword[i])));
    }
    return words;
}

// The end of a UID, because UIDs of one series differ in their last components.
std::string endOfUid(const std::string& uid) {
    constexpr std::size_t kMost = 16;
    return uid.size() <= kMost ? uid : "…" + uid.substr(uid.size() - kMost);
}

std::optional<Text> ownTextOf(const dicom::StackLabel& label) {
    if (label.attribute == "AcquisitionTime" || label.attribute == "ContentTime") {
        const auto clock = clockText(label.value);
        return clock ? std::optional(Text("at {}", *clock)) : std::nullopt;
    }
    if (label.attribute == "ImageOrientationPatient") return planeText(label.value);
    if (label.attribute == "PixelSpacing") return spacingText(label.value);
    if (label.attribute == "Localizer") return label.value.empty() ? Text("no localizer") : Text("localizer");
    if (label.attribute.ends_with("UID") && !label.value.empty())
        return Text("{} {}", takenApart(label.attribute), endOfUid(label.value));
    return std::nullopt;
}

}  // namespace

Text textOf(const dicom::StackLabel& label) {
    if (auto own = ownTextOf(label)) return *std::move(own);
    const std::string value = fmt::format("{}", fmt::join(valuesOf(label.value), ", "));
    if (value.empty()) return Text("no {}", takenApart(label.attribute));
    const auto words = std::ranges::find(kWords, label.attribute, &Words::attribute);
    if (words == kWords.end()) return Text("{} {}", takenApart(label.attribute), value);
    return Text::of(words->text, {{{}, value}});
}

}  // namespace macula::study
