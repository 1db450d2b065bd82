#include "scene/clip/scissor_mask.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/volume/mask_bits.h"
#include "scene/clip/scissor_cut.h"

namespace macula::scene {

namespace {

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

// Atomic, because neighbouring rows and slices share words.
void addBits(MaskBits& bits, std::size_t word, std::uint32_t shown) {
    if (shown != 0) std::atomic_ref(bits.words[word]).fetch_or(shown, std::memory_order_relaxed);
}

// Whether any voxel of the slice is shown.
bool cutSlice(int k, const std::vector<ScissorBlades>& cuts, const MaskBits* before, const Volume& volume,
              MaskBits& bits) {
    const glm::ivec3 size = volume.size();
    const glm::dmat4& worldFromVoxel = volume.worldFromVoxel();
    bool isAnyShown = false;
    std::size_t n = std::size_t(k) * std::size_t(size.y) * std::size_t(size.x);
    for (int j = 0; j < size.y; ++j) {
        const glm::dvec3 firstMm = transformPoint(worldFromVoxel, {0.0, double(j), double(k)});
        std::vector<CutRow> rows;
        rows.reserve(cuts.size());
        for (const ScissorBlades& cut : cuts) {
            CutRow row(cut, firstMm, glm::dvec3(worldFromVoxel[0]), size.x);
            if (!row.removesNothing()) rows.push_back(row);
        }
        std::uint32_t shown = 0;  // bits of the word of voxel n
        for (int i = 0; i < size.x; ++i, ++n) {
            bool isShown = before == nullptr || before->shows(i, j, k);
            for (std::size_t row = 0; isShown && row < rows.size(); ++row) isShown = !rows[row].removes(i);
            if (isShown) shown |= 1u << (n % 32);
            isAnyShown = isAnyShown || isShown;
            if (n % 32 != 31 && i + 1 != size.x) continue;
            addBits(bits, n / 32, std::exchange(shown, 0));
        }
    }
    return isAnyShown;
}

}  // namespace

Result<std::optional<Mask>> scissorMask(std::optional<Mask> before, std::span<const ScissorCut> scissors,
                                        const Volume& volume, Progress& progress) {
    if (scissors.empty()) return before;
    MACULA_CHECK(!before || before->bits);
    std::vector<ScissorBlades> cuts;
    for (const ScissorCut& cut : scissors) {
        MACULA_TRY_VOID(validate(cut));
        cuts.emplace_back(cut);
    }
    try {
        const glm::ivec3 size = volume.size();
        const std::size_t voxels = std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
        MaskBits bits{size, std::vector<std::uint32_t>((voxels + 31) / 32)};
        std::atomic<bool> isAnyShown{false};
        progress.beginStage(Text("Cutting with the scissors"), std::size_t(size.z));
        parallelFor(
            std::size_t(size.z),
            [&](std::size_t k) {
                if (cutSlice(int(k), cuts, before ? before->bits.get() : nullptr, volume, bits))
                    isAnyShown = true;
                progress.advance();
            },
            progress.token());
        if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("The cut was cancelled."), {}, {}};
        if (!isAnyShown)
            return Error{ErrorCode::usage,
                         Text("Nothing of the volume would be left."),
                         {},
                         Text("Draw the outline around less, or keep the inside with Shift.")};
        Mask left;
        left.bits = std::make_shared<const MaskBits>(std::move(bits));
        left.remark = Text("cut with scissors");
        return std::optional<Mask>(std::move(left));
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory,
                     Text("There is not enough memory to cut this volume with the scissors."),
                     {},
                     Text("Close other programs, or clip with a box, planes or a ball.")};
    }
}

}  // namespace macula::scene
