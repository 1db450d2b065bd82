#include "scene/presentation/presentation_file.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "dicom/presentation/presentation_state.h"
#include "scene/presentation/presentation_of_state.h"

namespace macula::scene {

Result<PresentedImages> presentedImages(const dicom::Series& series, const dicom::Stack& stack) {
    MACULA_TRY_VOID(dicom::checkReferable(series));
    PresentedImages images;
    images.series.seriesInstanceUid = series.seriesInstanceUid;
    std::map<std::string, std::vector<int>> framesOf;
    std::set<std::string> wholeFiles;
    for (const dicom::Frame& frame : stack.frames) {
        if (images.series.frameOfReferenceUid.empty())
            images.series.frameOfReferenceUid = frame.frameOfReferenceUid;
        const dicom::Instance& image = *frame.instance;
        std::vector<int>& frames = framesOf[image.sopInstanceUid];
        if (frames.empty()) images.series.images.push_back({image.sopClassUid, image.sopInstanceUid});
        frames.push_back(frame.number + 1);
        // A reference to all frames of a file lists none.
        if (int(frames.size()) == image.frames) wholeFiles.insert(image.sopInstanceUid);
    }
    for (dicom::ReferencedImage& image : images.series.images) {
        if (wholeFiles.contains(image.sopInstanceUid)) continue;
        image.frames = std::move(framesOf[image.sopInstanceUid]);
        std::ranges::sort(image.frames);
    }
    const bool isNamed = std::ranges::all_of(images.series.images, [](const dicom::ReferencedImage& image) {
        return !image.sopClassUid.empty() && !image.sopInstanceUid.empty();
    });
    if (stack.frames.empty() || !isNamed || series.seriesInstanceUid.empty() ||
        images.series.frameOfReferenceUid.empty())
        return Error{
            ErrorCode::usage,
            Text("A presentation state refers to DICOM images with identifiers and a frame of reference, "
                 "and this series has none."),
            {},
            Text("Save it as a view.")};
    const dicom::Instance& middle = *stack.frames[stack.frames.size() / 2].instance;
    images.middleFile = middle.file;
    images.middleSopInstanceUid = middle.sopInstanceUid;
    images.suvFactor = stack.suvFactor;
    return images;
}

Result<std::vector<Text>> writePresentation(const std::filesystem::path& path,
                                            const PresentationRequest& request) {
    const std::shared_ptr<const Volume> volume = in16Bits(request.volume);
    MACULA_TRY(SaidState said,
               presentationOf(request.state, *volume, request.aspectWidthOverHeight, request.isDeidentified));
    if (volume->unit() == Unit::suvBodyWeight && request.images.suvFactor) {
        ValueRange& values = said.presentation.palette.values;
        values = {values.low / *request.images.suvFactor, values.high / *request.images.suvFactor};
    }
    said.presentation.series = request.images.series;
    const dicom::NewObject object{
        .image =
            dicom::SecondaryCapture::Source{request.images.middleFile, request.images.middleSopInstanceUid},
        .isDeidentified = request.isDeidentified,
        .softwareVersion = MACULA_VERSION};
    MACULA_TRY_VOID(dicom::writePresentationState(path, said.presentation, object));
    return std::move(said.leftOut);
}

}  // namespace macula::scene
