#include "app/presentation/presentation_file.h"

#include <algorithm>
#include <set>
#include <utility>

#include "app/presentation/presentation_of_state.h"
#include "dicom/presentation/presentation_state.h"

namespace macula::app {

Result<PresentedImages> presentedImages(const dicom::Series& series, const dicom::Stack& stack) {
    PresentedImages images;
    images.series.seriesInstanceUid = series.seriesInstanceUid;
    std::set<std::string> known;
    for (const dicom::Frame& frame : stack.frames) {
        if (images.series.frameOfReferenceUid.empty())
            images.series.frameOfReferenceUid = frame.frameOfReferenceUid;
        const dicom::Instance& image = *frame.instance;
        if (known.insert(image.sopInstanceUid).second)
            images.series.images.push_back({image.sopClassUid, image.sopInstanceUid});
    }
    const bool isNamed = std::ranges::all_of(images.series.images, [](const dicom::ReferencedImage& image) {
        return !image.sopClassUid.empty() && !image.sopInstanceUid.empty();
    });
    if (stack.frames.empty() || !isNamed || series.seriesInstanceUid.empty() ||
        images.series.frameOfReferenceUid.empty())
        return Error{ErrorCode::usage,
                     "A presentation state refers to DICOM images with identifiers and a frame of reference, "
                     "and this series has none.",
                     {},
                     "Save it as a view."};
    const dicom::Instance& middle = *stack.frames[stack.frames.size() / 2].instance;
    images.middleFile = middle.file;
    images.middleSopInstanceUid = middle.sopInstanceUid;
    return images;
}

Result<std::vector<std::string>> writePresentation(const std::filesystem::path& path,
                                                   const PresentationWish& wish) {
    const std::shared_ptr<const Volume> volume = in16Bits(wish.volume);
    MACULA_TRY(SaidState said,
               presentationOf(wish.state, *volume, wish.aspectWidthOverHeight, wish.isDeidentified));
    said.presentation.series = wish.images.series;
    dicom::PresentationOwner owner{.isDeidentified = wish.isDeidentified, .softwareVersion = MACULA_VERSION};
    if (!wish.isDeidentified)
        owner.image =
            dicom::SecondaryCapture::Source{wish.images.middleFile, wish.images.middleSopInstanceUid};
    MACULA_TRY_VOID(dicom::writePresentationState(path, said.presentation, owner));
    return std::move(said.leftOut);
}

}  // namespace macula::app
