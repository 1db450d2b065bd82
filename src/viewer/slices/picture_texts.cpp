#include "viewer/slices/picture_texts.h"

#include <QCoreApplication>
#include <algorithm>
#include <cstddef>
#include <iterator>

#include "scene/drawing/projection_windows.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"
#include "viewer/overlay/slice_texts.h"
#include "viewer/slices/second_volume_texts.h"

namespace macula::viewer {

namespace {

constexpr std::size_t kMostRangesMarked = 8;  // more lines would hide the picture

struct PictureTexts {
    Q_DECLARE_TR_FUNCTIONS(PictureTexts)
};

// For the study only: a note in words covers the second volume.
std::vector<SliceRange> interpolatedRanges(const SliceRequest& shown) {
    if (!shown.showsStudy()) return {};
    return slices::interpolatedIn(*shown.volume, shown.frame, shown.slab);
}

QString interpolatedNote(const SliceRequest& shown, bool areAcquired) {
    if (shown.isInterpolated) return PictureTexts::tr("Interpolated: no image was taken here");
    const std::vector<SliceRange> ranges = interpolatedRanges(shown);
    if (ranges.empty()) return {};
    if (areAcquired) return PictureTexts::tr("Some slices of the slab are interpolated");
    if (ranges.size() > kMostRangesMarked) return PictureTexts::tr("Some of these slices are interpolated");
    return PictureTexts::tr("Interpolated between dashed lines: no image was taken there");
}

QString invertedNote(const SliceRequest& shown) {
    if (!shown.isLowBright) return PictureTexts::tr("Inverted");
    return shown.volume->modality() == "PT" ? PictureTexts::tr("Low values are white, as is custom for PET")
                                            : PictureTexts::tr("Low values are white, as in the images");
}

// Warns that the lines of segments may not be where somebody drew them.
QStringList segmentNotes(const SlicePicture& shown) {
    QStringList notes;
    if (shown.segments.isNull() || !shown.of.segments) return notes;
    if (std::ranges::any_of(*shown.of.segments, &slices::ShownSegment::isResampled))
        notes.push_back(PictureTexts::tr("Segments: nearest voxel of another grid"));
    if (std::ranges::any_of(*shown.of.segments, &slices::ShownSegment::hasFractions))
        notes.push_back(PictureTexts::tr("Segments: fractions of half or more"));
    return notes;
}

// "Liver, Tumour": the segments at that point, of those on screen.
QString segmentText(const SliceRequest& shown, const glm::dvec3& mm) {
    QStringList labels;
    if (!shown.segments) return {};
    for (const std::size_t i : slices::segmentsAt(*shown.volume, mm, *shown.segments))
        labels << harmless(QString::fromStdString(shown.segments->at(i).label));
    return labels.join(QStringLiteral(", "));
}

QString shownWindowText(const SliceRequest& shown) {
    if (!shown.showsStudy()) return secondWindowText(*shown.volume, shown.window);
    return harmless(
        withLocalNumbers(QString::fromStdString(scene::windowText(shown.window, shown.volume->unitName()))));
}

}  // namespace

QStringList notesOf(const SlicePicture& shown, bool areAcquired, bool isMeasuring) {
    QStringList notes = shown.of.secondNotes;
    if (shown.grey.isNull())
        notes.push_back(PictureTexts::tr("No memory for this picture: make the window smaller"));
    if (const QString slab = slabText(shown.of.slab); !slab.isEmpty()) {
        notes.push_back(slab);
        if (!shown.segments.isNull()) notes.push_back(PictureTexts::tr("Segments: middle of the slab"));
    }
    if (!shown.isodoses.empty() && shown.of.slab.thicknessMm > 0.0)
        notes.push_back(PictureTexts::tr("Isodoses: middle of the slab"));
    notes += segmentNotes(shown);
    if (shown.of.isInverted) notes.push_back(invertedNote(shown.of));
    if (const QString interpolated = interpolatedNote(shown.of, areAcquired); !interpolated.isEmpty())
        notes.push_back(interpolated);
    if (!shown.of.showsStudy() && isMeasuring)
        notes.push_back(PictureTexts::tr("Measurements are of the study alone"));
    return notes;
}

QString probedText(const SliceRequest& shown, const QPointF& place) {
    const glm::dvec3 paneMm = shown.worldFromPane(place);
    QString text = probeText(*shown.volume, transformPoint(shown.volumeFromPane, paneMm));
    if (const QString segments = shown.showsStudy() ? segmentText(shown, paneMm) : QString();
        !segments.isEmpty())
        text = PictureTexts::tr("%1, in %2").arg(text, segments);
    return shown.slab.thicknessMm > 0.0 ? PictureTexts::tr("Middle of the slab: %1").arg(text) : text;
}

QString overProbedText(const SliceRequest& shown, const QPointF& place) {
    if (!shown.over) return {};
    const glm::dvec3 mm = transformPoint(shown.over->volumeFromPane, shown.worldFromPane(place));
    if (shown.over->dose) {
        const QString text = doseText(*shown.over->dose, shown.over->volume, mm);
        return shown.slab.thicknessMm > 0.0 ? PictureTexts::tr("Middle of the slab: %1").arg(text) : text;
    }
    return PictureTexts::tr("In colours: %1").arg(probeText(*shown.over->volume, mm));
}

SliceOverlay overlayOf(const SliceRequest& shown, slices::Orientation orientation,
                       const std::optional<QPointF>& pointedAt) {
    SliceOverlay overlay{.orientation = orientation,
                         .frame = shown.frame,
                         .pixelRatio = shown.pixelRatio,
                         .crosshairMm = shown.crosshairMm,
                         .tags = shown.tags,
                         .isCalibrated = shown.volume->provenance().isCalibrated &&
                                         (!shown.over || shown.over->volume->provenance().isCalibrated)};
    if (const auto ranges = interpolatedRanges(shown); ranges.size() <= kMostRangesMarked) {
        for (const SliceRange& range : ranges)
            std::ranges::copy(slices::edgesOf(range, *shown.volume, shown.frame),
                              std::back_inserter(overlay.interpolatedEdges));
    }
    if (shown.over && shown.over->dose)
        overlay.legend =
            legendOf(*shown.over->dose, harmless(QString::fromStdString(shown.over->volume->unitName())));
    if (pointedAt) {
        for (const QString& probed : {overProbedText(shown, *pointedAt), probedText(shown, *pointedAt)})
            if (!probed.isEmpty()) overlay.facts.push_back(probed);
    }
    overlay.facts.push_back(shown.positionText);
    if (shown.over)
        overlay.facts.push_back(PictureTexts::tr("In colours: %1")
                                    .arg(secondWindowText(*shown.over->volume, shown.over->window)));
    overlay.facts.push_back(shownWindowText(shown));
    return overlay;
}

}  // namespace macula::viewer
