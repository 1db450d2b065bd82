#include "viewer/slices/slice_view.h"

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "pipeline/volume/window.h"
#include "scene/drawing/projection_windows.h"
#include "scene/slices/window_presets.h"
#include "slices/interpolated.h"
#include "viewer/jobs/post.h"
#include "viewer/language/core_words.h"
#include "viewer/language/harmless_text.h"
#include "viewer/overlay/slice_texts.h"
#include "viewer/slices/clip_on_slice.h"
#include "viewer/slices/label_editor.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

namespace {

constexpr int kCineMs = 100;
constexpr int kWheelPauseMs = 600;
constexpr int kFocusPx = 2;
constexpr int kSecondPx = 2;
const QColor kSecondInk(255, 190, 90);  // of notes over slices
const QColor kQuietInk(150, 150, 150);
constexpr std::size_t kMostRangesMarked = 8;  // lines of more would hide the picture

// Whether both have the same pixels: the cross-hair is drawn over them.
bool samePixels(const SliceRequest& a, SliceRequest b) {
    b.crosshairMm = a.crosshairMm;
    return a == b;
}

bool isFinite(const glm::dvec3& mm) {
    return std::isfinite(mm.x) && std::isfinite(mm.y) && std::isfinite(mm.z);
}

}  // namespace

SliceView::SliceView(StudyEditor& session, slices::Orientation orientation, QWidget* parent, PaneRole role)
    : QWidget(parent), session_(session), orientation_(orientation), role_(role) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setContextMenuPolicy(Qt::PreventContextMenu);  // the right button drags
    setCursor(Qt::CrossCursor);
    setAccessibleName((role == PaneRole::second ? tr("%1 slices of the second volume") : tr("%1 slices"))
                          .arg(nameOf(orientation)));
    setToolTip(tr("%1 slices, in mm. Wheel: next slice; right drag: window; right click: windows")
                   .arg(nameOf(orientation)));
    wheelEnds_.setSingleShot(true);
    wheelEnds_.setInterval(kWheelPauseMs);
    connect(&wheelEnds_, &QTimer::timeout, this, [this] {
        endOwnDrag(tr("Slice"));
        endOwnDrag(tr("Second volume moved"));
    });
    cine_.setInterval(kCineMs);
    connect(&cine_, &QTimer::timeout, this, &SliceView::cineStep);
    connect(&session_, &StudyEditor::studyShown, this, &SliceView::onStudyShown);
    connect(&session_, &StudyEditor::changed, this, &SliceView::onChanged);
    // What comes after this widget is gone is dropped by Qt.
    sampler_ = std::make_unique<SliceSampler>([this](SlicePicture picture) {
        post(this, [this, picture = std::move(picture)] { onPicture(picture); });
    });
    onStudyShown();
}

SliceView::~SliceView() {
    sampler_.reset();
}

void SliceView::setTool(SliceTool tool) {
    if (tool == tool_) return;
    tool_ = tool;
    endGesture();
    setCursor(tool == SliceTool::pan ? Qt::OpenHandCursor : Qt::CrossCursor);
}

void SliceView::showClip(bool shown, bool withHandles) {
    if (shown == showsClip_ && withHandles == hasClipHandles_) return;
    showsClip_ = shown;
    hasClipHandles_ = withHandles;
    if (drag_ == Drag::clip) endGesture();
    setCursor(tool_ == SliceTool::pan ? Qt::OpenHandCursor : Qt::CrossCursor);
    update();
}

void SliceView::setLines(const QStringList& lines) {
    lines_.clear();
    for (const QString& line : lines) {
        const QString shown = harmless(line);
        if (!shown.isEmpty()) lines_.push_back(shown);
    }
    update();
}

void SliceView::showNames(bool shown) {
    namesShown_ = shown;
    update();
}

void SliceView::setSegments(std::shared_ptr<const slices::ShownSegments> segments) {
    if (segments == segments_) return;
    segments_ = std::move(segments);
    request();
}

void SliceView::fit() {
    isFitted_ = true;
    request();
}

void SliceView::applyWindow(int digit) {
    if (!steps_) return;
    if (const auto preset = scene::windowPreset(wantedVolume(), digit)) proposeWindow(preset->window, false);
}

void SliceView::applyOwnWindow(int number) {
    if (!steps_ || own_ == nullptr || number < 1) return;
    const auto own = own_->fitting(wantedVolume());
    if (std::size_t(number) <= own.size()) proposeWindow(own[std::size_t(number) - 1].window, false);
}

