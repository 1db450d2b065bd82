#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/planar/image_box.h"

#include <QDragEnterEvent>
#include <QMainWindow>
#include <QMimeData>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "study/planar/linked_frames.h"
#include "viewer/browser/series_mime.h"
#include "viewer/editor/study_editor.h"
#include "viewer/language/window_language.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/planar/box_keys.h"
#include "viewer/planar/kept_images.h"
#include "viewer/planar/planar_bar.h"
#include "viewer/planar/planar_measuring.h"
#include "viewer/planar/planar_presenting.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

namespace {

constexpr double kUsualMs = 100.0;  // of a frame, where the file says no rate

bool isOfSlices(const std::string& modality) {
    return modality == "CT" || modality == "MR" || modality == "PT" || modality == "NM";
}

}  // namespace

ImageBox::ImageBox(const WindowContext& context, QObject* parent)
    : QObject(parent),
      context_(context),
      view_(new PlanarView),
      frame_(new PaneFrame(view_)),
      bar_(new PlanarBar),
      pane_(new PlanarPane(*view_, *bar_, this)),
      loader_(new PlanarLoader(this)),
      // Jobs of the store refer to it until the store ends, which is after the boxes.
      kept_(new KeptImages(&context.window)) {
    view_->addLayer(line_);
    view_->setAcceptDrops(true);
    view_->installEventFilter(this);
    connectParts();
}

void ImageBox::connectParts() {
    auto* keys = new PlanarKeys(*view_, *bar_, this);
    connect(keys, &PlanarKeys::pressed, this, [this](PlanarKey key) { pressKey(*this, key); });
    connect(loader_, &PlanarLoader::loaded, this, &ImageBox::take);
    connect(loader_, &PlanarLoader::failed, this, &ImageBox::tellFailure);
    connect(view_, &PlanarView::steppedBy, this, &ImageBox::stepBy);
    connect(pane_, &PlanarPane::labelsNeeded, this, &ImageBox::tell);
    connect(pane_, &PlanarPane::choicesNeeded, this, [this] { pane_->tellChoices(namesShown_); });
    connect(pane_, &PlanarPane::changed, this, &ImageBox::keep);
    connect(&presenting(), &PlanarPresenting::failed, this,
            [this](const Error& error) { context_.notifications.showError(error); });
    connect(&presenting(), &PlanarPresenting::chosenChanged, this, &ImageBox::goToPresented);
    // On frames that change nobody can draw.
    connect(&measuring(), &PlanarMeasuring::toolChanged, this, [this] {
        if (measuring().tool()) setPlaying(false);
    });
    connect(bar_, &PlanarBar::placeChosen, this, [this](int place) { setPlace(std::size_t(place)); });
    connect(bar_, &PlanarBar::playToggled, this, &ImageBox::setPlaying);
    connect(bar_, &PlanarBar::saveAsked, this, &ImageBox::saveAsked);
    connect(bar_, &PlanarBar::backAsked, this, &ImageBox::closeAsked);
    connect(&player_, &PlanarPlayer::due, this, &ImageBox::playNext);
    // In a window of their own images stay while the volume changes.
    connect(&context_.session, &StudyEditor::studyShown, this, &ImageBox::showLocalizer);
    connect(&context_.session, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (before.slices.crosshairMm != context_.session.state().slices.crosshairMm) showLocalizer();
    });
    connect(kept_, &KeptImages::found, this, [this](const study::ImagesState& state) {
        left_ = state;
        restore();
    });
}

void ImageBox::keepIn(std::shared_ptr<live::StudyKeeper> keeper) {
    kept_->setKeeper(std::move(keeper));
}

void ImageBox::show(std::shared_ptr<const study::FoundVolumes> found, const study::PlanarSeries& series,
                    std::optional<std::size_t> place, bool keeps) {
    setPlaying(false);
    kept_->close();
    left_.reset();
    found_ = std::move(found);
    series_ = series;
    keeps_ = keeps;
    isPlaceGiven_ = place.has_value();
    loops_ = study::loopsOf(*series.stack);
    place_ = 0;
    // Until the image is read, the view would show the one before, which may be of another patient.
    pane_->forget(found_.get(), series_, tr("The image is being read…"));
    line_.hide();
    loader_->setSeries(found_, series.stack);
    bar_->setCanGoBack(context_.session.hasStudy());
    pane_->tellChoices(namesShown_);
    Q_EMIT shownChanged();
    request(place.value_or(0));
    if (keeps_) kept_->open(series_);
}

void ImageBox::clear() {
    if (!isShown()) return;
    setPlaying(false);
    kept_->close();
    left_.reset();
    loader_->setSeries(nullptr, nullptr);
    series_ = {};
    found_.reset();
    line_.hide();
    pane_->forget(nullptr, {}, QString());
    view_->setLabels({});
    Q_EMIT shownChanged();
}

void ImageBox::showNames(bool shown) {
    namesShown_ = shown;
    tell();
    pane_->tellChoices(shown);
}

void ImageBox::setLineOf(const dicom::Frame* other) {
    const bool wasEmpty = line_.isEmpty();
    const dicom::Frame* own = shownFrame();
    line_.show(own != nullptr && other != nullptr ? study::outlineOn(*own, *other) : std::nullopt);
    view_->update();
    if (line_.isEmpty() != wasEmpty) tell();
}

