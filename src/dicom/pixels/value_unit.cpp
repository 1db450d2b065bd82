#include "dicom/pixels/value_unit.h"

#include <algorithm>
#include <array>

#include "dicom/read/sop_class.h"

namespace macula::dicom {

namespace {

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

bool isHounsfield(std::string_view rescaleType) {
    return isOneOf(rescaleType, {"HU", "[hnsf'U]"});
}

// Whether a missing rescale type means HU by the SOP class's definition; also for objects that name no class.
bool isCtImage(const Instance& instance) {
    return isOneOf(instance.sopClassUid, {"", sop_class::kCtImage, sop_class::kEnhancedCtImage,
                                          sop_class::kLegacyConvertedEnhancedCtImage});
}

}  // namespace

std::string whyNoHounsfield(std::span<const Frame> frames) {
    const auto any = [&](auto predicate) { return std::ranges::any_of(frames, predicate); };
    if (any([](const Frame& f) { return !f.modalityLut && !(f.slope && f.intercept); }))
        return "no rescale slope and intercept";
    if (std::ranges::all_of(frames, [](const Frame& f) { return isHounsfield(f.rescaleType); })) return {};
    if (any([](const Frame& f) { return !f.rescaleType.empty() && !isHounsfield(f.rescaleType); }))
        return "their rescale type is another";
    if (any([](const Frame& f) { return f.modalityLut != nullptr; }))
        return "their lookup table does not say what it leads to";
    if (any([](const Frame& f) { return !f.instance->format; })) return "no usable description of the pixels";
    constexpr int kBitsOfCaptures = 8;
    if (any([](const Frame& f) { return f.instance->format->bitsStored <= kBitsOfCaptures; }))
        return "pixels of 8 bits, as of a capture";
    if (any([](const Frame& f) { return !isCtImage(*f.instance); })) return "they are no CT image objects";
    return {};
}

ValueUnit valueUnit(std::string_view modality, std::span<const Frame> frames) {
    // PET says it in an attribute of its own (PS3.3 C.8.9.1.1.3), real world values in a code of UCUM.
    const auto nameOf = [](const Frame& frame) {
        return frame.realWorld || frame.units.empty() ? frame.rescaleType : frame.units;
    };
    const std::string name = nameOf(frames.front());
    if (std::ranges::any_of(frames, [&](const Frame& frame) { return nameOf(frame) != name; })) return {};
    // Of an unknown device only the type of the rescale can say so.
    const bool mayBeHounsfield = modality == "CT" || (modality.empty() && isHounsfield(name));
    if (mayBeHounsfield && whyNoHounsfield(frames).empty()) return {Unit::hounsfield, {}};
    if (mayBeHounsfield && isHounsfield(name)) return {};
    if (isOneOf(name, {"BQML", "Bq/ml", "Bq/mL"})) return {Unit::becquerelsPerMillilitre, {}};
    if (isOneOf(name, {"g/ml{SUVbw}", "{SUVbw}g/ml"})) return {Unit::suvBodyWeight, {}};
    if (modality == "RTDOSE" && name == "GY") return {Unit::other, "Gy"};  // PS3.3 C.8.8.3
    if (modality == "RTDOSE" && name == "RELATIVE") return {Unit::other, "of the reference dose"};
    if (name == "GML") return {Unit::other, std::string(kGramsPerMillilitre)};  // of body weight, or of what SUVType says
    // US is "unspecified", CNTS counts of the scanner.
    if (isOneOf(name, {"", "US", "CNTS", "1", "[arb'U]"})) return {};
    return {Unit::other, name};
}

}  // namespace macula::dicom
