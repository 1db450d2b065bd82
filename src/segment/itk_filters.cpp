#include "segment/itk_filters.h"

#include "base/itk_for_clang.h"

#include <itkConnectedComponentImageFilter.h>
#include <itkImage.h>
#include <itkImportImageFilter.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <limits>

#include "base/parallel.h"

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
            "The patient could not be told from the table.",
            {},
            "Close other programs, or show the volume with the table."};
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

Result<std::vector<float>> distanceTo(const Grid& grid, const Mask& mask) try {
    if (std::all_of(mask.begin(), mask.end(), [](std::uint8_t in) { return in == 0; }))
        return std::vector<float>(mask.size(), std::numeric_limits<float>::infinity());
    using Filter = itk::SignedMaurerDistanceMapImageFilter<MaskImage, itk::Image<float, 3>>;
    const auto filter = Filter::New();
    filter->SetInput(imageOf(grid, mask));
    filter->SetSquaredDistance(false);
    filter->SetUseImageSpacing(true);
    filter->SetNumberOfWorkUnits(static_cast<itk::ThreadIdType>(coreCount()));
    filter->Update();
    const float* signedMm = filter->GetOutput()->GetBufferPointer();  // negative within
    std::vector<float> mm(mask.size());
    std::transform(signedMm, signedMm + mask.size(), mm.begin(), [](float d) { return std::max(d, 0.0f); });
    return mm;
} catch (const itk::ExceptionObject&) {
    return itkFailed();
}

}  // namespace macula::segment
