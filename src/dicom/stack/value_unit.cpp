#include "dicom/stack/value_unit.h"

#include <algorithm>
#include <array>
#include <vector>

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

// Terms that say what a value is measured in, between blanks: RescaleType (PS3.3 C.11.1.1.2), Units of PET
// (C.8.9.1.1.3), DoseUnits, and the codes of UCUM that maps use (PS3.16 CID 82, 83, 84, 3000, 7180 and
// others).
constexpr std::string_view kUnitTerms =
    " "
    "OD HU_MOD MGML Z_EFF ED EDW PCT NONE CM2 CM2ML PCNT CPS MGMINML UMOLMINML MLMING MLG 1CM "
    "UMOLML PROPCNTS PROPCPS MLMINML MLML STDDEV GY RELATIVE mg/ml mg/mL g/ml g/mL ug/ml kg/m3 "
    "g/cm3 g/l mmol/l umol/ml mm2/s um2/s um2/ms 10*-3.mm2/s 10*-6.mm2/s mm/s cm/s m/s ms s us "
    "min /s 1/s s-1 /min 1/min /ms Hz kHz MHz ppm [ppm] [ppb] rad deg T mT uT mm cm um mm2 cm2 "
    "ml mL ml/s ml/min ml/ml mL/mL ml/100g ml/(100.g) ml/100ml ml/(100.ml) ml/min/100g "
    "ml/min/100ml ml/100g/min ml/100ml/min ml/(min.100.g) ml/min/(100.g) ml/(100.g)/min "
    "ml/(min.ml) ml/min/ml ml/min/g % {ratio} {counts} {counts}/s {propcounts} {propcounts}/s "
    "/cm 1/cm /mm kBq/ml kBq/mL MBq/ml Bq kBq g/ml{SUVlbm} {SUVlbm}g/ml g/ml{SUVbsa} "
    "cm2/ml{SUVbsa} {SUVbsa}cm2/ml g/ml{SUVibw} {SUVibw}g/ml Gy cGy mGy keV kPa Pa N mW/cm2 dB "
    "{Z} {Z_eff} 10*23/ml 10*23.ml-1 ";

bool isKnownTerm(std::string_view name) {
    return !name.empty() && name.find(' ') == std::string_view::npos &&
           kUnitTerms.find(" " + std::string(name) + " ") != std::string_view::npos;
}

// The words of a value of ImageType, in capitals.
std::vector<std::string> wordsOf(std::string_view value) {
    std::vector<std::string> words(1);
    for (const char c : value) {
        const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
        if (upper >= 'A' && upper <= 'Z') {
            words.back() += upper;
        } else if (!words.back().empty()) {
            words.emplace_back();
        }
    }
    return words;
}

// Whether ImageType says that a CT object holds no attenuation: a material, perfusion, atomic number,
// density, or a result computed from several images. Monoenergetic images and those without a material are in
// HU.
bool isMapOfCt(const Frame& frame) {
    constexpr std::array kTerms = std::to_array<std::string_view>(  // PS3.3 C.8.2.1.1.1
        {"MAT_SPECIFIC", "MAT_FRACTIONAL", "MAT_VALUE_BASED", "EFF_ATOMIC_NUM", "ELECTRON_DENSITY"});
    constexpr std::array kWords = std::to_array<std::string_view>(  // PS3.3 C.8.15.3.5, and of vendors
        {"IODINE",      "PERFUSION",    "CBF",
         "CBV",         "MTT",          "TTP",
         "TTD",         "TMAX",         "PMB",
         "PBV",         "BLOOD",        "BLOODFLOW",
         "BLOODVOLUME", "PERMEABILITY", "ZEFF",
         "EFF",         "EFFECTIVE",    "RHO",
         "RHOZ",        "RHOE",         "MATERIAL",
         "URIC",        "URICACID",     "QUANTITY",
         "SUBTRACTION", "DIVISION",     "MULTIPLICATION",
         "DEVIATION",   "ELECTRON"});
    constexpr std::array kOfAttenuation = std::to_array<std::string_view>(
        {"MONOENERGETIC", "MONO", "MONOE", "VMI", "REMOVED", "MODIFIED", "SUPPRESSED", "VNC", "VNCA", "NON"});
    const std::vector<std::string>& type = frame.imageType;
    for (std::size_t v = 2; v < type.size(); ++v) {
        if (std::ranges::find(kTerms, std::string_view(type[v])) != kTerms.end()) return true;
        if (type[0] == "ORIGINAL") continue;  // images that maps are made from have the same words
        const std::vector<std::string> words = wordsOf(type[v]);
        const auto has = [&](const auto& list) {
            return std::ranges::any_of(
                words, [&](std::string_view word) { return std::ranges::find(list, word) != list.end(); });
        };
        if (has(kWords) && !has(kOfAttenuation)) return true;
    }
    return false;
}

}  // namespace

