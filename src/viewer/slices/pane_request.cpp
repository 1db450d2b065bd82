#include "viewer/slices/pane_request.h"

#include <QCoreApplication>
#include <cmath>
#include <optional>
#include <utility>

#include "pipeline/volume/window.h"
#include "scene/second/dose_lines.h"
#include "slices/interpolated.h"
#include "study/dose/found_dose.h"
#include "viewer/language/window_language.h"
#include "viewer/overlay/slice_texts.h"

namespace macula::viewer {

namespace {

struct PaneRequest {
    Q_DECLARE_TR_FUNCTIONS(PaneRequest)
};

// The index of the other volume's slice in that plane; nothing if its slices are not parallel to it.
std::optional<int> sliceIn(const Volume& volume, const slices::SlicePlane& plane,
                           const glm::dmat4& volumeFromStudy) {
    constexpr double kSameDirection = 1e-4;  // as in SliceSteps
    const glm::dmat4 voxelFromStudy = glm::inverse(volume.worldFromVoxel()) * volumeFromStudy;
    const glm::dvec3 gradient{voxelFromStudy[0][2], voxelFromStudy[1][2], voxelFromStudy[2][2]};
    if (glm::length(glm::cross(glm::normalize(gradient), plane.normal())) > kSameDirection) return {};
    const double at = std::round(transformPoint(voxelFromStudy, plane.centreMm).z);
    return at >= 0.0 && at < volume.size().z ? std::optional(int(at)) : std::nullopt;
}

// Has the second volume's own slice number, if the pane lies in one: the study's numbers count other images.
QString secondPositionText(const PaneContent& content, const scene::SecondVolumeState& state,
                           SliceRequest& request) {
    request.isInterpolated = false;
    if (!state.isLinked()) return PaneRequest::tr("Not in a plane of the study");
    QString text = planeText(content.orientation(), content.steps(), content.slice());
    const std::optional<int> own = sliceIn(*request.volume, request.frame.plane, state.secondFromStudy);
    if (own) {
        text = withNumbers(text, *own, request.volume->size().z, imageNumber(content.second()->study, *own));
        request.isInterpolated = slices::isInterpolated(*request.volume, *own);
    }
    return PaneRequest::tr("In the plane of the study: %1").arg(text);
}

void showSecond(const PaneContent& content, const scene::SecondVolumeState& state, SliceRequest& request) {
    const SecondVolumeTexts& second = *content.second();
    request.volume = second.study.measured();
    request.volumeFromPane = state.secondFromStudy;
    request.shows = state.isLinked() ? SliceShows::second : SliceShows::secondByHand;
    request.window = content.secondWindow();
    request.isInverted = content.state().slices.isInverted != second.study.isLowBright;
    request.colours = slices::ColourTable::grey;
    request.isLowBright = second.study.isLowBright;
    request.segments.reset();  // segments belong to the study's voxels
    request.positionText = secondPositionText(content, state, request);
    request.tags = {second.tag};
    request.names = second.lines;
    request.secondNotes = {linkText(state, second.study.dose.has_value())};
    if (!request.volume->provenance().interpolatedSlices.empty())
        request.secondNotes.push_back(PaneRequest::tr("Some of its slices are interpolated"));
    if (!request.volume->provenance().isCalibrated)
        request.secondNotes.push_back(PaneRequest::tr("The size of its pixels is not calibrated"));
}

void showDose(const dicom::DoseFacts& facts, const study::OpenedStudy& study,
              const scene::SecondVolumeState& state, SliceRequest& request) {
    DoseOver dose{.reference = scene::doseReference(study, state.isodoses), .lines = {}};
    if (state.isodoses && state.isodoses->areShown)
        dose.lines = scene::doseLines(*state.isodoses, dose.reference);
    request.over->dose = std::move(dose);
    request.secondNotes << inWindowsLanguage(study::doseText(facts));
    if (!facts.isInGy()) request.secondNotes << PaneRequest::tr("The dose is relative, and not in Gy");
    if (facts.type == "ERROR") request.secondNotes << PaneRequest::tr("A difference of doses, and no dose");
}

void showSecondOver(const PaneContent& content, const scene::SecondVolumeState& state,
                    SliceRequest& request) {
    const SecondVolumeTexts& second = *content.second();
    request.over = SliceOver{.volume = second.study.measured(),
                             .volumeFromPane = state.secondFromStudy,
                             .window = content.secondWindow(),
                             // Low values shown bright is a custom of films, not of colours.
                             .isInverted = second.study.isLowBright && !isActivity(*second.study.volume),
                             .colours = state.colours,
                             .opacity = state.opacity};
    request.tags.push_back(PaneRequest::tr("In colours: %1").arg(second.tag));
    request.secondNotes = {linkText(state, second.study.dose.has_value())};
    if (const auto& dose = second.study.dose) showDose(*dose, second.study, state, request);
    if (!second.study.measured()->provenance().interpolatedSlices.empty())
        request.secondNotes.push_back(PaneRequest::tr("In colours: some slices are interpolated"));
    if (!second.study.measured()->provenance().isCalibrated)
        request.secondNotes.push_back(PaneRequest::tr("In colours: the size of pixels is not calibrated"));
}

// Adds the second volume to a request for the study.
void addSecond(const PaneContent& content, SliceRequest& request) {
    const scene::SecondVolumeState* state = content.secondState();
    if (state == nullptr) return;
    request.tags = {content.second()->studyTag};
    if (content.wantsSecond()) {
        showSecond(content, *state, request);
    } else if (content.role() == PaneRole::study && state->view == scene::SecondVolumePlace::over &&
               state->isLinked()) {
        showSecondOver(content, *state, request);
    } else {
        return;
    }
    if (!content.second()->patientNote.isEmpty()) request.secondNotes.prepend(content.second()->patientNote);
}

// What was found or placed for the open phase need not fit another one.
void addPhase(const PaneContent& content, SliceRequest& request) {
    if (content.phaseText().isEmpty()) return;
    if (!content.showsOtherPhase()) {
        request.tags.push_back(content.phaseText());
        return;
    }
    request.isOtherPhase = true;
    request.isDifference = content.showsDifference();
    if (request.isDifference) {
        request.isInverted = request.isLowBright = false;
        request.colours = slices::ColourTable::grey;
        request.secondNotes.push_back(PaneRequest::tr("Blue is lower, orange is higher, black has no value"));
    }
    request.tags = {content.phaseText()};
    request.secondNotes.push_back(PaneRequest::tr("Segments are of the open phase, and not shown here"));
    request.segments.reset();
    if (!request.over) return;
    request.tags.push_back(PaneRequest::tr("In colours: %1").arg(content.second()->tag));
    request.secondNotes.push_back(PaneRequest::tr("In colours: placed for the open phase"));
}

}  // namespace

SliceRequest requestFor(const PaneContent& content, const PaneView& view,
                        std::shared_ptr<const slices::ShownSegments> segments, const glm::ivec2& sizePx,
                        double pixelRatio) {
    const study::OpenedStudy& study = content.study();
    const scene::SliceState& state = content.state().slices;
    const SliceSteps& steps = content.steps();
    const int slice = content.slice();
    SliceRequest request{
        .volume = study.measured(),
        .frame = frameOf(view, steps, slice, sizePx, pixelRatio),
        .slab = state.slab,
        .window = content.studyWindow(),
        .isInverted = state.isInverted != study.isLowBright,
        .colours = state.colours.value_or(slices::ColourTable::grey),
        .segments = std::move(segments),
        .positionText = positionText(content.orientation(), steps, slice, imageNumber(study, steps, slice)),
        .isInterpolated = isInterpolated(content.volume(), steps, slice),
        .isLowBright = study.isLowBright,
        .pixelRatio = pixelRatio,
        .crosshairMm = content.crosshairMm()};
    addSecond(content, request);
    if (request.showsStudy()) addPhase(content, request);
    return request;
}

}  // namespace macula::viewer
