#include "segment/patient.h"

#include <algorithm>
#include <new>

#include "base/parallel.h"
#include "segment/coarse_grid.h"
#include "segment/components.h"
#include "segment/distance.h"
#include "segment/messages.h"
#include "segment/table_surface.h"

namespace macula::segment {

namespace {

constexpr double kThickMm = 3.5;  // radius of a ball that fits into a patient, and into no sheet
constexpr double kRimMm = 4.5;    // the depth of the edge that opening removes from the patient
// The layer of air that is kept around the patient, for hair and the edge of the skin.
constexpr double kSkinMm = 4.0;
constexpr double kAppendageMl = 20.0;  // ears and fingers are smaller, sheets and tubes larger
constexpr double kAppendageMm = 80.0;
// The largest ball in a patient has at least this radius, even in a child's wrist.
constexpr double kLeastDepthMm = 8.0;
constexpr double kBodyDepthMm = 12.0;
constexpr double kLeastPatientMl = 5.0;
constexpr double kReportedMl = 1.0;
constexpr std::size_t kSteps = 8;

Error cancelledError() {
    return {ErrorCode::cancelled, Text("Telling the patient from the table was cancelled."), {}, {}};
}

// The thick parts of a mask, with what they enclose.
struct Thick {
    Mask mask;
    Parts parts;
};

Result<Thick> thickOf(const CoarseGrid& coarse, const Mask& dense, const CancelToken& token) {
    Opened thick = opened(coarse.grid, dense, kThickMm);
    MACULA_TRY_VOID(fillEnclosed(coarse.grid, coarse.outside, thick.mask, token));
    MACULA_TRY(Parts parts, partsOf(coarse.grid, thick.mask, false, thick.depthMm));
    return Thick{std::move(thick.mask), std::move(parts)};
}

const Part* largestOf(const Parts& parts) {
    const auto largest = std::max_element(parts.parts.begin(), parts.parts.end(),
                                          [](const Part& a, const Part& b) { return a.blocks < b.blocks; });
    return largest == parts.parts.end() ? nullptr : &*largest;
}

// Whether a part is flat and constant along the couch, as a board or a rail is.
bool isFurniture(const Grid& grid, const Part& part) {
    constexpr double kLongMm = 80.0;
    constexpr double kBoardMm = 100.0;
    constexpr double kFlat = 0.2;  // thickness of a flat part over its width
    constexpr double kPersistent = 0.7;
    const glm::dvec3 extentMm = glm::dvec3(part.high - part.low + 1) * grid.spacingMm;
    const double wide = std::max(extentMm.x, extentMm.y);
    const double crossMm2 =
        double(part.blocks) * grid.spacingMm.x * grid.spacingMm.y / std::max(1, part.high.z - part.low.z + 1);
    const bool flat = wide >= kBoardMm && crossMm2 < kFlat * wide * wide;
    const bool constant =
        extentMm.z >= kLongMm && double(part.persistent) >= kPersistent * double(part.blocks);
    return flat && (constant || part.depthMm < kBodyDepthMm);
}

Text partsText(int parts) {
    return parts == 1 ? Text("1 part") : Text("{} parts", parts);
}

Text volumeText(double ml, bool isCalibrated) {
    return isCalibrated ? Text("{:.0f} mL", ml) : Text("≈ {:.0f} mL, not calibrated", ml);
}

Text said(Confidence confidence) {
    switch (confidence) {
        case Confidence::none:
            return Text("none");
        case Confidence::moderate:
            return Text("moderate");
        case Confidence::high:
            return Text("high");
    }
    return Text("none");
}

// The parts with `isKept`, as a mask.
Mask maskOf(const Parts& parts, const std::vector<char>& isKept) {
    Mask mask(parts.labels.size());
    for (std::size_t n = 0; n < mask.size(); ++n)
        mask[n] = parts.labels[n] != 0 && isKept[parts.labels[n] - 1] != 0 ? 1 : 0;
    return mask;
}

std::vector<char> patientParts(const CoarseGrid& coarse, Parts& parts) {
    countPersistent(coarse.grid, parts);
    constexpr double kLeastSecondMl = 10.0;
    const Part* largest = nullptr;
    for (const Part& part : parts.parts) {
        if (part.depthMm < kLeastDepthMm || isFurniture(coarse.grid, part)) continue;
        if (largest == nullptr || part.blocks > largest->blocks) largest = &part;
    }
    std::vector<char> kept(parts.parts.size());
    if (largest == nullptr || double(largest->blocks) * coarse.blockMl < kLeastPatientMl) return kept;
    for (std::size_t n = 0; n < kept.size(); ++n) {
        const Part& part = parts.parts[n];
        const bool second = part.depthMm >= kLeastDepthMm &&
                            double(part.blocks) * coarse.blockMl >= kLeastSecondMl &&
                            !isFurniture(coarse.grid, part);
        kept[n] = &part == largest || second ? 1 : 0;
    }
    return kept;
}

// Whether a part is an appendage, such as an ear or a finger; not a sheet or a tube.
bool isAppendage(const CoarseGrid& coarse, const Part& part) {
    const glm::dvec3 extentMm = glm::dvec3(part.high - part.low + 1) * coarse.grid.spacingMm;
    return std::max({extentMm.x, extentMm.y, extentMm.z}) <= kAppendageMm &&
           double(part.blocks) * coarse.blockMl <= kAppendageMl;
}

// Adds to the thick parts of the patient what opening removed: the edge, and thin parts that stand out.
Result<void> addThinParts(const CoarseGrid& coarse, const Mask& solid, const Mask& beyond, Mask& patient) {
    const auto isFree = [&](std::size_t n) {
        return solid[n] != 0 && patient[n] == 0 && (beyond.empty() || beyond[n] == 0);
    };
    // The patient's edge is connected to the rest; a cover that lies close to the skin is not.
    const std::vector<float> toCore = distanceTo(coarse.grid, patient);
    Mask withRim = patient;
    for (std::size_t n = 0; n < patient.size(); ++n) {
        if (isFree(n) && toCore[n] <= float(kRimMm)) withRim[n] = 1;
    }
    MACULA_TRY(Parts joined, partsOf(coarse.grid, withRim, false, {}));
    for (std::size_t n = 0; n < patient.size(); ++n) {
        if (patient[n] != 0) joined.parts[joined.labels[n] - 1].touches = true;
    }
    for (std::size_t n = 0; n < patient.size(); ++n)
        patient[n] = joined.labels[n] != 0 && joined.parts[joined.labels[n] - 1].touches ? 1 : 0;

    const double besideMm = 1.5 * std::min(coarse.grid.spacingMm.x, coarse.grid.spacingMm.y);
    const std::vector<float> toPatient = distanceTo(coarse.grid, patient);
    Mask thin(patient.size());
    for (std::size_t n = 0; n < patient.size(); ++n) thin[n] = isFree(n) ? 1 : 0;
    MACULA_TRY(Parts parts, partsOf(coarse.grid, thin, true, {}));
    for (std::size_t n = 0; n < thin.size(); ++n) {
        if (parts.labels[n] != 0 && toPatient[n] <= float(besideMm))
            parts.parts[parts.labels[n] - 1].touches = true;
    }
    for (std::size_t n = 0; n < thin.size(); ++n) {
        if (parts.labels[n] == 0) continue;
        const Part& part = parts.parts[parts.labels[n] - 1];
        if (part.touches && isAppendage(coarse, part)) patient[n] = 1;
    }
    return {};
}

// Widens the patient into the surrounding air, up to half way to anything else. Voxels exactly half way
// become the patient's, whatever the rounding.
Mask withSkin(const CoarseGrid& coarse, const Mask& patient, const Mask& other, const Mask& beyond) {
    const std::vector<float> toPatient = distanceTo(coarse.grid, patient);
    const std::vector<float> toOther = distanceTo(coarse.grid, other);
    constexpr float kRoundingMm = 1e-4f;
    Mask mask(patient.size());
    for (std::size_t n = 0; n < mask.size(); ++n) {
        const bool near = toPatient[n] <= float(kSkinMm) && toPatient[n] <= toOther[n] + kRoundingMm &&
                          (beyond.empty() || beyond[n] == 0);
        mask[n] = patient[n] != 0 || near ? 1 : 0;
    }
    return mask;
}

// The label map of the voxels. Nothing is removed when `mask` is empty.
Result<LabelMap> labelsOf(const Volume& volume, const CoarseGrid& coarse, const Mask& mask,
                          const std::vector<Message>& messages, const CancelToken& token) {
    const glm::ivec3 size = volume.size();
    std::vector<std::uint16_t> labels(volume.voxelCount(), mask.empty() ? PatientMask::kPatient : 0);
    if (!mask.empty()) {
        parallelFor(
            std::size_t(size.z),
            [&](std::size_t k) {
                const auto [fi, fj, fk] = coarse.factor;
                for (int j = 0; j < size.y; ++j) {
                    std::size_t block =
                        k / std::size_t(fk) * coarse.stride[2] + std::size_t(j / fj) * coarse.stride[1];
                    std::uint16_t* out =
                        labels.data() + (k * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x);
                    for (int i = 0; i < size.x; i += fi, block += coarse.stride[0]) {
                        if (mask[block] != 0)
                            std::fill(out + i, out + std::min(i + fi, size.x), PatientMask::kPatient);
                    }
                }
            },
            token);
    }
    if (token.cancelled()) return cancelledError();
    return LabelMap::create(size, volume.worldFromVoxel(),
                            {{.number = PatientMask::kPatient,
                              .label = "Patient",
                              .description = "All but the table and what lies apart from the patient",
                              .algorithm = "AUTOMATIC",
                              .algorithmName = "Macula table removal"}},
                            std::move(labels), messages);
}

Result<PatientMask> allOf(const Volume& volume, const CoarseGrid& coarse, std::string_view key,
                          const CancelToken& token) {
    const std::vector<Message> messages{message(key)};
    MACULA_TRY(LabelMap map, labelsOf(volume, coarse, {}, messages, token));
    const auto confidence = key == key::kNothingToRemove ? Confidence::high : Confidence::none;
    return PatientMask{.map = std::move(map), .messages = messages, .confidence = confidence};
}

class Search {
  public:
    Search(const Volume& volume, Progress& progress) : volume_(volume), progress_(progress) {}

