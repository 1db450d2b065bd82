#include "scene/clip/combined_mask.h"

#include <memory>
#include <new>
#include <utility>

#include "pipeline/volume/mask_bits.h"

namespace macula::scene {

Result<std::optional<Mask>> combinedMask(std::span<const Mask> masks, const Volume& volume,
                                         Progress& progress) try {
    if (masks.empty()) return std::optional<Mask>();
    if (masks.size() == 1) return std::optional<Mask>(masks.front());
    progress.beginStage(Text("Hiding voxels"), masks.size());
    MaskBits shown = maskBits(masks.front(), volume);
    std::vector<Text> remarks{masks.front().remark};
    for (const Mask& mask : masks.subspan(1)) {
        progress.advance();
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("Hiding voxels was cancelled."), {}, {}};
        const MaskBits other = maskBits(mask, volume);
        for (std::size_t n = 0; n < shown.words.size(); ++n) shown.words[n] &= other.words[n];
        remarks.push_back(mask.remark);
    }
    Mask all;
    all.bits = std::make_shared<const MaskBits>(std::move(shown));
    all.remark = Text::joined(std::move(remarks), ", ");
    return std::optional<Mask>(std::move(all));
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory,
                 Text("There is not enough memory to hide parts of the volume."),
                 {},
                 Text("Close other programs, or hide less. The picture and what is chosen stay as before.")};
}

}  // namespace macula::scene
