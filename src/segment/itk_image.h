// What the two files that call ITK share.
#pragma once

#include "base/itk_for_clang.h"
#include "base/result.h"
#include "segment/coarse_grid.h"

#include <itkImage.h>
#include <itkImportImageFilter.h>

namespace macula::segment {

using MaskImage = itk::Image<std::uint8_t, 3>;

// The mask itself, not a copy: it has to outlive the image.
inline MaskImage::Pointer imageOf(const Grid& grid, const Mask& mask) {
    const auto import = itk::ImportImageFilter<std::uint8_t, 3>::New();
    MaskImage::RegionType region;
    for (unsigned axis = 0; axis < 3; ++axis) {
        region.SetSize(axis, static_cast<itk::SizeValueType>(grid.size[int(axis)]));
        region.SetIndex(axis, 0);
    }
    import->SetRegion(region);
    const double spacing[3] = {grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z};
    import->SetSpacing(spacing);
    // ITK reads through this pointer and never writes.
    import->SetImportPointer(const_cast<std::uint8_t*>(mask.data()), mask.size(), false);
    import->Update();
    return import->GetOutput();
}

inline Error itkFailed() {
    return {ErrorCode::outOfMemory,
            "The patient could not be told from the table.",
            {},
            "Close other programs, or show the volume with the table."};
}

}  // namespace macula::segment