    Result<PatientMask> run() {
        progress_.beginStage(Text("Telling the patient from the table"), kSteps);
        coarse_ = makeCoarseGrid(volume_, token());
        MACULA_TRY_VOID(step());
        readSolid();
        MACULA_TRY(Thick thick, thickOf(coarse_, dense_, token()));
        MACULA_TRY_VOID(step());
        MACULA_TRY_VOID(findTable(thick));
        MACULA_TRY_VOID(step());
        const std::vector<char> kept = patientParts(coarse_, thick.parts);
        if (std::find(kept.begin(), kept.end(), 1) == kept.end()) return whole(key::kNoPatient);

        Mask patient = maskOf(thick.parts, kept);
        MACULA_TRY_VOID(addThinParts(coarse_, solid_, surface_.beyond, patient));
        MACULA_TRY_VOID(step());
        MACULA_TRY_VOID(fillEnclosed(coarse_.grid, coarse_.outside, patient, token()));
        return finish(patient);
    }

  private:
    const CancelToken& token() const { return progress_.token(); }
    Result<void> step() {
        progress_.advance();
        if (token().cancelled()) return cancelledError();
        return {};
    }
    Result<PatientMask> whole(std::string_view key) { return allOf(volume_, coarse_, key, token()); }

    void readSolid() {
        solid_.resize(coarse_.solid.size());
        faint_.resize(coarse_.solid.size());
        dense_.resize(coarse_.solid.size());
        for (std::size_t n = 0; n < solid_.size(); ++n) {
            solid_[n] = coarse_.solid[n] >= 38 ? 1 : 0;  // 15 %: a sheet that fills part of a block
            faint_[n] = coarse_.faint[n] >= 38 ? 1 : 0;
            dense_[n] = coarse_.solid[n] >= 128 ? 1 : 0;  // half
        }
    }

