#include "viewer/planar/planar_pane.h"

#include <QApplication>
#include <QClipboard>
#include <algorithm>
#include <utility>

#include "viewer/planar/planar_bar.h"
#include "viewer/planar/planar_measuring.h"
#include "viewer/planar/planar_presenting.h"

namespace macula::viewer {

PlanarPane::PlanarPane(PlanarView& view, PlanarBar& bar, QObject* parent)
    : QObject(parent), view_(view), bar_(bar), presenting_(new PlanarPresenting(this)) {
    view_.addLayer(localizer_);
    view_.addLayer(annotations_);
    measuring_ = new PlanarMeasuring(view_);
    connect(&view_, &PlanarView::windowDragged, this, &PlanarPane::dragWindow);
    connect(&view_, &PlanarView::zoomed, this, &PlanarPane::changed);
    connect(&view_, &PlanarView::pointedAt, this, [this](std::optional<QPointF> pixel) {
        pointedAt_ = pixel;
        Q_EMIT labelsNeeded();
    });
    connect(&bar_, &PlanarBar::displayChosen, this, &PlanarPane::chooseDisplay);
    connect(&bar_, &PlanarBar::invertToggled, this, &PlanarPane::invert);
    connect(&bar_, &PlanarBar::turnAsked, this, [this] { turn(false); });
    connect(&bar_, &PlanarBar::mirrorAsked, this, [this] { turn(true); });
    connect(&bar_, &PlanarBar::fitAsked, &view_, &PlanarView::fit);
    connect(&bar_, &PlanarBar::presentationChosen, presenting_, qOverload<int>(&PlanarPresenting::choose));
    connect(&bar_, &PlanarBar::toolChosen, measuring_, &PlanarMeasuring::setTool);
    connect(&bar_, &PlanarBar::overlaysToggled, this, &PlanarPane::showOverlays);
    connect(&bar_, &PlanarBar::removeAllAsked, measuring_, &PlanarMeasuring::removeAll);
    connect(&bar_, &PlanarBar::copyAsked, this,
            [this] { QApplication::clipboard()->setText(measuring_->textsOfFrame()); });
    connect(measuring_, &PlanarMeasuring::toolChanged, this, [this] { bar_.setTool(measuring_->tool()); });
    connect(measuring_, &PlanarMeasuring::changed, this, [this] {
        bar_.setHasMeasurements(!measuring_->all().empty());
        Q_EMIT changed();
    });
    connect(presenting_, &PlanarPresenting::chosenChanged, this, &PlanarPane::present);
    connect(presenting_, &PlanarPresenting::failed, this, &PlanarPane::choicesNeeded);
    bar_.setHasMeasurements(false);
}

void PlanarPane::forget(const study::FoundVolumes* found, const study::PlanarSeries& series,
                        const QString& message) {
    image_.forget();
    placed_.reset();
    pointedAt_.reset();
    localizer_.hide();
    annotations_.show({});
    measuring_->setFrame({});
    measuring_->setAll({});
    presenting_->setSeries(found, series);
    view_.setMessage(message);
    view_.setArea({});
    view_.setTurn({});
    bar_.setInverted(false);
}

void PlanarPane::take(const LoadedImage& image, const dicom::Frame& frame, bool isOfSameLoop) {
    image_.take(image, frame, isOfSameLoop, presenting_->state());
    placeAsPresented();
    measuring_->setFrame(
        {study::imageKey(frame.instance->sopInstanceUid), frame.number, image.header, image.pixels});
    redraw();
}

void PlanarPane::fail(const QString& message) {
    image_.dropImage();
    measuring_->setFrame({});
    annotations_.show({});
    localizer_.hide();
    view_.setMessage(message);
}

void PlanarPane::redraw() {
    if (!hasImage()) return;
    view_.setPicture(image_.picture(), image().header->pixelHeightOverWidth);
    Q_EMIT labelsNeeded();
}

// The chosen presentation state changed: it, or what is stored, takes the place of what a person set.
void PlanarPane::present() {
    image_.present(presenting_->state());
    placed_.reset();
    if (image_.presented() == nullptr) {
        view_.setArea({});
        view_.setTurn({});
    }
    placeAsPresented();
    bar_.setInverted(image_.display().isInverted);
    redraw();
    Q_EMIT choicesNeeded();
    Q_EMIT changed();
}

// A person's turn and zoom stay from image to image, unless the state says otherwise of the next.
void PlanarPane::placeAsPresented() {
    const study::PresentedImage* said = image_.presented();
    annotations_.show(said != nullptr ? said->annotations : std::vector<dicom::SoftcopyAnnotation>());
    if (said == nullptr) return;
    const Placed now{{said->quarters, said->isMirrored}, said->area};
    if (placed_ == now) return;
    placed_ = now;
    std::optional<QRectF> area;
    if (said->area) {
        const QPointF first(said->area->topLeft.x - 1, said->area->topLeft.y - 1);
        const QPointF last(said->area->bottomRight.x, said->area->bottomRight.y);
        area = QRectF(first, last);
    }
    view_.setTurn(now.turn);
    view_.setArea(area);
}

void PlanarPane::setDisplay(const study::PlanarDisplay& display) {
    image_.setDisplay(display);
    redraw();
    Q_EMIT changed();
}

void PlanarPane::tellChoices(bool withNames) {
    QStringList names;
    int chosen = -1;
    for (const NamedDisplay& each : image_.displays()) {
        if (each.display == image_.display()) chosen = int(names.size());
        names += each.name;
    }
    bar_.setDisplays(names, chosen);
    bar_.setPresentations(presenting_->names(withNames), presenting_->chosen());
    bar_.setOverlays(image_.hasOverlays(), image_.overlaysAreShown());
}

void PlanarPane::showOverlays(bool shown) {
    image_.showOverlays(shown);
    redraw();
    Q_EMIT choicesNeeded();
    Q_EMIT changed();
}

void PlanarPane::chooseDisplay(int index) {
    const std::vector<NamedDisplay> all = image_.displays();
    if (index >= 0 && std::size_t(index) < all.size()) setDisplay(all[std::size_t(index)].display);
}

void PlanarPane::dragWindow(QPointF byPx) {
    if (!hasImage() || image().pixels->isColour()) return;
    setDisplay(draggedBy(byPx.x() / view_.width(), byPx.y() / view_.height(), image_.display(),
                         *image().header, *image().pixels));
    Q_EMIT choicesNeeded();
}

void PlanarPane::invert(bool isInverted) {
    image_.setInverted(isInverted);
    bar_.setInverted(isInverted);
    redraw();
    Q_EMIT changed();
}

void PlanarPane::turn(bool isMirroring) {
    PlanarTurn turn = view_.turn();
    if (isMirroring)
        turn.isMirrored = !turn.isMirrored;
    else  // of what is on screen: a mirrored picture turns the other way beneath
        turn.quarters = (turn.quarters + (turn.isMirrored ? 3 : 1)) % 4;
    view_.setTurn(turn);
    pointedAt_.reset();  // the pointer is over another pixel
    Q_EMIT labelsNeeded();
    Q_EMIT changed();
}

QStringList PlanarPane::warnings() const {
    QStringList warnings = changesOf(view_.turn(), image_.display());
    if (!hasImage()) return warnings;
    warnings += image_.notes(presenting_->state() != nullptr);
    if (image_.frame().instance->lossy) warnings += tr("lossily compressed");
    if (const QString size = pixelSizeText(*image().header);
        !size.isEmpty() && image().header->pixelSize->of != dicom::PixelSize::Of::object)
        warnings += size;
    return warnings;
}

void PlanarPane::tell(PlanarLabels labels) {
    labels.warnings = warnings() + labels.warnings;
    if (hasImage()) {
        const dicom::PlanarHeader& header = *image().header;
        if (const QString view = viewText(header); !view.isEmpty()) labels.place += view;
        if (const QString value = image_.valueText(pointedAt_); !value.isEmpty()) labels.display += value;
        const QString shown = displayText(header, image_.display(), image().pixels->isColour());
        if (!shown.isEmpty()) labels.display += shown;
        labels.towards = header.towards;
        labels.setScale(header.pixelSize);
    }
    view_.setLabels(labels);
}

// Under a presentation state, window and place are its.
study::ImagesState PlanarPane::state() const {
    study::ImagesState state{.measurements = measuring_->all()};
    state.overlaysAreShown = image_.overlaysAreShown();
    if (presenting_->state() != nullptr) return state;
    if (image_.isDisplayOwn() && !image_.display().table) state.window = image_.display().window;
    state.isInverted = image_.display().isInverted;
    state.quarters = view_.turn().quarters;
    state.isMirrored = view_.turn().isMirrored;
    state.scale = view_.zoom().scale;
    if (state.scale) state.middlePx = {view_.zoom().middle.x(), view_.zoom().middle.y()};
    return state;
}

void PlanarPane::restore(const study::ImagesState& state) {
    // What a person has drawn meanwhile stays.
    std::vector<study::ImageMeasurement> all = state.measurements;
    for (const study::ImageMeasurement& drawn : measuring_->all())
        if (std::ranges::find(all, drawn) == all.end()) all.push_back(drawn);
    measuring_->setAll(std::move(all));
    image_.showOverlays(state.overlaysAreShown);
    if (presenting_->state() != nullptr) {
        Q_EMIT choicesNeeded();
        return Q_EMIT labelsNeeded();
    }
    if (state.window && !image().pixels->isColour())
        image_.setDisplay({.window = *state.window, .table = {}, .isInverted = state.isInverted});
    invert(state.isInverted);
    view_.setTurn({state.quarters, state.isMirrored});
    view_.setZoom({state.scale, QPointF(state.middlePx.x, state.middlePx.y)});
    Q_EMIT choicesNeeded();
    Q_EMIT labelsNeeded();
}

}  // namespace macula::viewer
