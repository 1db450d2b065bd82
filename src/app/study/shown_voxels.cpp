#include "app/study/shown_voxels.h"

#include <atomic>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "app/clip/scissor_cut.h"
#include "base/parallel.h"
#include "pipeline/volume/mask_bits.h"

namespace macula::app {

namespace {

constexpr std::uint16_t kShown = 1;
constexpr const char* kLabel = "Left by the scissors";

// One row of voxels under one cut.
class CutRow {
  public:
    CutRow(const ScissorBlades& blades, const glm::dvec3& firstMm, const glm::dvec3& stepMm, int voxels)
        : blades_(blades),
          first_(blades.rays().homogeneous(firstMm)),
          step_(blades.rays().homogeneousStep(stepMm)),
          isClear_(blades.isClearOf(first_, first_ + double(voxels - 1) * step_)) {}

    bool removes(int i) const {
        return isClear_ ? blades_.removesOutside() : blades_.removes(first_ + double(i) * step_);
    }
    bool removesNothing() const { return isClear_ && !blades_.removesOutside(); }

  private:
    const ScissorBlades& blades_;
    glm::dvec3 first_;
    glm::dvec3 step_;
    bool isClear_;
};

// Whether any voxel of the slice is shown.
bool cutSlice(int k, const std::vector<ScissorBlades>& cuts, const MaskBits* others, const Volume& volume,
              std::vector<std::uint16_t>& labels) {
    const glm::ivec3 size = volume.size();
    const glm::dmat4& worldFromVoxel = volume.worldFromVoxel();
    bool isAnyShown = false;
    for (int j = 0; j < size.y; ++j) {
        const glm::dvec3 firstMm = transformPoint(worldFromVoxel, {0.0, double(j), double(k)});
        std::vector<CutRow> rows;
        rows.reserve(cuts.size());
        for (const ScissorBlades& cut : cuts) {
            CutRow row(cut, firstMm, glm::dvec3(worldFromVoxel[0]), size.x);
            if (!row.removesNothing()) rows.push_back(row);
        }
        std::uint16_t* const label =
            labels.data() + (std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x);
        for (int i = 0; i < size.x; ++i) {
            bool isShown = others == nullptr || others->shows(i, j, k);
            for (std::size_t row = 0; isShown && row < rows.size(); ++row) isShown = !rows[row].removes(i);
            if (!isShown) continue;
            label[i] = kShown;
            isAnyShown = true;
        }
    }
    return isAnyShown;
}

}  // namespace

Result<std::optional<Mask>> shownVoxels(std::optional<Mask> others, std::span<const ScissorCut> scissors,
                                        const Volume& volume, Progress& progress) {
    if (scissors.empty()) return others;
    std::vector<ScissorBlades> cuts;
    for (const ScissorCut& cut : scissors) {
        MACULA_TRY_VOID(validate(cut));
        cuts.emplace_back(cut);
    }
    try {
        std::optional<MaskBits> bits;
        if (others) bits = maskBits(*others, volume);
        const glm::ivec3 size = volume.size();
        std::vector<std::uint16_t> labels(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
        std::atomic<bool> isAnyShown{false};
        progress.beginStage("Cutting with the scissors", std::size_t(size.z));
        parallelFor(
            std::size_t(size.z),
            [&](std::size_t k) {
                if (cutSlice(int(k), cuts, bits ? &*bits : nullptr, volume, labels)) isAnyShown = true;
                progress.advance();
            },
            progress.token());
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "The cut was cancelled.", {}, {}};
        if (!isAnyShown)
            return Error{ErrorCode::usage,
                         "Nothing of the volume would be left.",
                         {},
                         "Draw the outline around less, or keep the inside with Shift."};
        Segment left;
        left.number = kShown;
        left.label = kLabel;
        std::vector<Segment> segments{std::move(left)};
        MACULA_TRY(LabelMap map,
                   LabelMap::create(size, volume.worldFromVoxel(), std::move(segments), std::move(labels)));
        return std::optional(Mask{.labels = std::make_shared<const LabelMap>(std::move(map)),
                                  .numbers = {kShown},
                                  .keep = Keep::inside});
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory,
                     "There is not enough memory to cut this volume with the scissors.",
                     {},
                     "Close other programs, or clip with a box, planes or a ball."};
    }
}

bool isCutWithScissors(const Mask& mask) {
    const Segment* left = mask.labels ? mask.labels->segment(kShown) : nullptr;
    return left != nullptr && left->label == kLabel;
}

}  // namespace macula::app
