#include "presets/default_preset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "pipeline/volume/transfer_function.h"
#include "pipeline/volume/window.h"
#include "presets/catalogue.h"
#include "presets/seen_values.h"

namespace macula::presets {

namespace {

// Inflated lung lies between -900 and -700 HU; so do foam and partial volume at the skin, but these are few.
constexpr double kLungLowHu = -900.0;
constexpr double kLungHighHu = -700.0;
constexpr double kLeastLungMm3 = 400e3;  // 0.4 litres: one lung of a small adult, or a slab through a chest
constexpr double kLeastFraction = 0.04;

// Distinguishes contrast agent from bone: its values vary little, those of most trabeculae much. A CTA of a
// chest has 102 mL of such blood; a chest without contrast agent 20 mL, in vertebrae, and 250 mL as organs.
constexpr double kMostFlatHu = 25.0;  // standard deviation in a cube
constexpr double kLeastBloodHu = 200.0;
constexpr double kMostBloodHu = 700.0;  // bone and metal are denser
constexpr double kLeastOrganHu = 85.0;  // liver has 40 to 75 HU without contrast agent, 90 to 130 with it
constexpr double kLeastBloodMm3 = 40e3;
constexpr double kLeastOrganMm3 = 500e3;

enum class BodyPart { unsaid, head, teeth, heart, vessels, abdomen, spine, bones, knee };

struct BodyPartWord {
    std::string_view letters;
    bool isWhole;  // false: part of a word is enough: ABDOMEN, CORONARIES, LSPINE
    BodyPart part;
};

// The codes of PS3.16 L and what vendors write instead. The first match counts: HEADNECK is a head, and in a
// chest with abdomen lungs decide.
constexpr auto kBodyPartWords = std::to_array<BodyPartWord>({
    {"JAW", false, BodyPart::teeth},       {"MAXILLA", false, BodyPart::teeth},
    {"MANDIB", false, BodyPart::teeth},    {"DENTA", false, BodyPart::teeth},
    {"TOOTH", false, BodyPart::teeth},     {"TEETH", false, BodyPart::teeth},
    {"HEART", false, BodyPart::heart},     {"CORONAR", false, BodyPart::heart},
    {"CARDIA", false, BodyPart::heart},    {"HEAD", false, BodyPart::head},
    {"BRAIN", false, BodyPart::head},      {"SKULL", false, BodyPart::head},
    {"CRANI", false, BodyPart::head},      {"FACE", false, BodyPart::head},
    {"FACIAL", false, BodyPart::head},     {"ORBIT", false, BodyPart::head},
    {"SINUS", false, BodyPart::head},      {"EAR", true, BodyPart::head},
    {"IAC", true, BodyPart::head},         {"TEMPORAL", false, BodyPart::head},
    {"KNEE", false, BodyPart::knee},       {"SPINE", false, BodyPart::spine},
    {"SPINAL", false, BodyPart::spine},    {"VERTEBRA", false, BodyPart::spine},
    {"LUMBAR", false, BodyPart::spine},    {"CERVICAL", false, BodyPart::spine},
    {"CTA", true, BodyPart::vessels},      {"ANGIO", false, BodyPart::vessels},
    {"AORT", false, BodyPart::vessels},    {"CAROTID", false, BodyPart::vessels},
    {"VESSEL", false, BodyPart::vessels},  {"ARTER", false, BodyPart::vessels},
    {"NECK", false, BodyPart::vessels},    {"CHEST", false, BodyPart::unsaid},
    {"THORA", false, BodyPart::unsaid},    {"LUNG", false, BodyPart::unsaid},
    {"ABD", false, BodyPart::abdomen},     {"STOMACH", false, BodyPart::abdomen},
    {"BOWEL", false, BodyPart::abdomen},   {"GALL", false, BodyPart::abdomen},
    {"BLADDER", false, BodyPart::abdomen}, {"LIVER", false, BodyPart::abdomen},
    {"KIDNEY", false, BodyPart::abdomen},  {"RENAL", false, BodyPart::abdomen},
    {"PANCREA", false, BodyPart::abdomen}, {"SPLEEN", false, BodyPart::abdomen},
    {"COLON", false, BodyPart::abdomen},   {"PELVI", false, BodyPart::bones},
    {"SACRUM", false, BodyPart::bones},    {"HIP", true, BodyPart::bones},
    {"EXTREMIT", false, BodyPart::bones},  {"FOOT", false, BodyPart::bones},
    {"FEET", true, BodyPart::bones},       {"TOE", true, BodyPart::bones},
    {"ANKLE", false, BodyPart::bones},     {"CALCANEUS", false, BodyPart::bones},
    {"LEG", false, BodyPart::bones},       {"TIBIA", false, BodyPart::bones},
    {"FEMUR", false, BodyPart::bones},     {"THIGH", false, BodyPart::bones},
    {"CALF", true, BodyPart::bones},       {"HAND", false, BodyPart::bones},
    {"FINGER", false, BodyPart::bones},    {"THUMB", false, BodyPart::bones},
    {"WRIST", false, BodyPart::bones},     {"ELBOW", false, BodyPart::bones},
    {"FOREARM", false, BodyPart::bones},   {"ARM", true, BodyPart::bones},
    {"HUMERUS", false, BodyPart::bones},   {"SHOULDER", false, BodyPart::bones},
    {"CLAVICLE", false, BodyPart::bones},
});

BodyPart bodyPartOf(std::string_view said) {
    std::string words = " ";  // words in capitals, each between blanks
    for (const char c : said) {
        const bool isSmall = c >= 'a' && c <= 'z';
        const bool isLetter = isSmall || (c >= 'A' && c <= 'Z');
        words += isSmall ? char(c - 'a' + 'A') : isLetter ? c : ' ';
    }
    words += ' ';
    const auto* const found = std::ranges::find_if(kBodyPartWords, [&](const BodyPartWord& word) {
        const std::string letters(word.letters);
        return words.find(word.isWhole ? " " + letters + " " : letters) != std::string::npos;
    });
    return found == kBodyPartWords.end() ? BodyPart::unsaid : found->part;
}

bool hasLungs(const Volume& volume) {
    const auto voxels = volume.voxels();
    const UnitsFromStored hu = volume.unitsFromStored();
    const std::size_t stride =
        std::max<std::size_t>(1, voxels.size() / 200'003);  // a prime, to avoid steps along an axis
    std::size_t seen = 0;
    std::size_t lung = 0;
    for (std::size_t i = 0; i < voxels.size(); i += stride) {
        const double value = hu(voxels[i]);
        ++seen;
        lung += value >= kLungLowHu && value <= kLungHighHu ? 1 : 0;
    }
    const double fraction = static_cast<double>(lung) / static_cast<double>(seen);
    const glm::dvec3 spacing = volume.spacingMm();
    const double volumeMm3 =
        fraction * static_cast<double>(voxels.size()) * spacing.x * spacing.y * spacing.z;
    return fraction > kLeastFraction && volumeMm3 > kLeastLungMm3;
}

// The mean of the 3 x 3 x 3 voxels around one that is not at the edge, if they vary little.
std::optional<double> flatMean(const Volume& volume, int i, int j, int k) {
    constexpr double kVoxels = 27.0;
    const UnitsFromStored hu = volume.unitsFromStored();
    double sum = 0.0;
    double squares = 0.0;
    for (int dk = -1; dk <= 1; ++dk) {
        for (int dj = -1; dj <= 1; ++dj) {
            for (int di = -1; di <= 1; ++di) {
                const double value = hu(volume.stored(i + di, j + dj, k + dk));
                sum += value;
                squares += value * value;
            }
        }
    }
    const double mean = sum / kVoxels;
    const double variance = squares / kVoxels - mean * mean;
    return variance <= kMostFlatHu * kMostFlatHu ? std::optional(mean) : std::nullopt;
}

// The volume of matter whose values vary little.
struct FlatMatter {
    double bloodMm3 = 0.0;   // as dense as blood with contrast agent
    double organsMm3 = 0.0;  // as dense as organs with contrast agent, or as such blood
};

FlatMatter flatMatter(const Volume& volume) {
    constexpr double kMostCubes = 200e3;
    const glm::ivec3 size = volume.size();
    FlatMatter found;
    if (std::min({size.x, size.y, size.z}) < 3) return found;
    const int step = std::max(1, int(std::ceil(std::cbrt(double(volume.voxelCount()) / kMostCubes))));
    const glm::dvec3 spacing = volume.spacingMm();
    const double cubeMm3 = spacing.x * spacing.y * spacing.z * step * step * step;
    for (int k = 1; k < size.z - 1; k += step) {
        for (int j = 1; j < size.y - 1; j += step) {
            for (int i = 1; i < size.x - 1; i += step) {
                const auto mean = flatMean(volume, i, j, k);
                if (!mean || *mean < kLeastOrganHu || *mean > kMostBloodHu) continue;
                found.organsMm3 += cubeMm3;
                if (*mean >= kLeastBloodHu) found.bloodMm3 += cubeMm3;
            }
        }
    }
    return found;
}

std::string usualOfCt(const Volume& volume) {
    return hasLungs(volume) ? "cinematic-chest" : "cinematic-bone";
}

std::string usualTransfer(const Volume& volume) {
    if (volume.unit() == Unit::hounsfield) return usualOfCt(volume);
    const bool isEmission = isActivity(volume) || volume.modality() == "NM";
    if (isEmission) return "cinematic-pet";
    return volume.modality() == "CT" ? "cinematic-micro-ct" : "cinematic-mr";
}

// The tag often describes the protocol, not what was scanned, so the voxels must confirm it. Returns nothing
// if the body part says no more than the kind of images.
std::optional<std::string> transferOfPart(const Volume& volume) {
    const BodyPart part = bodyPartOf(volume.bodyPart());
    if (volume.unit() == Unit::raw && volume.modality() == "MR") {
        // In a head the scalp is visible, not the brain: the usual preset is as good there.
        return part == BodyPart::knee ? std::optional<std::string>("cinematic-mr-knee") : std::nullopt;
    }
    if (volume.unit() != Unit::hounsfield) return std::nullopt;
    switch (part) {
        case BodyPart::unsaid:
            break;
        case BodyPart::head:
            if (!hasLungs(volume)) return "cinematic-head";
            break;
        case BodyPart::teeth:
            if (!hasLungs(volume)) return "cinematic-dental";
            break;
        case BodyPart::heart:
            if (flatMatter(volume).bloodMm3 >= kLeastBloodMm3) return "cinematic-heart";
            break;
        case BodyPart::vessels:
            if (flatMatter(volume).bloodMm3 >= kLeastBloodMm3) return "cinematic-vessels";
            break;
        case BodyPart::abdomen:
            if (flatMatter(volume).organsMm3 >= kLeastOrganMm3) return "cinematic-abdomen";
            break;
        case BodyPart::spine:
            return "cinematic-bone";  // lungs do not contradict a spine
        case BodyPart::bones:
        case BodyPart::knee:
            if (!hasLungs(volume)) return "cinematic-bone";
            break;
    }
    return std::nullopt;
}

bool isMadeFor(const TransferFunction& preset, const Volume& volume) {
    const auto& made = preset.modalities;
    return suits(preset, volume.unit()) && (made.empty() || volume.modality().empty() ||
                                            std::ranges::find(made, volume.modality()) != made.end());
}

}  // namespace

std::string defaultTransfer(const Volume& volume) {
    std::vector<std::string> wanted;
    if (auto ofPart = transferOfPart(volume)) wanted.push_back(*std::move(ofPart));
    wanted.push_back(usualTransfer(volume));
    const auto presets = builtInPresets();
    if (!presets) return wanted.front();
    const SeenValues values(volume);
    for (const std::string& name : wanted) {
        const auto named = std::ranges::find(*presets, name, &TransferFunction::name);
        if (named == presets->end() || values.areSeenWith(*named)) return name;
    }
    const auto next = std::ranges::find_if(*presets, [&](const TransferFunction& preset) {
        return isMadeFor(preset, volume) && validate(preset).ok() && values.areSeenWith(preset);
    });
    return next == presets->end() ? wanted.back() : next->name;
}

}  // namespace macula::presets
