#include "study/planar/planar_presentation.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/parsing.h"
#include "dicom/messages/messages.h"
#include "dicom/read/sop_class.h"
#include "study/open/identity.h"

namespace macula::study {

namespace {

constexpr int kQuarter = 90;

bool refersTo(const std::vector<dicom::ReferencedFrames>& images, const dicom::Frame& frame) {
    return std::ranges::any_of(images, [&](const dicom::ReferencedFrames& image) {
        return image.sopInstanceUid == frame.instance->sopInstanceUid && image.holds(frame.number);
    });
}

// The same among many that are sorted, as PresentationHeading::images.
bool refersToSorted(const std::vector<dicom::ReferencedFrames>& images, const dicom::Frame& frame) {
    const std::string& uid = frame.instance->sopInstanceUid;
    const auto image = std::ranges::lower_bound(images, uid, {}, &dicom::ReferencedFrames::sopInstanceUid);
    return image != images.end() && image->sopInstanceUid == uid && image->holds(frame.number);
}

// A part that names no images is of all of the object.
bool isOf(const std::vector<dicom::ReferencedFrames>& images, const dicom::Frame& frame) {
    return images.empty() || refersTo(images, frame);
}

bool isSame(double a, double b) {
    constexpr double kSameNumber = 1e-6;  // of decimal strings
    return std::abs(a - b) <= kSameNumber * std::max({std::abs(a), std::abs(b), 1.0});
}

// Whether the object's windows are of the values that the frame has.
bool hasItsValues(const dicom::SoftcopyState& said, const dicom::Frame& frame) {
    return !said.hasModalityTable && frame.modalityLut == nullptr && !frame.modalityLutInvalid &&
           !frame.rescaleInvalid && !frame.realWorld && isSame(said.slope, frame.slope.value_or(1.0)) &&
           isSame(said.intercept, frame.intercept.value_or(0.0));
}

// From the lowest to the highest value that the pixels can hold.
DisplayWindow possibleRange(const dicom::Frame& frame, const dicom::PlanarFrame& pixels) {
    const auto& format = frame.instance->format;
    if (!format || format->kind != dicom::CellKind::integer || frame.modalityLut) return wholeRange(pixels);
    const double count = std::exp2(format->bitsStored);
    const double low = format->isSigned ? -0.5 * count : 0.0;
    const double slope = frame.slope.value_or(1.0);
    const double intercept = frame.intercept.value_or(0.0);
    return {.center = slope * (low + 0.5 * (count - 1.0)) + intercept,
            .width = std::abs(slope) * (count - 1.0),
            .explanation = {},
            .function = "LINEAR_EXACT"};
}

class Showing {
  public:
    Showing(const dicom::SoftcopyState& said, const dicom::Frame& frame, const dicom::PlanarHeader& header,
            const dicom::PlanarFrame& pixels)
        : said_(said), frame_(frame), header_(header), pixels_(pixels) {}

    PresentedImage show(const PlanarDisplay& usual) {
        for (const Text& what : said_.leftOutOfImages)
            shown_.notes.push_back(
                dicom::message(dicom::key::kPresentationLeftOut, {{"what", what}}).sentence);
        showValues(usual);
        showPlace();
        shown_.shutter = said_.shutter;
        showOverlays();
        for (const dicom::SoftcopyAnnotation& annotation : said_.annotations.all)
            if (isOf(annotation.images, frame_)) shown_.annotations.push_back(annotation);
        return std::move(shown_);
    }

  private:
    void showValues(const PlanarDisplay& usual) {
        shown_.display = usual;
        if (pixels_.isColour()) return;
        shown_.display.presented.reset();
        shown_.display.isInverted = said_.isInverse != header_.isLowBright;
        const auto meant = std::ranges::find_if(
            said_.windows, [&](const dicom::SoftcopyWindow& window) { return isOf(window.images, frame_); });
        if (!hasItsValues(said_, frame_)) {
            if (meant != said_.windows.end())
                shown_.notes.emplace_back(
                    Text("Its window is of other values than those of the image, and is not shown."));
            return;
        }
        shown_.display.table.reset();
        if (meant == said_.windows.end()) {
            shown_.display.window = possibleRange(frame_, pixels_);
        } else if (meant->window) {
            shown_.display.window = *meant->window;
        } else if (meant->table) {
            shown_.display.presented = std::make_shared<const dicom::VoiTable>(*meant->table);
        } else {
            shown_.display = usual;
            shown_.display.isInverted = said_.isInverse != header_.isLowBright;
            shown_.notes.emplace_back(Text("Its window is a table of values (VOI LUT) that cannot be read."));
        }
    }