Text whyNoHounsfield(std::span<const Frame> frames) {
    const auto any = [&](auto predicate) { return std::ranges::any_of(frames, predicate); };
    if (any([](const Frame& f) { return !f.modalityLut && !(f.slope && f.intercept); }))
        return Text("no rescale slope and intercept");
    if (std::ranges::all_of(frames, [](const Frame& f) { return isHounsfield(f.rescaleType); })) return {};
    if (any([](const Frame& f) { return !f.rescaleType.empty() && !isHounsfield(f.rescaleType); }))
        return Text("their rescale type is another");
    if (any([](const Frame& f) { return f.modalityLut != nullptr; }))
        return Text("their lookup table does not say what it leads to");
    if (any([](const Frame& f) { return !f.instance->format; }))
        return Text("no usable description of the pixels");
    constexpr int kBitsOfCaptures = 8;
    if (any([](const Frame& f) { return f.instance->format->bitsStored <= kBitsOfCaptures; }))
        return Text("pixels of 8 bits, as of a capture");
    if (any([](const Frame& f) { return !isCtImage(*f.instance); }))
        return Text("they are no CT image objects");
    if (any([](const Frame& f) { return f.rescaleType.empty() && isMapOfCt(f); }))
        return Text("their image type is that of a map, as of a material or of perfusion");
    return {};
}

std::string unitTerm(std::string_view modality, const Frame& frame) {
    // PET names its unit in an attribute of its own (PS3.3 C.8.9.1.1.3), real world values by a UCUM code.
    const bool hasUnits = modality != "CT" && !frame.realWorld && !frame.units.empty();
    const std::string& name = hasUnits ? frame.units : frame.rescaleType;
    if (name.empty() && modality == "CT" && whyNoHounsfield(std::span(&frame, 1)).empty()) return "HU";
    // US is "unspecified", CNTS counts of the scanner.
    if (isOneOf(name, {"US", "CNTS", "1", "[arb'U]"})) return {};
    if (isOneOf(name, {"Bq/ml", "Bq/mL"})) return "BQML";
    return isHounsfield(name) ? "HU" : name;
}

ValueUnit valueUnit(std::string_view modality, std::span<const Frame> frames) {
    const std::string name = unitTerm(modality, frames.front());
    if (std::ranges::any_of(frames, [&](const Frame& f) { return unitTerm(modality, f) != name; })) return {};
    // For an unknown device only the type of the rescale can show that values are HU.
    const bool mayBeHounsfield = modality == "CT" || (modality.empty() && isHounsfield(name));
    if (mayBeHounsfield && whyNoHounsfield(frames).empty()) return {Unit::hounsfield, {}};
    if (name.empty() || (mayBeHounsfield && isHounsfield(name))) return {};
    if (name == "BQML") return {Unit::becquerelsPerMillilitre, {}};
    if (isOneOf(name, {"g/ml{SUVbw}", "{SUVbw}g/ml"})) return {Unit::suvBodyWeight, {}};
    if (modality == "RTDOSE" && name == "GY") return {Unit::other, "Gy"};  // PS3.3 C.8.8.3
    if (modality == "RTDOSE" && name == "RELATIVE") return {Unit::other, "× reference dose"};
    if (name == "GML") return {Unit::other, std::string(kGramsPerMillilitre)};
    if (isHounsfield(name)) return {Unit::other, name};
    return {Unit::other, isKnownTerm(name) ? name : "another unit"};
}

Text unitText(const ValueUnit& unit) {
    return macula::unitText(unit.name.empty() ? unitSymbol(unit.unit) : unit.name);
}

}  // namespace macula::dicom