void ImageBox::takeMeasurements(const std::vector<study::ImageMeasurement>& all) {
    measuring().follow(all);
    bar_->setHasMeasurements(!all.empty());
    keep();
}

const dicom::Frame* ImageBox::shownFrame() const {
    return isShown() && pane_->hasImage() ? &series_.stack->frames[pane_->image().place] : nullptr;
}

void ImageBox::setPrior(const std::string& date) {
    priorDate_ = date;
    tell();
}

void ImageBox::setLinked(bool linked) {
    isLinked_ = linked;
    tell();
}

bool ImageBox::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusIn || event->type() == QEvent::MouseButtonPress) Q_EMIT activated();
    if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove ||
        event->type() == QEvent::Drop) {
        auto& drop = static_cast<QDropEvent&>(*event);
        const QByteArray series = drop.mimeData()->data(QLatin1String(kSeriesMime));
        if (series.isEmpty()) return QObject::eventFilter(watched, event);
        drop.acceptProposedAction();
        if (event->type() == QEvent::Drop) Q_EMIT dropped(series);
        return true;
    }
    return QObject::eventFilter(watched, event);
}

const study::PlanarLoop& ImageBox::loopAt(std::size_t place) const {
    return *std::ranges::find_if(loops_, [&](const study::PlanarLoop& each) { return place < each.end; });
}

void ImageBox::setPlace(std::size_t place) {
    if (!isShown()) return;
    follow(place);
    Q_EMIT placeChosen();
}

void ImageBox::follow(std::size_t place) {
    isPlaceGiven_ = true;
    request(place);
}

void ImageBox::request(std::size_t place) {
    if (!isShown()) return;
    place_ = std::min(place, series_.stack->frames.size() - 1);
    bar_->setPlaces(int(series_.stack->frames.size()), int(place_));
    bar_->setCanPlay(loopAt(place_).end - loopAt(place_).begin > 1);
    loader_->ask(place_);
    tell();
    keep();
}

void ImageBox::stepBy(int images) {
    if (!isShown()) return;
    setPlaying(false);
    const int last = int(series_.stack->frames.size()) - 1;
    setPlace(std::size_t(std::clamp(int(place_) + images, 0, last)));
}

void ImageBox::take(const LoadedImage& image) {
    if (!isShown() || image.place != place_) return;
    const bool isFirst = !pane_->hasImage();
    const bool isOfSameLoop = !isFirst && loopAt(pane_->image().place).begin == loopAt(place_).begin;
    pane_->take(image, series_.stack->frames[place_], isOfSameLoop);
    showLocalizer();
    if (isFirst || !isPlaying()) pane_->tellChoices(namesShown_);
    if (isFirst) restore();
    Q_EMIT imageShown();
}

void ImageBox::showLocalizer() {
    const dicom::Frame* frame = shownFrame();
    if (frame == nullptr) return;
    pane_->localizer().show(*frame, context_.session.study(), context_.session.state().slices.crosshairMm);
    view_->update();
}

// A state that is chosen may be of other images than the one on screen.
void ImageBox::goToPresented() {
    const dicom::SoftcopyState* said = presenting().state();
    if (!isShown() || said == nullptr) return;
    const std::vector<dicom::Frame>& frames = series_.stack->frames;
    const auto isOf = [&](const dicom::Frame& frame) { return study::isPresented(*said, frame); };
    const auto first = std::ranges::find_if(frames, isOf);
    if (!isOf(frames[place_]) && first != frames.end()) setPlace(std::size_t(first - frames.begin()));
}

void ImageBox::tellFailure(std::size_t place, const Error& error) {
    if (!isShown() || place != place_) return;
    setPlaying(false);
    pane_->fail(inWindowsLanguage(error));
    tell();
}

// Of the series: of such images a person expects a volume.
QStringList ImageBox::warnings() const {
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
    if (!line_.isEmpty()) warnings += tr("line: the image of the box that is chosen");
    if (!priorDate_.empty())
        warnings += tr("an older study, of %1").arg(QString::fromStdString(study::dateForPeople(priorDate_)));
    if (isLinked_) warnings += tr("scrolls with the others");
    return warnings;
}

void ImageBox::tell() {
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

void ImageBox::setPlaying(bool plays) {
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

double ImageBox::msOf(std::size_t place) const {
    const auto frame = std::size_t(series_.stack->frames[place].number);
    const bool isTimed = pane_->hasImage() && frame < pane_->image().header->cine.frameMs.size();
    return (isTimed ? pane_->image().header->cine.frameMs[frame] : kUsualMs) / bar_->speed();
}

void ImageBox::playNext() {
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

// Until what was left is applied, what is on screen is not what a person left.
void ImageBox::keep() {
    if (!isShown() || !keeps_ || left_ || !pane_->hasImage()) return;
    study::ImagesState state = pane_->state();
    state.place = place_;
    kept_->keep(state);
}

// Once both are there: what is kept, and the first image.
void ImageBox::restore() {
    if (!isShown() || !left_ || !pane_->hasImage()) return;
    const study::ImagesState state = *left_;
    pane_->restore(state);
    if (pane_->presenting().state() == nullptr && !isPlaceGiven_) request(state.place);
    left_.reset();
    keep();
    Q_EMIT restored();
}

}  // namespace macula::viewer