    // Removes everything beyond the surface of a table, and finds the thick parts of the rest.
    Result<void> findTable(Thick& thick) {
        const Part* largest = largestOf(thick.parts);
        if (largest == nullptr) return {};
        std::vector<char> isBody(thick.parts.parts.size());
        for (std::size_t n = 0; n < isBody.size(); ++n) {
            const Part& part = thick.parts.parts[n];
            isBody[n] = part.depthMm >= kBodyDepthMm && 10 * part.blocks >= largest->blocks ? 1 : 0;
        }
        const std::vector<float> toThick = distanceTo(coarse_.grid, thick.mask);
        MACULA_TRY_VOID(step());
        surface_ = findTableSurface(coarse_.grid, faint_, maskOf(thick.parts, isBody), toThick, token());
        if (!surface_.found()) {
            surface_.beyond.clear();
            return {};
        }
        for (std::size_t n = 0; n < dense_.size(); ++n) dense_[n] = surface_.beyond[n] != 0 ? 0 : dense_[n];
        MACULA_TRY(thick, thickOf(coarse_, dense_, token()));
        return {};
    }

    Result<PatientMask> finish(const Mask& patient) {
        Mask other(patient.size());
        std::size_t patientBlocks = 0;
        for (std::size_t n = 0; n < other.size(); ++n) {
            other[n] = solid_[n] != 0 && patient[n] == 0 ? 1 : 0;
            patientBlocks += patient[n];
        }
        const Mask mask = withSkin(coarse_, patient, other, surface_.beyond);
        MACULA_TRY_VOID(step());
        // Reports the volume that is removed: solid, and not in the mask.
        std::transform(other.begin(), other.end(), mask.begin(), other.begin(),
                       [](std::uint8_t in, std::uint8_t kept) { return std::uint8_t(kept != 0 ? 0 : in); });
        MACULA_TRY(Parts removed, partsOf(coarse_.grid, other, true, {}));
        countPersistent(coarse_.grid, removed);
        MACULA_TRY_VOID(step());

        int parts = 0;
        double removedMl = 0.0;
        bool furniture = false;
        for (const Part& part : removed.parts) {
            const double ml = double(part.blocks) * coarse_.blockMl;
            removedMl += ml;
            parts += ml >= kReportedMl ? 1 : 0;
            furniture = furniture || (ml >= kReportedMl && isFurniture(coarse_.grid, part));
        }
        const double patientMl = double(patientBlocks) * coarse_.blockMl;
        if (parts == 0) return whole(key::kNothingToRemove);
        if (removedMl > patientMl) return whole(key::kPatientUncertain);

        const int slices = coarse_.grid.size.z;
        const bool table = furniture || 4 * surface_.slices >= slices;
        const auto confidence = table && 10 * surface_.touchingSlices < slices && removedMl < 0.5 * patientMl
                                    ? Confidence::high
                                    : Confidence::moderate;
        std::vector<Message> messages{
            message(table ? key::kTableRemoved : key::kPartsRemoved,
                    {{"parts", std::int64_t(parts)},
                     {"partsText", partsText(parts)},
                     {"volumeMl", removedMl},
                     {"volumeText", volumeText(removedMl, volume_.provenance().isCalibrated)},
                     {"patientMl", patientMl},
                     {"confidence", said(confidence)}})};
        if (surface_.touchingSlices > 0) {
            messages.push_back(message(
                key::kTableTouchesPatient,
                {{"slices", std::int64_t(surface_.touchingSlices)}, {"total", std::int64_t(slices)}}));
        }
        MACULA_TRY(LabelMap map, labelsOf(volume_, coarse_, mask, messages, token()));
        progress_.advance();
        return PatientMask{.map = std::move(map),
                           .messages = std::move(messages),
                           .tableFound = table,
                           .removedParts = parts,
                           .removedMl = removedMl,
                           .patientMl = patientMl,
                           .confidence = confidence};
    }

    const Volume& volume_;
    Progress& progress_;
    CoarseGrid coarse_;
    Mask solid_;  // anything denser than foam, also where it fills a small part of a block
    Mask faint_;  // the same with kFaintHu, to include the covers of mattresses
    Mask dense_;
    TableSurface surface_;
};

}  // namespace

std::string_view nameOf(Confidence confidence) {
    switch (confidence) {
        case Confidence::none:
            return "none";
        case Confidence::moderate:
            return "moderate";
        case Confidence::high:
            return "high";
    }
    return "none";
}

Result<PatientMask> findPatient(const Volume& volume, Progress& progress) try {
    if (volume.unit() != Unit::hounsfield) {
        return Error{ErrorCode::usage,
                     Text("The table can be left out of CT in Hounsfield units only."),
                     {},
                     Text("Show these images with the table, or cut it away with a clip plane or box.")};
    }
    return Search(volume, progress).run();
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory to tell the patient from the table."),
                 {},
                 Text("Close other programs, or show the volume with the table.")};
}

}  // namespace macula::segment
