#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/planar/planar_controller.h"

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
      pane_(new PlanarPane(*view_, *bar_, this)),
      loader_(new PlanarLoader(this)),
      saving_(new PlanarSaving(context)),
      kept_(new KeptImages(this)),
      volumeActions_(context.window) {
    auto* column = new QVBoxLayout(widget_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(view_, 1);
    column->addWidget(bar_);
    widget_->hide();
    connectParts();
}

void PlanarController::connectParts() {
    auto* keys = new PlanarKeys(*view_, *bar_, this);
    connect(keys, &PlanarKeys::pressed, this, &PlanarController::onKey);
    connect(loader_, &PlanarLoader::loaded, this, &PlanarController::take);
    connect(loader_, &PlanarLoader::failed, this, &PlanarController::tellFailure);
    connect(view_, &PlanarView::steppedBy, this, &PlanarController::stepBy);
    connect(pane_, &PlanarPane::labelsNeeded, this, &PlanarController::tell);
    connect(pane_, &PlanarPane::choicesNeeded, this, [this] { pane_->tellChoices(namesShown_); });
    connect(pane_, &PlanarPane::changed, this, &PlanarController::keep);
    connect(&presenting(), &PlanarPresenting::failed, this,
            [this](const Error& error) { context_.notifications.showError(error); });
    connect(&presenting(), &PlanarPresenting::chosenChanged, this, &PlanarController::goToPresented);
    // On frames that change nobody can draw.
    connect(&measuring(), &PlanarMeasuring::toolChanged, this, [this] {
        if (measuring().tool()) setPlaying(false);
    });
    connect(bar_, &PlanarBar::placeChosen, this, [this](int place) { setPlace(std::size_t(place)); });
    connect(bar_, &PlanarBar::playToggled, this, &PlanarController::setPlaying);
    connect(bar_, &PlanarBar::saveAsked, this, &PlanarController::saveMeasurements);
    connect(bar_, &PlanarBar::backAsked, this, &PlanarController::close);
    connect(&player_, &PlanarPlayer::due, this, &PlanarController::playNext);
    connect(kept_, &KeptImages::found, this, [this](const study::ImagesState& state) {
        left_ = state;
        restore();
    });
}

void PlanarController::keepIn(std::shared_ptr<live::StudyKeeper> keeper) {
    kept_->setKeeper(std::move(keeper));
}

void PlanarController::show(std::shared_ptr<const study::FoundVolumes> found, const dicom::Stack* stack) {
    const study::PlanarSeries series = study::planarSeriesOf(*found, stack);
    if (series.stack == nullptr) return;
    setPlaying(false);
    kept_->close();
    left_.reset();
    found_ = std::move(found);
    series_ = series;
    loops_ = study::loopsOf(*series.stack);
    place_ = 0;
    // Until the image is read, the view would show the one before, which may be of another patient.
    pane_->forget(found_.get(), series_, tr("The image is being read…"));
    loader_->setSeries(found_, series.stack);
    beneath_.hide();
    widget_->show();
    volumeActions_.setImagesShown(true);
    bar_->setCanGoBack(context_.session.hasStudy());
    pane_->tellChoices(namesShown_);
    Q_EMIT shownChanged();
    setPlace(0);
    view_->setFocus();
    kept_->open(series_);
}

void PlanarController::close() {
    if (!isShown() || !context_.session.hasStudy()) return;
    setPlaying(false);
    kept_->close();
    left_.reset();
    loader_->setSeries(nullptr, nullptr);
    series_ = {};
    found_.reset();
    pane_->forget(nullptr, {}, QString());
    widget_->hide();
    beneath_.show();
    volumeActions_.setImagesShown(false);
    Q_EMIT shownChanged();
    context_.focusPicture();
}

void PlanarController::showNames(bool shown) {
    namesShown_ = shown;
    tell();
    pane_->tellChoices(shown);
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
    const bool isFirst = !pane_->hasImage();
    const bool isOfSameLoop = !isFirst && loopAt(pane_->image().place).begin == loopAt(place_).begin;
    pane_->localizer().show(series_.stack->frames[place_], context_.session.study(),
                            context_.session.state().slices.crosshairMm);
    pane_->take(image, series_.stack->frames[place_], isOfSameLoop);
    if (isFirst || !isPlaying()) pane_->tellChoices(namesShown_);
    if (isFirst) restore();
    Q_EMIT imageShown();
}

// A state that is chosen may be of other images than the one on screen.
void PlanarController::goToPresented() {
    const dicom::SoftcopyState* said = presenting().state();
    if (!isShown() || said == nullptr) return;
    const std::vector<dicom::Frame>& frames = series_.stack->frames;
    const auto isOf = [&](const dicom::Frame& frame) { return study::isPresented(*said, frame); };
    const auto first = std::ranges::find_if(frames, isOf);
    if (!isOf(frames[place_]) && first != frames.end()) setPlace(std::size_t(first - frames.begin()));
}

void PlanarController::tellFailure(std::size_t place, const Error& error) {
    if (!isShown() || place != place_) return;
    setPlaying(false);
    pane_->fail(inWindowsLanguage(error));
    tell();
}

// Of the series: of such images a person expects a volume.
QStringList PlanarController::warnings() const {
    QStringList warnings;
    if (!pane_->hasImage()) return warnings;
    const Message* why = series_.stack->whyNoVolume();
    if (why != nullptr && series_.stack->frames.size() > 1 && isOfSlices(series_.stack->modality))
        warnings += inWindowsLanguage(why->sentence);
    const study::PlanarLoop& of = loopAt(pane_->image().place);
    const bool hasLoop = of.end - of.begin > 1;
    if (!pane_->localizer().isEmpty()) warnings += tr("lines: the slices of the open volume");
    if (hasLoop && pane_->image().header->cine.frameMs.empty())
        warnings += tr("the file says no rate: %1 frames per second").arg(1000.0 / kUsualMs);
    return warnings;
}

void PlanarController::tell() {
    if (!isShown()) return;
    PlanarLabels labels;
    const study::Identity identity = study::identityOf(series_);
    if (namesShown_) labels.identity = inWindowsLanguage(study::linesOf(identity));
    // Of what is on screen, while the next is read.
    const std::size_t place = pane_->hasImage() ? pane_->image().place : place_;
    const study::PlanarLoop& of = loopAt(place);
    labels.place = {placeText(int(&of - loops_.data()) + 1, int(loops_.size()), int(place - of.begin) + 1,
                              int(of.end - of.begin))};
    labels.warnings = warnings();
    pane_->tell(std::move(labels));
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
    const bool isTimed = pane_->hasImage() && frame < pane_->image().header->cine.frameMs.size();
    return (isTimed ? pane_->image().header->cine.frameMs[frame] : kUsualMs) / bar_->speed();
}

void PlanarController::playNext() {
    if (!isUpToDate()) return player_.askAgain();
    const study::PlanarLoop& of = loopAt(place_);
    const bool sweeps = pane_->image().header->cine.sweeps;
    if (sweeps && place_ + 1 == of.end) playsBackwards_ = true;
    if (place_ == of.begin) playsBackwards_ = false;
    std::size_t next = playsBackwards_ ? place_ - 1 : place_ + 1;
    if (next == of.end) next = of.begin;
    setPlace(next);
    player_.holdFor(msOf(place_));
}

// An unfinished measurement ends first, then the tool, then the images.
void PlanarController::onEscape() {
    if (measuring().isDrawing()) return measuring().dropDrawing();
    if (measuring().tool()) return measuring().setTool({});
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
    measuring().setTool(tool->second);
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
            return measuring().removeSelected();
        case PlanarKey::label:
            return measuring().editLabelOfSelected();
        case PlanarKey::invert:
            return pane_->invert(!display().isInverted);
        case PlanarKey::turn:
            return pane_->turn(false);
        case PlanarKey::mirror:
            return pane_->turn(true);
        case PlanarKey::fit:
            return view_->fit();
        case PlanarKey::closer:
            return view_->zoomBy(kZoomOfKey, middle);
        case PlanarKey::farther:
            return view_->zoomBy(1.0 / kZoomOfKey, middle);
        case PlanarKey::overlays:
            return pane_->showOverlays(!pane_->shown().overlaysAreShown());
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
    if (isShown()) saving_->saveMeasurements(found_, series_.stack, measuring().all());
    return isShown();
}

bool PlanarController::removeMeasurements() {
    if (isShown()) measuring().removeAll();
    return isShown();
}

// Until what was left is applied, what is on screen is not what a person left.
void PlanarController::keep() {
    if (!isShown() || left_ || !pane_->hasImage()) return;
    study::ImagesState state = pane_->state();
    state.place = place_;
    kept_->keep(state);
}

// Once both are there: what is kept, and the first image.
void PlanarController::restore() {
    if (!isShown() || !left_ || !pane_->hasImage()) return;
    const study::ImagesState state = *left_;
    pane_->restore(state);
    if (pane_->presenting().state() == nullptr) setPlace(state.place);
    left_.reset();
    keep();
}

}  // namespace macula::viewer