void SliceView::onStudyShown() {
    setCine(false);
    delete findChild<LabelEditor*>();  // of a measurement that is gone
    endGesture();
    ++study_;
    wanted_.reset();
    shown_.reset();
    selected_.reset();
    texts_.forget();
    segments_.reset();  // they are of the voxels of the study before
    steps_.reset();
    // Another phase is seen where the one before was. The second volume's pane follows the study's.
    if (!session_.keepsPlace()) isFitted_ = role_ == PaneRole::study;
    SliceRequest nothing;  // a pane that is hidden keeps no volume
    nothing.study = study_;
    sampler_->publish(std::move(nothing));
    QStringList lines;
    for (const std::string& line : linesToShow(session_.study().identity))
        if (session_.hasStudy()) lines << QString::fromStdString(line);
    setLines(lines);
    if (session_.hasStudy()) {
        usualWindow_ = seriesWindow(volume());
        steps_.emplace(volume(), orientation_, session_.state().slices.asAcquired);
        request();
    }
    setAccessibleDescription(session_.hasStudy() ? QString() : tr("No study is open"));
    update();
}

void SliceView::onChanged(const scene::StudyState& before) {
    if (!steps_) return;
    const scene::SliceState& now = session_.state().slices;
    if (now.asAcquired != before.slices.asAcquired) steps_.emplace(volume(), orientation_, now.asAcquired);
    followSelection(before);
    request();
    update();
}

// The same measurement stays selected, whatever came before it in the list or went; one that was only moved
// stays in its place.
void SliceView::followSelection(const scene::StudyState& before) {
    const auto& now = session_.state().measurements;
    if (!selected_ || now == before.measurements) return;
    std::optional<std::size_t> followed;
    if (*selected_ < before.measurements.size()) {
        const auto found = std::ranges::find(now, before.measurements[*selected_]);
        if (found != now.end()) {
            followed = std::size_t(found - now.begin());
        } else if (now.size() == before.measurements.size()) {
            followed = selected_;
        }
    }
    selected_ = followed;
    if (!selected_ && drag_ == Drag::handle) drag_ = Drag::none;
}

void SliceView::request() {
    if (!steps_ || !isVisible() || width() < 1 || height() < 1) return;
    const glm::ivec2 sizePx(width(), height());
    if (isFitted_) view_ = fittedView(volume(), *steps_, sizePx);
    // A pane that follows another has nothing to tell before it was told.
    if (told_ != view_ && (told_ || role_ == PaneRole::study)) {
        told_ = view_;
        emit viewChanged(view_);
    }
    const double ratio = devicePixelRatioF();
    const int slice = this->slice();
    SliceRequest request{.study = study_,
                         .volume = session_.study().measured(),
                         .frame = frameOf(view_, *steps_, slice, sizePx, ratio),
                         .slab = session_.state().slices.slab,
                         .window = studyWindow(),
                         .isInverted = session_.state().slices.isInverted != session_.study().isLowBright,
                         .segments = segments_,
                         .positionText = viewer::positionText(orientation_, *steps_, slice,
                                                              imageNumber(session_.study(), *steps_, slice)),
                         .isInterpolated = isInterpolated(volume(), *steps_, slice),
                         .isLowBright = session_.study().isLowBright,
                         .pixelRatio = ratio,
                         .crosshairMm = crosshairMm()};
    addSecond(request);
    const bool isNew = !wanted_ || !samePixels(*wanted_, request);
    wanted_ = request;
    if (isNew) sampler_->publish(std::move(request));
}

void SliceView::onPicture(SlicePicture picture) {
    if (picture.of.study != study_) return;
    shown_ = std::move(picture);
    // What was begun on one slice does not go on over another.
    if (drawing_) {
        const slices::SlicePlane& drawn = drawing_->plane();
        const slices::SlicePlane& now = shown_->of.frame.plane;
        const double offMm = std::abs(shown_->of.frame.distanceMm(drawn.centreMm));
        if (!showsStudy() || drawn.right != now.right || drawn.down != now.down || offMm > 1e-6) endGesture();
    }
    setAccessibleDescription(positionText());
    update();
    emit pictureShown();
}

glm::dvec3 SliceView::crosshairMm() const {
    const auto& set = session_.state().slices.crosshairMm;
    return set && isFinite(*set) ? *set : middleMm(volume());
}

DisplayWindow SliceView::window() const {
    return wantsSecond() ? secondWindow() : studyWindow();
}

DisplayWindow SliceView::studyWindow() const {
    const auto& set = session_.state().slices.window;
    return set ? *set : usualWindow_;
}

glm::dvec3 SliceView::worldAt(const QPointF& place) const {
    return shown_->of.frame.worldFromPicture(glm::dvec2(place.x(), place.y()) * shown_->of.pixelRatio);
}

