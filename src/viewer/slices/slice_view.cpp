#include "viewer/slices/slice_view.h"

#include <QPainter>
#include <utility>

#include "viewer/overlay/slice_texts.h"
#include "viewer/slices/pane_request.h"
#include "viewer/slices/picture_texts.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

SliceView::SliceView(StudyEditor& session, slices::Orientation orientation, QWidget* parent, PaneRole role)
    : QWidget(parent),
      session_(session),
      content_(session, orientation, role),
      zoom_(content_),
      travel_(session, content_, zoom_),
      windowing_(session, content_),
      measurements_(session, content_),
      clip_(session),
      turn_(session, content_),
      curve_(session, content_),
      cine_(session, content_, [this] { return isUpToDate(); }),
      hand_({session, zoom_, travel_, windowing_, measurements_, clip_, turn_, curve_}),
      popups_(*this, {session, content_, picture_, zoom_, windowing_, measurements_, hand_}),
      keys_({session, content_, zoom_, travel_, windowing_, measurements_, cine_, hand_, popups_, curve_,
             turn_}),
      painting_({content_, picture_, measurements_, clip_, turn_, curve_}) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setContextMenuPolicy(Qt::PreventContextMenu);  // the right button drags
    setCursor(Qt::CrossCursor);
    setAccessibleName((role == PaneRole::second ? tr("%1 slices of the second volume") : tr("%1 slices"))
                          .arg(nameOf(orientation)));
    setToolTip(tr("%1 slices, in mm. Wheel: next slice; right drag: window; right click: windows")
                   .arg(nameOf(orientation)));
    listen();
    onStudyShown();
}

SliceView::~SliceView() = default;

void SliceView::listen() {
    connect(&session_, &StudyEditor::studyShown, this, &SliceView::onStudyShown);
    connect(&session_, &StudyEditor::changed, this, &SliceView::onChanged);
    connect(&zoom_, &PaneZoom::changed, this, &SliceView::request);
    connect(&zoom_, &PaneZoom::settled, this, &SliceView::viewChanged);
    connect(&picture_, &PanePicture::arrived, this, &SliceView::onPicture);
    connect(&popups_, &SlicePopups::savePictureAsked, this, &SliceView::savePictureAsked);
    connect(&popups_, &SlicePopups::savePlanesAsked, this, &SliceView::savePlanesAsked);
    connect(&cine_, &SliceCine::changed, this, &SliceView::cineChanged);
}

void SliceView::setTool(SliceTool tool) {
    if (tool == hand_.tool()) return;
    hand_.setTool(tool);
    endGesture();
    setCursor(hand_.usualCursor());
}

void SliceView::showClip(bool shown, bool withHandles) {
    if (!clip_.show(shown, withHandles)) return;
    if (hand_.holdsClip()) endGesture();
    setCursor(hand_.usualCursor());
    update();
}

void SliceView::setLines(const QStringList& lines) {
    painting_.setLines(lines);
    update();
}

void SliceView::showNames(bool shown) {
    painting_.showNames(shown);
    update();
}

void SliceView::setSegments(std::shared_ptr<const slices::ShownSegments> segments) {
    if (segments == segments_) return;
    segments_ = std::move(segments);
    request();
}

void SliceView::setSecond(std::shared_ptr<const SecondVolumeTexts> second) {
    content_.setSecond(std::move(second));
    // Releases the picture, which would keep a closed volume in memory.
    if (content_.second() == nullptr && (content_.role() == PaneRole::second || !isVisible()))
        picture_.forget();
    request();
    update();
}

void SliceView::setPhase(std::shared_ptr<const study::OpenedStudy> phase, const QString& text,
                         std::optional<DisplayWindow> ofDifference) {
    content_.setPhase(std::move(phase), text, std::move(ofDifference));
    showLines();
    request();
    update();
}

void SliceView::showArea(const scene::SliceArea& area) {
    zoom_.showArea(area, sizePx());
}

void SliceView::setCine(bool on) {
    if (!on) {
        cine_.stop();
    } else if (isVisible()) {
        cine_.start();
    }
}

void SliceView::onStudyShown() {
    cine_.stop();
    popups_.closeLabel();  // its measurement is gone
    endGesture();
    measurements_.forget();
    segments_.reset();  // segments belong to the earlier study's voxels
    content_.clear();
    // Another phase keeps the zoom and position of the one before. The second volume's pane follows the
    // study's.
    if (!session_.keepsPlace()) zoom_.begin(content_.role() == PaneRole::study);
    picture_.forget();  // a hidden pane must not keep the volume in memory
    showLines();
    if (session_.hasStudy()) {
        content_.takeStudy();
        request();
    }
    setAccessibleDescription(session_.hasStudy() ? QString() : SlicePainting::noStudyText());
    update();
}

void SliceView::showLines() {
    QStringList lines;
    if (session_.hasStudy())
        for (const std::string& line : linesToShow(content_.study().identity))
            lines << QString::fromStdString(line);
    setLines(lines);
}

void SliceView::onChanged(const scene::StudyState& before) {
    if (!content_.hasStudy()) return;
    if (content_.wantsTurn(before.slices)) content_.turnPlanes();
    if (measurements_.follow(before)) hand_.loseHandle();
    request();
    update();
}

void SliceView::request() {
    if (!content_.hasStudy() || !isVisible() || width() < 1 || height() < 1) return;
    zoom_.settle(sizePx());
    picture_.ask(requestFor(content_, zoom_.view(), segments_, sizePx(), devicePixelRatioF()));
}

void SliceView::onPicture() {
    // A drawing that was begun on one slice must not continue on another.
    if (measurements_.isDrawing() && !measurements_.goesOnOver(*picture_.shownRequest())) endGesture();
    setAccessibleDescription(positionText());
    update();
    Q_EMIT pictureShown();
}

void SliceView::endGesture() {
    hand_.end();
    update();
}

std::optional<slices::SliceFrame> SliceView::shownFrame() const {
    return picture_.shown() != nullptr ? std::optional(picture_.shownRequest()->frame) : std::nullopt;
}

QString SliceView::positionText() const {
    return picture_.shown() != nullptr ? picture_.shownRequest()->positionText : QString();
}

QStringList SliceView::tags() const {
    return picture_.shown() != nullptr ? picture_.shownRequest()->tags : QStringList();
}

QStringList SliceView::notes() const {
    if (picture_.shown() == nullptr) return {};
    return notesOf(*picture_.shown(), content_.hasStudy() && content_.steps().areAcquired(),
                   measures(hand_.tool()));
}

QString SliceView::probedText() const {
    if (picture_.shown() == nullptr || !hoverAt_) return {};
    return viewer::probedText(*picture_.shownRequest(), *hoverAt_);
}

QString SliceView::overProbedText() const {
    if (picture_.shown() == nullptr || !hoverAt_) return {};
    return viewer::overProbedText(*picture_.shownRequest(), *hoverAt_);
}

void SliceView::paintEvent(QPaintEvent*) {
    const SliceRequest* wanted = picture_.wanted();
    if (wanted != nullptr && wanted->pixelRatio != devicePixelRatioF()) request();  // on another screen
    QPainter painter(this);
    painting_.paint(painter, rect(), notes(), hoverAt_, hand_.tool() == SliceTool::crosshair);
    if (hoverAt_) painting_.paintRing(painter, *hoverAt_, hand_.ringMm());
    if (hasFocus()) SlicePainting::paintFocus(painter, rect(), palette().color(QPalette::Highlight));
}

}  // namespace macula::viewer
