#include "viewer/planar/planar_controller.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMainWindow>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viewer/editor/study_editor.h"
#include "viewer/language/window_language.h"
#include "viewer/planar/planar_bar.h"

namespace macula::viewer {

namespace {

constexpr double kUsualMs = 100.0;  // of a frame, where the file says no rate

bool isOfSlices(const std::string& modality) {
    return modality == "CT" || modality == "MR" || modality == "PT" || modality == "NM";
}

QImage imageOf(const study::PlanarPicture& picture) {
    const int bytesPerPixel = picture.isColour ? 3 : 1;
    const auto format = picture.isColour ? QImage::Format_RGB888 : QImage::Format_Grayscale8;
    const QImage borrowed(picture.bytes.data(), picture.columns, picture.rows,
                          picture.columns * bytesPerPixel, format);
    return borrowed.copy();
}

}  // namespace

PlanarController::PlanarController(const WindowContext& context, QWidget& beneath)
    : QObject(&context.window),
      context_(context),
      beneath_(beneath),
      widget_(new QWidget),
      view_(new PlanarView),
      bar_(new PlanarBar),
      loader_(new PlanarLoader(this)) {
    auto* column = new QVBoxLayout(widget_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(view_, 1);
    column->addWidget(bar_);
    widget_->hide();
    view_->installEventFilter(this);
    for (QWidget* control : bar_->findChildren<QWidget*>()) control->installEventFilter(this);
    connectParts();
}

void PlanarController::connectParts() {
    connect(loader_, &PlanarLoader::loaded, this, &PlanarController::take);
    connect(loader_, &PlanarLoader::failed, this, &PlanarController::tellFailure);
    connect(view_, &PlanarView::steppedBy, this, &PlanarController::stepBy);
    connect(view_, &PlanarView::windowDragged, this, &PlanarController::dragWindow);
    connect(view_, &PlanarView::pointedAt, this, [this](std::optional<QPointF> pixel) {
        pointedAt_ = pixel;
        tell();
    });
    connect(bar_, &PlanarBar::placeChosen, this, [this](int place) { setPlace(std::size_t(place)); });
    connect(bar_, &PlanarBar::playToggled, this, &PlanarController::setPlaying);
    connect(bar_, &PlanarBar::displayChosen, this, &PlanarController::chooseDisplay);
    connect(bar_, &PlanarBar::invertToggled, this, &PlanarController::invert);
    connect(bar_, &PlanarBar::turnAsked, this, [this] { turn(false); });
    connect(bar_, &PlanarBar::mirrorAsked, this, [this] { turn(true); });
    connect(bar_, &PlanarBar::fitAsked, view_, &PlanarView::fit);
    connect(bar_, &PlanarBar::backAsked, this, &PlanarController::close);
    connect(&player_, &PlanarPlayer::due, this, &PlanarController::playNext);
}

void PlanarController::show(std::shared_ptr<const study::FoundVolumes> found, const dicom::Stack* stack) {
    const study::PlanarSeries series = study::planarSeriesOf(*found, stack);
    if (series.stack == nullptr) return;
    setPlaying(false);
    found_ = std::move(found);
    series_ = series;
    loops_ = study::loopsOf(*series.stack);
    place_ = 0;
    image_.reset();
    display_ = {};
    isDisplayOwn_ = false;
    pointedAt_.reset();
    loader_->setSeries(found_, series.stack);
    // Until the image is read, the view would show the one before, which may be of another patient.
    view_->setMessage(tr("The image is being read…"));
    view_->setTurn({});
    beneath_.hide();
    widget_->show();
    bar_->setCanGoBack(context_.session.hasStudy());
    bar_->setInverted(false);
    tellDisplays();
    Q_EMIT shownChanged();
    setPlace(0);
    view_->setFocus();
}

void PlanarController::close() {
    if (!isShown() || !context_.session.hasStudy()) return;
    setPlaying(false);
    loader_->setSeries(nullptr, nullptr);
    series_ = {};
    found_.reset();
    image_.reset();
    widget_->hide();
    beneath_.show();
    view_->setMessage(QString());
    Q_EMIT shownChanged();
    context_.focusPicture();
}

void PlanarController::showNames(bool shown) {
    namesShown_ = shown;
    tell();
}

std::optional<study::Identity> PlanarController::identity() const {
    return isShown() ? std::optional(study::identityOf(series_)) : std::nullopt;
}

const study::PlanarLoop& PlanarController::loopAt(std::size_t place) const {
    return *std::ranges::find_if(loops_, [&](const study::PlanarLoop& each) { return place < each.end; });
}

void PlanarController::setPlace(std::size_t place) {
    if (!isShown()) return;
    place_ = std::min(place, series_.stack->frames.size() - 1);
    bar_->setPlaces(int(series_.stack->frames.size()), int(place_));
    bar_->setCanPlay(loopAt(place_).end - loopAt(place_).begin > 1);
    loader_->ask(place_);
    tell();
}

void PlanarController::stepBy(int images) {
    if (!isShown()) return;
    setPlaying(false);
    const int last = int(series_.stack->frames.size()) - 1;
    setPlace(std::size_t(std::clamp(int(place_) + images, 0, last)));
}

void PlanarController::take(const LoadedImage& image) {
    if (!isShown() || image.place != place_) return;
    const bool isFirst = !image_;
    const dicom::Frame& frame = series_.stack->frames[place_];
    // A range of values for each frame would make a loop flicker.
    const bool isOfSameLoop = image_ && loopAt(image_->place).begin == loopAt(place_).begin;
    const bool saysHow = !frame.windows.empty() || !image.header->tables.empty();
    image_ = image;
    if (!isDisplayOwn_ && (saysHow || !isOfSameLoop)) {
        const bool isInverted = display_.isInverted;
        display_ = study::usualDisplay(frame, *image.header, *image.pixels);
        display_.isInverted = isInverted;
    }
    if (display_.table && *display_.table >= image.header->tables.size()) display_.table.reset();
    if (isFirst || !isPlaying()) tellDisplays();
    redraw();
    Q_EMIT imageShown();
}

void PlanarController::tellFailure(std::size_t place, const Error& error) {
    if (!isShown() || place != place_) return;
    setPlaying(false);
    image_.reset();
    view_->setMessage(inWindowsLanguage(error));
    tell();
}

void PlanarController::redraw() {
    if (!image_) return;
    const study::PlanarPicture picture = study::pictureOf(*image_->pixels, *image_->header, display_);
    view_->setPicture(imageOf(picture), image_->header->pixelHeightOverWidth);
    tell();
}

void PlanarController::setDisplay(const study::PlanarDisplay& display) {
    display_ = display;
    isDisplayOwn_ = true;
    redraw();
}

std::vector<NamedDisplay> PlanarController::displays() const {
    if (!image_) return {};
    return displaysOf(series_.stack->frames[image_->place], *image_->header, *image_->pixels, display_);
}

void PlanarController::tellDisplays() {
    QStringList names;
    int chosen = -1;
    for (const NamedDisplay& each : displays()) {
        if (each.display == display_) chosen = int(names.size());
        names += each.name;
    }
    bar_->setDisplays(names, chosen);
}

void PlanarController::chooseDisplay(int index) {
    const std::vector<NamedDisplay> all = displays();
    if (index >= 0 && std::size_t(index) < all.size()) setDisplay(all[std::size_t(index)].display);
}

void PlanarController::dragWindow(QPointF byPx) {
    if (!image_ || image_->pixels->isColour()) return;
    setDisplay(draggedBy(byPx.x() / view_->width(), byPx.y() / view_->height(), display_, *image_->header,
                         *image_->pixels));
    tellDisplays();
}

void PlanarController::invert(bool isInverted) {
    display_.isInverted = isInverted;
    bar_->setInverted(isInverted);
    redraw();
}

void PlanarController::turn(bool isMirroring) {
    PlanarTurn turn = view_->turn();
    if (isMirroring)
        turn.isMirrored = !turn.isMirrored;
    else  // of what is on screen: a mirrored picture turns the other way beneath
        turn.quarters = (turn.quarters + (turn.isMirrored ? 3 : 1)) % 4;
    view_->setTurn(turn);
    pointedAt_.reset();  // the pointer is over another pixel
    tell();
}

QStringList PlanarController::warnings() const {
    QStringList warnings = changesOf(view_->turn(), display_);
    if (!image_) return warnings;
    if (series_.stack->frames[image_->place].instance->lossy) warnings += tr("lossily compressed");
    // Of such images a person expects a volume.
    const Message* why = series_.stack->whyNoVolume();
    if (why != nullptr && series_.stack->frames.size() > 1 && isOfSlices(series_.stack->modality))
        warnings += inWindowsLanguage(why->sentence);
    const study::PlanarLoop& of = loopAt(image_->place);
    const bool hasLoop = of.end - of.begin > 1;
    if (hasLoop && image_->header->cine.frameMs.empty())
        warnings += tr("the file says no rate: %1 frames per second").arg(1000.0 / kUsualMs);
    if (const QString size = pixelSizeText(*image_->header);
        !size.isEmpty() && image_->header->pixelSize->of != dicom::PixelSize::Of::object)
        warnings += size;
    return warnings;
}

QString PlanarController::valueText() const {
    if (!pointedAt_ || !image_ || image_->pixels->isColour()) return {};
    const auto column = std::size_t(pointedAt_->x());
    const auto row = std::size_t(pointedAt_->y());
    const bool isIn =
        column < std::size_t(image_->pixels->columns) && row < std::size_t(image_->pixels->rows);
    if (!isIn) return {};
    const float value = image_->pixels->values[row * std::size_t(image_->pixels->columns) + column];
    const QString text =
        std::isfinite(value) ? withLocalNumbers(QString::number(double(value), 'g', 6)) : tr("no value");
    return tr("Column %1, row %2: %3").arg(column + 1).arg(row + 1).arg(text);
}

void PlanarController::tell() {
    if (!isShown()) return;
    PlanarLabels labels;
    const study::Identity identity = study::identityOf(series_);
    if (namesShown_) labels.identity = inWindowsLanguage(study::linesOf(identity));
    // Of what is on screen, while the next is read.
    const std::size_t place = image_ ? image_->place : place_;
    const study::PlanarLoop& of = loopAt(place);
    labels.place = {placeText(int(&of - loops_.data()) + 1, int(loops_.size()), int(place - of.begin) + 1,
                              int(of.end - of.begin))};
    labels.warnings = warnings();
    if (image_) {
        const dicom::PlanarHeader& header = *image_->header;
        QStringList view;
        for (const std::string& word : {header.laterality, header.viewPosition})
            if (!word.empty()) view += QString::fromStdString(word).simplified();
        if (!view.isEmpty()) labels.place += view.join(QLatin1Char(' '));
        if (const QString value = valueText(); !value.isEmpty()) labels.display += value;
        if (const QString shown = displayText(header, display_, image_->pixels->isColour()); !shown.isEmpty())
            labels.display += shown;
        labels.towards = header.towards;
        if (header.pixelSize) {
            labels.mmPerPixel = header.pixelSize->columnMm;
            const dicom::PixelSize::Of held = header.pixelSize->of;
            labels.isCalibrated =
                held == dicom::PixelSize::Of::object || held == dicom::PixelSize::Of::regions;
        }
    }
    view_->setLabels(labels);
}

void PlanarController::setPlaying(bool plays) {
    const bool canPlay = isShown() && loopAt(place_).end - loopAt(place_).begin > 1;
    if (plays && canPlay && !isPlaying()) {
        playsBackwards_ = false;
        loader_->readAhead(loopAt(place_));
        player_.start(msOf(place_));
    } else if (!plays) {
        player_.stop();
        loader_->readAhead({});
    }
    bar_->setPlaying(isPlaying());
}

double PlanarController::msOf(std::size_t place) const {
    const auto frame = std::size_t(series_.stack->frames[place].number);
    const bool isTimed = image_ && frame < image_->header->cine.frameMs.size();
    return (isTimed ? image_->header->cine.frameMs[frame] : kUsualMs) / bar_->speed();
}

void PlanarController::playNext() {
    if (!isUpToDate()) return player_.askAgain();
    const study::PlanarLoop& of = loopAt(place_);
    const bool sweeps = image_->header->cine.sweeps;
    if (sweeps && place_ + 1 == of.end) playsBackwards_ = true;
    if (place_ == of.begin) playsBackwards_ = false;
    std::size_t next = playsBackwards_ ? place_ - 1 : place_ + 1;
    if (next == of.end) next = of.begin;
    setPlace(next);
    player_.holdFor(msOf(place_));
}

bool PlanarController::onKey(int key) {
    constexpr double kZoomOfKey = 1.2;
    const QPointF middle(0.5 * view_->width(), 0.5 * view_->height());
    switch (key) {
        case Qt::Key_Space:
            return setPlaying(!isPlaying()), true;
        case Qt::Key_Up:
        case Qt::Key_PageUp:
        case Qt::Key_Left:
            return stepBy(-1), true;
        case Qt::Key_Down:
        case Qt::Key_PageDown:
        case Qt::Key_Right:
            return stepBy(1), true;
        case Qt::Key_Home:
            return stepBy(-int(place_)), true;
        case Qt::Key_End:
            return stepBy(int(series_.stack->frames.size())), true;
        case Qt::Key_I:
            return invert(!display_.isInverted), true;
        case Qt::Key_R:
            return turn(false), true;
        case Qt::Key_M:
            return turn(true), true;
        case Qt::Key_F:
            return view_->fit(), true;
        case Qt::Key_Plus:
            return view_->zoomBy(kZoomOfKey, middle), true;
        case Qt::Key_Minus:
            return view_->zoomBy(1.0 / kZoomOfKey, middle), true;
        case Qt::Key_Escape:
            return close(), true;
        default:
            return false;
    }
}

// Letters are shortcuts of the window too: over an image they are its own. Controls keep the keys that move
// them.
bool PlanarController::eventFilter(QObject* watched, QEvent* event) {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (isShown() && (isOverride || event->type() == QEvent::KeyPress)) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        constexpr std::array kOwn{Qt::Key_Space, Qt::Key_Up,       Qt::Key_PageUp, Qt::Key_Left,
                                  Qt::Key_Down,  Qt::Key_PageDown, Qt::Key_Right,  Qt::Key_Home,
                                  Qt::Key_End,   Qt::Key_I,        Qt::Key_R,      Qt::Key_M,
                                  Qt::Key_F,     Qt::Key_Plus,     Qt::Key_Minus,  Qt::Key_Escape};
        constexpr std::size_t kOfControls = 9;  // the first of them
        const auto* found = std::ranges::find(kOwn, key.key());
        const Qt::KeyboardModifiers ignored =
            Qt::KeypadModifier | (key.key() == Qt::Key_Plus ? Qt::ShiftModifier : Qt::NoModifier);
        const bool isOwn = (key.modifiers() & ~ignored) == Qt::NoModifier && found != kOwn.end() &&
                           (watched == view_ || std::size_t(found - kOwn.begin()) >= kOfControls);
        if (isOwn && isOverride) return event->accept(), true;
        if (isOwn && onKey(key.key())) return true;
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace macula::viewer