    void showPlace() {
        const int turned = (said_.rotationDeg % (4 * kQuarter) + 4 * kQuarter) % (4 * kQuarter);
        if (turned % kQuarter == 0)
            shown_.quarters = turned / kQuarter;
        else
            shown_.notes.emplace_back(
                Text("It turns its images by another angle than quarters, which is not shown."));
        shown_.isMirrored = said_.isFlipped;
        const auto meant = std::ranges::find_if(
            said_.areas, [&](const dicom::DisplayedArea& area) { return isOf(area.images, frame_); });
        if (meant == said_.areas.end()) return;
        shown_.area = *meant;
        if (meant->size != dicom::DisplayedSize::fitted)
            shown_.notes.emplace_back(
                Text("It asks for a size on the screen, which is not shown: its part of the image fits the "
                     "pane."));
    }

    // Of the image those that a layer of the object shows, and the object's own (C.11.7).
    void showOverlays() {
        for (const dicom::OverlayPlane& plane : said_.overlays) {
            if (plane.layer.empty()) continue;
            if (auto own = dicom::maskOf(plane, frame_.number)) {
                shown_.overlays.push_back(*std::move(own));
                continue;
            }
            const auto ofImage = std::ranges::find(pixels_.overlays, plane.group, &dicom::OverlayMask::group);
            if (ofImage != pixels_.overlays.end()) shown_.overlays.push_back(*ofImage);
        }
    }

    const dicom::SoftcopyState& said_;
    const dicom::Frame& frame_;
    const dicom::PlanarHeader& header_;
    const dicom::PlanarFrame& pixels_;
    PresentedImage shown_;
};

}  // namespace

std::vector<ListedPresentation> presentationsOf(const FoundVolumes& found, const PlanarSeries& series) {
    std::vector<std::pair<std::string, ListedPresentation>> all;
    for (const dicom::Study& study : found.scan().studies) {
        if (!dicom::mayBeOnePatient(found.scan(), study.patient, series.study->patient)) continue;
        for (const dicom::Series& each : study.series)
            for (const dicom::OtherObject& object : each.objects) {
                if (object.sopClassUid != dicom::sop_class::kSoftcopyPresentationState ||
                    !object.presentation)
                    continue;
                const dicom::PresentationHeading& heading = *object.presentation;
                if (std::ranges::none_of(series.stack->frames, [&](const dicom::Frame& frame) {
                        return refersToSorted(heading.images, frame);
                    }))
                    continue;
                all.emplace_back(
                    heading.date + heading.time,
                    ListedPresentation{.file = object.file,
                                       .label = std::string(trimmed(heading.label)),
                                       .description = std::string(trimmed(heading.description)),
                                       .creator = nameForPeople(heading.creator),
                                       .date = dateForPeople(std::string(trimmed(heading.date)))});
            }
    }
    std::ranges::stable_sort(all, std::ranges::greater(), [](const auto& each) { return each.first; });
    std::vector<ListedPresentation> listed;
    for (auto& each : all) listed.push_back(std::move(each.second));
    return listed;
}

const dicom::Stack* presentedImages(const dicom::OtherObject& object, int patient,
                                    const FoundVolumes& found) {
    if (object.sopClassUid != dicom::sop_class::kSoftcopyPresentationState || !object.presentation)
        return nullptr;
    const dicom::Stack* best = nullptr;
    std::ptrdiff_t most = 0;
    for (const PlanarSeries& series : planarSeriesOf(found)) {
        if (!dicom::mayBeOnePatient(found.scan(), series.study->patient, patient)) continue;
        const auto count = std::ranges::count_if(series.stack->frames, [&](const dicom::Frame& frame) {
            return refersToSorted(object.presentation->images, frame);
        });
        if (count <= most) continue;
        most = count;
        best = series.stack;
    }
    return best;
}

bool isPresented(const dicom::SoftcopyState& said, const dicom::Frame& frame) {
    return refersTo(said.images, frame);
}

std::optional<PresentedImage> presentedOn(const dicom::SoftcopyState& said, const dicom::Frame& frame,
                                          const dicom::PlanarHeader& header, const dicom::PlanarFrame& pixels,
                                          const PlanarDisplay& usual) {
    if (!isPresented(said, frame)) return {};
    return Showing(said, frame, header, pixels).show(usual);
}

}  // namespace macula::study
