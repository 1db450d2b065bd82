#include "segment/distance.h"

#include "segment/itk_image.h"

#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <limits>

#include "base/parallel.h"

namespace macula::segment {

Result<std::vector<float>> distanceTo(const Grid& grid, const Mask& mask) try {
    if (std::find_if(mask.begin(), mask.end(), [](std::uint8_t in) { return in != 0; }) == mask.end())
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

Result<Opened> opened(const Grid& grid, const Mask& mask, double radiusMm) {
    Mask other(mask.size());
    std::transform(mask.begin(), mask.end(), other.begin(),
                   [](std::uint8_t in) { return std::uint8_t(in != 0 ? 0 : 1); });
    MACULA_TRY(std::vector<float> depthMm, distanceTo(grid, other));
    const auto radius = static_cast<float>(radiusMm);
    std::transform(depthMm.begin(), depthMm.end(), other.begin(),
                   [&](float depth) { return std::uint8_t(depth > radius ? 1 : 0); });
    MACULA_TRY(const std::vector<float> toCore, distanceTo(grid, other));
    for (std::size_t n = 0; n < mask.size(); ++n) other[n] = mask[n] != 0 && toCore[n] <= radius ? 1 : 0;
    return Opened{std::move(other), std::move(depthMm)};
}

}  // namespace macula::segment
