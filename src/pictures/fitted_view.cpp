#include "pictures/fitted_view.h"

#include <optional>

#include "pipeline/volume/brick_grid.h"
#include "pipeline/volume/mask_bits.h"
#include "pipeline/volume/medium.h"
#include "pipeline/volume/visible_hull.h"
#include "pipeline/volume/volume_fit.h"
#include "scene/camera/usual_view.h"

namespace macula::pictures {

Camera fittedCamera(std::vector<glm::dvec3> outlineMm, trace::Look look, const Volume& volume,
                    const FittedView& view) {
    if (trace::isProjection(look) || outlineMm.empty()) {
        const auto corners = cornersOf(volume.worldBox());
        outlineMm.assign(corners.begin(), corners.end());
    }
    const auto frame = view.isParallel ? frameInParallel : framePoints;
    const ViewDirection from = scene::firstDirection(view.from, volume);
    return frame(outlineMm, standardBasis(from), view.verticalFovDeg, view.aspectWidthOverHeight);
}

std::vector<glm::dvec3> outlineOnHostMm(const Volume& volume, const TransferFunction& function,
                                        const Clip& clip) {
    const BrickGrid grid = makeBrickGrid(volume);
    std::optional<MaskBits> bits;
    if (clip.mask) bits = maskBits(*clip.mask, volume);
    const MaskBits* mask = bits ? &*bits : nullptr;
    return visibleHullMm(volume, grid, makeMedium(volume, grid, fitted(function, volume), clip, mask), clip,
                         mask);
}

}  // namespace macula::pictures
