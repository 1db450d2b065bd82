#include "dicom/presentation/softcopy_state.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

#include "dicom/read/dataset.h"
#include "dicom/read/presentation_tags.h"
#include "dicom/read/sop_class.h"

namespace macula::dicom {

namespace {

namespace tags = presentation_tag;

constexpr Tag kShutterShape{0x0018, 0x1600};
constexpr Tag kSoftcopyVoiLuts{0x0028, 0x3110};
constexpr Tag kMaskSubtraction{0x0028, 0x6100};
constexpr Tag kFlip{0x0070, 0x0041};
constexpr Tag kRotation{0x0070, 0x0042};
constexpr Tag kTopLeft{0x0070, 0x0052};
constexpr Tag kBottomRight{0x0070, 0x0053};
constexpr Tag kDisplayedAreas{0x0070, 0x005A};
constexpr Tag kPresentationSizeMode{0x0070, 0x0100};
constexpr Tag kPresentationLuts{0x2050, 0x0010};
constexpr Tag kPresentationLutShape{0x2050, 0x0020};
constexpr int kLargestPixel = 65536;

std::vector<ReferencedFrames> imagesOf(const Dataset& item) {
    return referencedFrames(item.items(tags::kReferencedImages));
}

DisplayedSize sizeOf(const Dataset& item) {
    const std::string mode = item.shortText(kPresentationSizeMode);
    if (mode == "TRUE SIZE") return DisplayedSize::trueSize;
    return mode == "MAGNIFY" ? DisplayedSize::magnified : DisplayedSize::fitted;
}

// Nothing if there is no window, or one that shows no value.
std::optional<DisplayWindow> windowOf(const Dataset& item) {
    const std::vector<double> centres = item.shortNumbers(tags::kWindowCenter);
    const std::vector<double> widths = item.shortNumbers(tags::kWindowWidth);
    if (centres.empty() || widths.empty()) return {};
    const std::string function = item.shortText(tags::kVoiLutFunction);
    const double least = function.empty() || function == "LINEAR" ? 1.0 : 0.0;
    const bool isKnown =
        function.empty() || function == "LINEAR" || function == "LINEAR_EXACT" || function == "SIGMOID";
    const bool isUsable = widths.front() > 0.0 && widths.front() >= least;
    if (!isKnown || !isUsable || !std::isfinite(centres.front())) return {};
    return DisplayWindow{
        .center = centres.front(), .width = widths.front(), .explanation = {}, .function = function};
}

void readReferences(const Dataset& file, SoftcopyState& state) {
    for (const Dataset& series : file.items(tag::kReferencedSeries)) {
        if (auto uid = series.text(tag::kSeriesInstanceUid)) state.seriesUids.push_back(std::move(*uid));
        for (ReferencedFrames& image : imagesOf(series)) state.images.push_back(std::move(image));
    }
}

void readValues(const Dataset& file, SoftcopyState& state) {
    state.hasModalityTable = !file.items(tag::kModalityLutSequence).empty();
    state.slope = file.number(tag::kRescaleSlope).value_or(1.0);
    state.intercept = file.number(tag::kRescaleIntercept).value_or(0.0);
    for (const Dataset& item : file.items(kSoftcopyVoiLuts)) {
        SoftcopyWindow window{imagesOf(item), windowOf(item), {}};
        std::vector<VoiTable> tables;
        if (!window.window) tables = readVoiTables(item, state.intercept < 0.0);
        if (!tables.empty()) window.table = std::move(tables.front());
        if (window.window || !item.items(tags::kVoiLutSequence).empty())
            state.windows.push_back(std::move(window));
    }
    state.isInverse = file.text(kPresentationLutShape) == "INVERSE";
    if (!file.items(kPresentationLuts).empty()) state.leftOut.emplace_back(Text("a table of greys"));
}

void readPlace(const Dataset& file, SoftcopyState& state) {
    state.rotationDeg = file.integer(kRotation).value_or(0);
    state.isFlipped = file.text(kFlip) == "Y";
    for (const Dataset& item : file.items(kDisplayedAreas)) {
        const auto first = item.numbers(kTopLeft, 2);
        const auto last = item.numbers(kBottomRight, 2);
        if (!first || !last) continue;
        DisplayedArea area{.images = imagesOf(item), .size = sizeOf(item)};
        bool isUsable = true;
        for (int axis = 0; axis < 2; ++axis) {
            const double low = (*first)[std::size_t(axis)];
            const double high = (*last)[std::size_t(axis)];
            // The area may extend beyond the image, but corners in reverse order would mirror it.
            isUsable = isUsable && low >= -kLargestPixel && high <= kLargestPixel && low <= high;
            if (!isUsable) break;
            area.topLeft[axis] = int(low);
            area.bottomRight[axis] = int(high);
        }
        if (isUsable) {
            state.areas.push_back(std::move(area));
        } else {
            state.leftOut.emplace_back(Text("a displayed area that is none"));
        }
    }
}

bool areDamaged(const std::vector<ReferencedFrames>& images) {
    return std::ranges::any_of(images, &ReferencedFrames::isDamaged);
}

void readMarks(const Dataset& file, SoftcopyState& state) {
    state.annotations = readAnnotations(file);
    state.shutter = readDisplayShutter(file);
    state.overlays = readOverlayPlanes(file);
}

void noteTheRest(const Dataset& file, SoftcopyState& state) {
    if (areDamaged(state.images) || std::ranges::any_of(state.windows, areDamaged, &SoftcopyWindow::images) ||
        std::ranges::any_of(state.areas, areDamaged, &DisplayedArea::images))
        state.leftOut.emplace_back(Text("an unreadable list of frames"));
    if (!file.items(kMaskSubtraction).empty()) state.leftOut.emplace_back(Text("a subtraction of images"));
    state.leftOutOfImages = state.leftOut;
    if (state.annotations.hasOthers) state.leftOutOfImages.emplace_back(Text("annotations of other kinds"));
    if (file.has(kShutterShape) && !state.shutter)
        state.leftOutOfImages.emplace_back(Text("a shutter of another kind"));
    if (!file.items(tags::kGraphicAnnotations).empty()) state.leftOut.emplace_back(Text("annotations"));
    if (file.has(kShutterShape)) state.leftOut.emplace_back(Text("a shutter"));
    for (std::uint16_t group = 0x6000; group <= 0x601E; group += 2) {
        if (!file.has(Tag{group, 0x3000})) continue;
        state.leftOut.emplace_back(Text("an overlay"));
        break;
    }
}

}  // namespace

Result<SoftcopyState> readSoftcopyState(const std::filesystem::path& path) try {
    const HeaderFile read = readHeader(path);
    const auto notUsable = [&](Text message, Text hint) {
        return Error{ErrorCode::inputNotUsable, std::move(message), path.string(), std::move(hint)};
    };
    if (read.state == FileState::unreadable)
        return notUsable(Text("The file cannot be read."), Text("Check the path and its permissions."));
    if (read.state == FileState::notDicom)
        return notUsable(Text("The file is not a DICOM presentation state."),
                         Text("Choose a file of the kind Grayscale Softcopy Presentation State."));
    if (!read.header)
        return notUsable(Text("The presentation state cannot be read."),
                         Text("Copy the file again from its source."));
    const Dataset& file = *read.header;
    if (file.text(tag::kSopClassUid) != sop_class::kSoftcopyPresentationState)
        return notUsable(Text("The file is no presentation state of grey slices."),
                         Text("Choose a file of the kind Grayscale Softcopy Presentation State."));
    SoftcopyState state;
    readReferences(file, state);
    if (state.seriesUids.empty() || state.images.empty())
        return notUsable(Text("The presentation state does not say which images it is of."),
                         Text("Copy the file again from its source, or choose another presentation state."));
    readValues(file, state);
    readPlace(file, state);
    readMarks(file, state);
    noteTheRest(file, state);
    return state;
} catch (const std::bad_alloc&) {
    return Error{ErrorCode::outOfMemory, Text("There is not enough memory for the presentation state."),
                 path.string(), Text("Close other programs.")};
}

}  // namespace macula::dicom