bool SliceView::isShownHere(const slices::Measurement& measurement) const {
    return showsStudy() &&
           slices::liesIn(measurement, shown_->of.frame.plane, 0.5 * std::abs(steps_->stepMm()));
}

std::optional<slices::SliceFrame> SliceView::shownFrame() const {
    return shown_ ? std::optional(shown_->of.frame) : std::nullopt;
}

QString SliceView::positionText() const {
    return shown_ ? shown_->of.positionText : QString();
}

QStringList SliceView::notes() const {
    QStringList notes;
    if (!shown_) return notes;
    if (shown_->grey.isNull()) notes.push_back(tr("No memory for this picture: make the window smaller"));
    if (const QString slab = slabText(shown_->of.slab); !slab.isEmpty()) {
        notes.push_back(slab);
        if (!shown_->segments.isNull()) notes.push_back(tr("Segments: middle of the slab"));
    }
    notes += segmentNotes();
    if (shown_->of.isInverted)
        notes.push_back(!shown_->of.isLowBright ? tr("Inverted")
                        : shown_->of.volume->modality() == "PT"
                            ? tr("Low values are white, as is custom for PET")
                            : tr("Low values are white, as in the images"));
    if (const QString interpolated = interpolatedNote(); !interpolated.isEmpty())
        notes.push_back(interpolated);
    if (!showsStudy() && isMeasuring()) notes.push_back(tr("Measurements are of the study alone"));
    return shown_->of.secondNotes + notes;
}

// Of the study; of a second volume it is said in words only.
std::vector<SliceRange> SliceView::shownInterpolated() const {
    if (!shown_ || !showsStudy()) return {};
    return slices::interpolatedIn(*shown_->of.volume, shown_->of.frame, shown_->of.slab);
}

QString SliceView::interpolatedNote() const {
    if (shown_->of.isInterpolated) return tr("Interpolated: no image was taken here");
    const std::vector<SliceRange> ranges = shownInterpolated();
    if (ranges.empty()) return {};
    if (steps_ && steps_->areAcquired()) return tr("Some slices of the slab are interpolated");
    if (ranges.size() > kMostRangesMarked) return tr("Some of these slices are interpolated");
    return tr("Interpolated between dashed lines: no image was taken there");
}

// Their lines are not where somebody drew them.
QStringList SliceView::segmentNotes() const {
    QStringList notes;
    if (shown_->segments.isNull() || !shown_->of.segments) return notes;
    if (std::ranges::any_of(*shown_->of.segments, &slices::ShownSegment::isResampled))
        notes.push_back(tr("Segments: nearest voxel of another grid"));
    if (std::ranges::any_of(*shown_->of.segments, &slices::ShownSegment::hasFractions))
        notes.push_back(tr("Segments: fractions of half or more"));
    return notes;
}

QString SliceView::probedText() const {
    if (!shown_ || !hoverAt_) return {};
    const glm::dvec3 paneMm = worldAt(*hoverAt_);
    QString text = probeText(*shown_->of.volume, transformPoint(shown_->of.volumeFromPane, paneMm));
    if (const QString segments = showsStudy() ? segmentText(paneMm) : QString(); !segments.isEmpty())
        text = tr("%1, in %2").arg(text, segments);
    return shown_->of.slab.thicknessMm > 0.0 ? tr("Middle of the slab: %1").arg(text) : text;
}

// "Liver, Tumour": of those that are on screen.
QString SliceView::segmentText(const glm::dvec3& mm) const {
    QStringList labels;
    if (!shown_->of.segments) return {};
    for (const std::size_t i : slices::segmentsAt(*shown_->of.volume, mm, *shown_->of.segments))
        labels << harmless(QString::fromStdString(shown_->of.segments->at(i).label));
    return labels.join(QStringLiteral(", "));
}

bool SliceView::isUpToDate() const {
    return shown_ && wanted_ && samePixels(shown_->of, *wanted_);
}

void SliceView::paintEvent(QPaintEvent*) {
    if (wanted_ && wanted_->pixelRatio != devicePixelRatioF()) request();  // on another screen now
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!session_.hasStudy()) {
        painter.setPen(kQuietInk);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No study is open"));
    } else if (shown_) {
        paintPicture(painter);
    }
    if (hasFocus()) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), kFocusPx, Qt::SolidLine, Qt::SquareCap,
                            Qt::MiterJoin));
        const int inset = kFocusPx / 2;
        painter.drawRect(rect().adjusted(inset, inset, -inset, -inset));
    }
}

