#include "segment/itk_filters.h"

#include "base/itk_for_clang.h"

#include <itkConnectedComponentImageFilter.h>
#include <itkImage.h>
#include <itkImportImageFilter.h>

namespace macula::segment {

namespace {

using MaskImage = itk::Image<std::uint8_t, 3>;

// An ITK image over the mask's own memory, not a copy: the mask has to outlive it.
MaskImage::Pointer imageOf(const Grid& grid, const Mask& mask) {
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

Error itkFailed() {
    return {ErrorCode::outOfMemory,
            Text("The patient could not be told from the table."),
            {},
            Text("Close other programs, or show the volume with the table.")};
}

}  // namespace

Result<Labels> connectedParts(const Grid& grid, const Mask& mask, bool corners) try {
    using Filter = itk::ConnectedComponentImageFilter<MaskImage, itk::Image<std::uint32_t, 3>>;
    const auto filter = Filter::New();
    filter->SetInput(imageOf(grid, mask));
    filter->SetFullyConnected(corners);
    filter->Update();
    const std::uint32_t* labels = filter->GetOutput()->GetBufferPointer();
    return Labels{{labels, labels + mask.size()}, filter->GetObjectCount()};
} catch (const itk::ExceptionObject&) {
    return itkFailed();
}

}  // namespace macula::segment
