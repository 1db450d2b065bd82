#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/planar/planar_controller.h"

#include <QApplication>
#include <QClipboard>
#include <QMainWindow>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "viewer/editor/study_editor.h"
#include "viewer/language/window_language.h"
#include "viewer/planar/kept_images.h"
#include "viewer/planar/planar_bar.h"
#include "viewer/planar/planar_measuring.h"
#include "viewer/planar/planar_presenting.h"
#include "viewer/planar/planar_saving.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

namespace {

constexpr double kUsualMs = 100.0;  // of a frame, where the file says no rate

bool isOfSlices(const std::string& modality) {
    return modality == "CT" || modality == "MR" || modality == "PT" || modality == "NM";
}

}  // namespace

PlanarController::PlanarController(const WindowContext& context, QWidget& beneath)
    : QObject(&context.window),
      context_(context),
      beneath_(beneath),
      widget_(new QWidget),
      view_(new PlanarView),
      bar_(new PlanarBar),
      loader_(new PlanarLoader(this)),
      presenting_(new PlanarPresenting(this)),
      saving_(new PlanarSaving(context)),
      kept_(new KeptImages(this)),
      volumeActions_(context.window) {
    auto* column = new QVBoxLayout(widget_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(view_, 1);
    column->addWidget(bar_);
    widget_->hide();
    view_->addLayer(annotations_);
    measuring_ = new PlanarMeasuring(*view_);
    auto* keys = new PlanarKeys(*view_, *bar_, this);
    connect(keys, &PlanarKeys::pressed, this, &PlanarController::onKey);
    connectParts();
    connectMarks();
}

void PlanarController::connectParts() {
    connect(loader_, &PlanarLoader::loaded, this, &PlanarController::take);
    connect(loader_, &PlanarLoader::failed, this, &PlanarController::tellFailure);
    connect(view_, &PlanarView::steppedBy, this, &PlanarController::stepBy);
    connect(view_, &PlanarView::windowDragged, this, &PlanarController::dragWindow);
    connect(view_, &PlanarView::zoomed, this, &PlanarController::keep);
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

void PlanarController::connectMarks() {
    connect(bar_, &PlanarBar::presentationChosen, presenting_, qOverload<int>(&PlanarPresenting::choose));
    connect(bar_, &PlanarBar::toolChosen, measuring_, &PlanarMeasuring::setTool);
    connect(bar_, &PlanarBar::overlaysToggled, this, &PlanarController::showOverlays);
    connect(bar_, &PlanarBar::saveAsked, this, &PlanarController::saveMeasurements);
    connect(bar_, &PlanarBar::removeAllAsked, measuring_, &PlanarMeasuring::removeAll);
    connect(bar_, &PlanarBar::copyAsked, this,
            [this] { QApplication::clipboard()->setText(measuring_->textsOfFrame()); });
    connect(measuring_, &PlanarMeasuring::toolChanged, this, [this] { bar_->setTool(measuring_->tool()); });
    connect(measuring_, &PlanarMeasuring::changed, this, [this] {
        bar_->setHasMeasurements(!measuring_->all().empty());
        keep();
    });
    connect(presenting_, &PlanarPresenting::chosenChanged, this, &PlanarController::present);
    connect(presenting_, &PlanarPresenting::failed, this,
            [this](const Error& error) { context_.notifications.showError(error); });
    connect(kept_, &KeptImages::found, this, [this](const study::ImagesState& state) {
        left_ = state;
        restore();
    });
    bar_->setHasMeasurements(false);
}

void PlanarController::keepIn(std::shared_ptr<live::StudyKeeper> keeper) {
    kept_->setKeeper(std::move(keeper));
}

void PlanarController::show(std::shared_ptr<const study::FoundVolumes> found, const dicom::Stack* stack) {
    const study::PlanarSeries series = study::planarSeriesOf(*found, stack);
    if (series.stack == nullptr) return;
    setPlaying(false);
    kept_->close();
    found_ = std::move(found);
    series_ = series;
    loops_ = study::loopsOf(*series.stack);
    place_ = 0;
    image_.forget();
    placed_.reset();
    left_.reset();
    annotations_.show({});
    pointedAt_.reset();
    measuring_->setFrame({});
    measuring_->setAll({});
    presenting_->setSeries(found_.get(), series_);
    loader_->setSeries(found_, series.stack);
    // Until the image is read, the view would show the one before, which may be of another patient.
    view_->setMessage(tr("The image is being read…"));
    view_->setArea({});
    view_->setTurn({});
    beneath_.hide();
    widget_->show();
    volumeActions_.setImagesShown(true);
    bar_->setCanGoBack(context_.session.hasStudy());
    bar_->setInverted(false);
    tellDisplays();
    Q_EMIT shownChanged();
    setPlace(0);
    view_->setFocus();
    kept_->open(series_);
}

void PlanarController::close() {
    if (!isShown() || !context_.session.hasStudy()) return;
    setPlaying(false);
    kept_->close();
    loader_->setSeries(nullptr, nullptr);
    series_ = {};
    presenting_->setSeries(nullptr, {});
    measuring_->setFrame({});
    measuring_->setAll({});
    found_.reset();
    image_.forget();
    left_.reset();
    widget_->hide();
    beneath_.show();
    volumeActions_.setImagesShown(false);
    view_->setMessage(QString());
    Q_EMIT shownChanged();
    context_.focusPicture();
}

void PlanarController::showNames(bool shown) {
    namesShown_ = shown;
    tell();
    tellDisplays();
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
    keep();
}

void PlanarController::stepBy(int images) {
    if (!isShown()) return;
    setPlaying(false);
    const int last = int(series_.stack->frames.size()) - 1;
    setPlace(std::size_t(std::clamp(int(place_) + images, 0, last)));
}

void PlanarController::take(const LoadedImage& image) {
    if (!isShown() || image.place != place_) return;
    const bool isFirst = !image_.hasImage();
    const dicom::Frame& frame = series_.stack->frames[place_];
    const bool isOfSameLoop = image_.hasImage() && loopAt(image_.image().place).begin == loopAt(place_).begin;
    image_.take(image, frame, isOfSameLoop, presenting_->state());
    placeAsPresented();
    measuring_->setFrame(
        {study::imageKey(frame.instance->sopInstanceUid), frame.number, image.header, image.pixels});
    if (isFirst || !isPlaying()) tellDisplays();
    redraw();
    if (isFirst) restore();
    Q_EMIT imageShown();
}

void PlanarController::tellFailure(std::size_t place, const Error& error) {
    if (!isShown() || place != place_) return;
    setPlaying(false);
    image_.dropImage();
    measuring_->setFrame({});
    annotations_.show({});
    view_->setMessage(inWindowsLanguage(error));
    tell();
}

void PlanarController::redraw() {
    if (!image_.hasImage()) return;
    view_->setPicture(image_.picture(), image_.image().header->pixelHeightOverWidth);
    tell();
}

// The chosen presentation state changed: it, or what is stored, takes the place of what a person set.
void PlanarController::present() {
    if (!isShown()) return;
    image_.present(presenting_->state());
    placed_.reset();
    if (presenting_->state() == nullptr || image_.presented() == nullptr) {
        view_->setArea({});
        view_->setTurn({});
    }
    placeAsPresented();
    bar_->setInverted(image_.display().isInverted);
    redraw();
    tellDisplays();
    keep();
}

// A person's turn and zoom stay from image to image, unless the state says otherwise of the next.
void PlanarController::placeAsPresented() {
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
    view_->setTurn(now.turn);
    view_->setArea(area);
}

void PlanarController::setDisplay(const study::PlanarDisplay& display) {
    image_.setDisplay(display);
    redraw();
    keep();
}

void PlanarController::tellDisplays() {
    QStringList names;
    int chosen = -1;
    for (const NamedDisplay& each : image_.displays()) {
        if (each.display == display()) chosen = int(names.size());
        names += each.name;
    }
    bar_->setDisplays(names, chosen);
    bar_->setPresentations(presenting_->names(namesShown_), presenting_->chosen());
    bar_->setOverlays(image_.hasOverlays(), image_.overlaysAreShown());
}

void PlanarController::showOverlays(bool shown) {
    image_.showOverlays(shown);
    redraw();
    tellDisplays();
    keep();
}

void PlanarController::chooseDisplay(int index) {
    const std::vector<NamedDisplay> all = image_.displays();
    if (index >= 0 && std::size_t(index) < all.size()) setDisplay(all[std::size_t(index)].display);
}

void PlanarController::dragWindow(QPointF byPx) {
    if (!image_.hasImage() || image_.image().pixels->isColour()) return;
    setDisplay(draggedBy(byPx.x() / view_->width(), byPx.y() / view_->height(), display(),
                         *image_.image().header, *image_.image().pixels));
    tellDisplays();
}

void PlanarController::invert(bool isInverted) {
    image_.setInverted(isInverted);
    bar_->setInverted(isInverted);
    redraw();
    keep();
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
    keep();
}

QStringList PlanarController::warnings() const {
    QStringList warnings = changesOf(view_->turn(), display());
    if (!image_.hasImage()) return warnings;
    warnings += image_.notes(presenting_->state() != nullptr);
    const LoadedImage& image = image_.image();
    if (series_.stack->frames[image.place].instance->lossy) warnings += tr("lossily compressed");
    // Of such images a person expects a volume.
    const Message* why = series_.stack->whyNoVolume();
    if (why != nullptr && series_.stack->frames.size() > 1 && isOfSlices(series_.stack->modality))
        warnings += inWindowsLanguage(why->sentence);
    const study::PlanarLoop& of = loopAt(image.place);
    const bool hasLoop = of.end - of.begin > 1;
    if (hasLoop && image.header->cine.frameMs.empty())
        warnings += tr("the file says no rate: %1 frames per second").arg(1000.0 / kUsualMs);
    if (const QString size = pixelSizeText(*image.header);
        !size.isEmpty() && image.header->pixelSize->of != dicom::PixelSize::Of::object)
        warnings += size;
    return warnings;
}

void PlanarController::tell() {
    if (!isShown()) return;
    PlanarLabels labels;
    const study::Identity identity = study::identityOf(series_);
    if (namesShown_) labels.identity = inWindowsLanguage(study::linesOf(identity));
    // Of what is on screen, while the next is read.
    const std::size_t place = image_.hasImage() ? image_.image().place : place_;
    const study::PlanarLoop& of = loopAt(place);
    labels.place = {placeText(int(&of - loops_.data()) + 1, int(loops_.size()), int(place - of.begin) + 1,
                              int(of.end - of.begin))};
    labels.warnings = warnings();
    if (image_.hasImage()) {
        const dicom::PlanarHeader& header = *image_.image().header;
        if (const QString view = viewText(header); !view.isEmpty()) labels.place += view;
        if (const QString value = image_.valueText(pointedAt_); !value.isEmpty()) labels.display += value;
        const bool isColour = image_.image().pixels->isColour();
        if (const QString shown = displayText(header, display(), isColour); !shown.isEmpty())
            labels.display += shown;
        labels.towards = header.towards;
        labels.setScale(header.pixelSize);
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
    const bool isTimed = image_.hasImage() && frame < image_.image().header->cine.frameMs.size();
    return (isTimed ? image_.image().header->cine.frameMs[frame] : kUsualMs) / bar_->speed();
}

void PlanarController::playNext() {
    if (!isUpToDate()) return player_.askAgain();
    const study::PlanarLoop& of = loopAt(place_);
    const bool sweeps = image_.image().header->cine.sweeps;
    if (sweeps && place_ + 1 == of.end) playsBackwards_ = true;
    if (place_ == of.begin) playsBackwards_ = false;
    std::size_t next = playsBackwards_ ? place_ - 1 : place_ + 1;
    if (next == of.end) next = of.begin;
    setPlace(next);
    player_.holdFor(msOf(place_));
}

// An unfinished measurement ends first, then the tool, then the images.
void PlanarController::onEscape() {
    if (measuring_->isDrawing()) return measuring_->dropDrawing();
    if (measuring_->tool()) return measuring_->setTool({});
    close();
}

bool PlanarController::chooseTool(PlanarKey key) {
    using Kind = study::ImageMeasurement::Kind;
    constexpr std::array<std::pair<PlanarKey, std::optional<Kind>>, 5> kTools{
        {{PlanarKey::window, std::nullopt},
         {PlanarKey::distance, Kind::distance},
         {PlanarKey::angle, Kind::angle},
         {PlanarKey::ellipse, Kind::ellipse},
         {PlanarKey::cobb, Kind::cobb}}};
    const auto* tool = std::ranges::find(kTools, key, &std::pair<PlanarKey, std::optional<Kind>>::first);
    if (tool == kTools.end()) return false;
    measuring_->setTool(tool->second);
    return true;
}

void PlanarController::onKey(PlanarKey key) {
    constexpr double kZoomOfKey = 1.2;
    const QPointF middle(0.5 * view_->width(), 0.5 * view_->height());
    if (!isShown() || chooseTool(key)) return;
    switch (key) {
        case PlanarKey::play:
            return setPlaying(!isPlaying());
        case PlanarKey::back:
            return stepBy(-1);
        case PlanarKey::forward:
            return stepBy(1);
        case PlanarKey::first:
            return stepBy(-int(place_));
        case PlanarKey::last:
            return stepBy(int(series_.stack->frames.size()));
        case PlanarKey::remove:
            return measuring_->removeSelected();
        case PlanarKey::label:
            return measuring_->editLabelOfSelected();
        case PlanarKey::invert:
            return invert(!display().isInverted);
        case PlanarKey::turn:
            return turn(false);
        case PlanarKey::mirror:
            return turn(true);
        case PlanarKey::fit:
            return view_->fit();
        case PlanarKey::closer:
            return view_->zoomBy(kZoomOfKey, middle);
        case PlanarKey::farther:
            return view_->zoomBy(1.0 / kZoomOfKey, middle);
        case PlanarKey::overlays:
            return showOverlays(!image_.overlaysAreShown());
        case PlanarKey::escape:
            return onEscape();
        default:
            return;
    }
}

bool PlanarController::savePicture() {
    if (!isShown()) return false;
    saving_->savePicture(view_->pictureWithoutNames());
    return true;
}

bool PlanarController::saveMeasurements() {
    if (isShown()) saving_->saveMeasurements(found_, series_.stack, measuring_->all());
    return isShown();
}

bool PlanarController::removeMeasurements() {
    if (isShown()) measuring_->removeAll();
    return isShown();
}

// Until what was left is applied, the state on screen is not what a person left.
void PlanarController::keep() {
    if (!isShown() || left_ || !image_.hasImage()) return;
    study::ImagesState state{.measurements = measuring_->all(), .place = place_};
    // Under a presentation state, window and place are its.
    if (presenting_->state() == nullptr) {
        if (image_.isDisplayOwn() && !display().table) state.window = display().window;
        state.isInverted = display().isInverted;
        state.quarters = view_->turn().quarters;
        state.isMirrored = view_->turn().isMirrored;
        state.scale = view_->zoom().scale;
        state.middlePx = {view_->zoom().middle.x(), view_->zoom().middle.y()};
    }
    state.overlaysAreShown = image_.overlaysAreShown();
    kept_->keep(state);
}

// Once both are there: what is kept, and the first image.
void PlanarController::restore() {
    if (!isShown() || !left_ || !image_.hasImage()) return;
    const study::ImagesState state = *std::exchange(left_, {});
    // What a person has drawn meanwhile stays.
    std::vector<study::ImageMeasurement> all = state.measurements;
    all.insert(all.end(), measuring_->all().begin(), measuring_->all().end());
    measuring_->setAll(std::move(all));
    image_.showOverlays(state.overlaysAreShown);
    if (state.window && !image_.image().pixels->isColour())
        image_.setDisplay({.window = *state.window, .table = {}, .isInverted = state.isInverted});
    invert(state.isInverted);
    view_->setTurn({state.quarters, state.isMirrored});
    view_->setZoom({state.scale, QPointF(state.middlePx.x, state.middlePx.y)});
    setPlace(state.place);
    tellDisplays();
}

}  // namespace macula::viewer