void SliceView::paintPicture(QPainter& painter) {
    const QSizeF logical = QSizeF(shown_->grey.size()) / shown_->of.pixelRatio;
    painter.drawImage(QRectF(QPointF(0.0, 0.0), logical), shown_->grey);
    if (!shown_->segments.isNull()) painter.drawImage(QRectF(QPointF(0.0, 0.0), logical), shown_->segments);
    if (!shown_->colours.isNull()) painter.drawImage(QRectF(QPointF(0.0, 0.0), logical), shown_->colours);
    if (showsClip_ && showsStudy()) {  // it is of the study alone
        const slices::SliceFrame& frame = shown_->of.frame;
        ClipOnSlice clip = clipOnSlice(session_.state(), volume(), frame, hasClipHandles_);
        const auto pointed = hoverAt_ ? clipHandleAt(*hoverAt_) : std::nullopt;
        clip.held = heldClip_ ? heldClip_ : pointed ? std::optional(pointed->handle) : std::nullopt;
        paintClip(painter, size(), clip, frame, shown_->of.pixelRatio, dimming_);
    }
    paintOverlay(painter, size(), overlay());
    if (showsStudy()) return;
    // Nobody may take it for the study, at a glance either.
    painter.setPen(QPen(kSecondInk, kSecondPx, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    const int inset = kFocusPx + kSecondPx / 2;
    painter.drawRect(rect().adjusted(inset, inset, -inset, -inset));
}

SliceOverlay SliceView::overlay() {
    const SliceRequest& of = shown_->of;
    // The cross-hair of the session, unless it may be in a slice that is still on its way.
    const bool isLive = wanted_ && wanted_->frame == of.frame;
    SliceOverlay overlay{.orientation = orientation_,
                         .frame = of.frame,
                         .pixelRatio = of.pixelRatio,
                         .crosshairMm = isLive ? crosshairMm() : of.crosshairMm,
                         .tags = of.tags,
                         .notes = notes(),
                         .measurements = shownMeasurements(),
                         .isCalibrated = of.volume->provenance().isCalibrated &&
                                         (!of.over || of.over->volume->provenance().isCalibrated)};
    if (namesShown_) overlay.names = showsStudy() ? lines_ : of.names;
    if (of.shows == SliceShows::secondByHand) overlay.crosshairMm.reset();
    if (const auto ranges = shownInterpolated(); ranges.size() <= kMostRangesMarked) {
        for (const SliceRange& range : ranges)
            std::ranges::copy(slices::edgesOf(range, *of.volume, of.frame),
                              std::back_inserter(overlay.interpolatedEdges));
    }
    for (const QString& probed : {overProbedText(), probedText()})
        if (!probed.isEmpty()) overlay.facts.push_back(probed);
    overlay.facts.push_back(of.positionText);
    if (of.over)
        overlay.facts.push_back(
            tr("In colours: %1").arg(secondWindowText(*of.over->volume, of.over->window)));
    overlay.facts.push_back(showsStudy() ? harmless(withLocalNumbers(QString::fromStdString(
                                               scene::windowText(of.window, of.volume->unitName()))))
                                         : secondWindowText(*of.volume, of.window));
    return overlay;
}

std::vector<ShownMeasurement> SliceView::shownMeasurements() {
    std::vector<ShownMeasurement> shown;
    const auto& measurements = session_.state().measurements;
    for (std::size_t i = 0; i < measurements.size(); ++i) {
        if (!isShownHere(measurements[i])) continue;
        shown.push_back(
            {.measurement = measurements[i], .text = textOf(measurements[i]), .isSelected = selected_ == i});
    }
    const auto drawn = drawing_ ? drawing_->soFar() : std::nullopt;
    if (drawn) shown.push_back({.measurement = *drawn, .text = textWhileDrawn(*drawn), .isSelected = true});
    return shown;
}

// Values are of the plane, whatever is projected onto it.
QString SliceView::textOf(const slices::Measurement& measurement) {
    const QString text = texts_.of(measurement, volume());
    const bool isOfPlane =
        shown_->of.slab.thicknessMm > 0.0 && std::holds_alternative<slices::Ellipse>(measurement.shape);
    return isOfPlane ? tr("Plane alone: %1").arg(text) : text;
}

// Values are counted once the hand lets go: that takes too long for each of its steps.
QString SliceView::textWhileDrawn(const slices::Measurement& measurement) {
    const auto* ellipse = std::get_if<slices::Ellipse>(&measurement.shape);
    if (ellipse == nullptr) return texts_.of(measurement, volume());
    return sizeText(tr("%1 mm²").arg(std::llround(slices::areaMm2(*ellipse))),
                    volume().provenance().isCalibrated);
}

}  // namespace macula::viewer
