#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/phases/phases_in_3d.h"

#include <utility>
#include <variant>

#include "viewer/editor/study_editor.h"
#include "viewer/phases/phase_loader.h"
#include "viewer/status/status_texts.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

PhasesIn3d::PhasesIn3d(const WindowContext& context, const PhaseLoader& loader, QObject* parent)
    : QObject(parent), context_(context), loader_(loader) {
    connect(&context_.viewport, &Viewport::rendered, this, &PhasesIn3d::onRendered);
    connect(&context_.shown, &ShownVolume::changed, this, &PhasesIn3d::publish);
}

void PhasesIn3d::begin(std::size_t count, std::size_t open) {
    count_ = count;
    open_ = shown_ = open;
    study_.reset();
    text_.clear();
    phases_.reset();
    models_.reset();
    isPlaying_ = isOn_ = false;
}

void PhasesIn3d::setOn(bool on) {
    if (isOn_ == on) return;
    isOn_ = on;
    models_.reset();
    if (isOn_)
        publish();
    else if (context_.session.hasStudy())
        context_.viewport.setPhase({}, context_.shown.drawing());
    Q_EMIT noteChanged();
}

void PhasesIn3d::setLearning(bool learns) {
    if (learns_ == learns) return;
    learns_ = learns;
    publish();
    Q_EMIT noteChanged();
}

void PhasesIn3d::show(std::size_t phase, std::shared_ptr<const study::OpenedStudy> study,
                      const QString& text) {
    shown_ = phase;
    study_ = std::move(study);
    text_ = text;
    publish();
}

void PhasesIn3d::setPlaying(bool plays) {
    if (isPlaying_ == plays) return;
    isPlaying_ = plays;
    publish();
}

void PhasesIn3d::loadedMore() {
    publish();
    Q_EMIT noteChanged();
}

void PhasesIn3d::publish() {
    if (!isOn_ || count_ == 0 || !context_.session.hasStudy()) return;
    context_.viewport.setPhase(
        {.number = shown_ + 1,
         .volume = isAnother() && study_ ? study_->volume : nullptr,
         .names = isAnother() && study_ ? linesToShow(study_->identity) : std::vector<std::string>(),
         .notes = notes(),
         .isPlaying = isPlaying_,
         .phases = phases(),
         .learns = learns_},
        isAnother() ? context_.shown.drawingOfPhase() : context_.shown.drawing());
}

std::vector<std::string> PhasesIn3d::notes() const {
    if (!isAnother()) return {text_.toStdString()};
    const QString open = QString::number(open_ + 1);
    std::vector<std::string> notes{tr("%1; saved values: phase %2").arg(text_, open).toStdString()};
    const scene::Drawing drawing = context_.shown.drawing();
    if (drawing.additions && drawing.additions->tints)
        notes.push_back(
            tr("Colours of segments are of phase %1, and not shown here").arg(open).toStdString());
    if (drawing.clip && drawing.clip->mask)
        notes.push_back(tr("Voxels are hidden where phase %1 has them hidden").arg(open).toStdString());
    if (drawing.additions && drawing.additions->second)
        notes.push_back(tr("The second volume is placed for phase %1").arg(open).toStdString());
    return notes;
}

// A phase that was dropped for lack of memory must not be kept here.
std::shared_ptr<const live::PhaseScenes> PhasesIn3d::phases() {
    if (!loader_.hasAll() || loader_.count() != count_) return phases_ = nullptr;
    auto wanted = std::make_shared<live::PhaseScenes>();
    const scene::Drawing ofOpen = context_.shown.drawing();
    const scene::Drawing ofOthers = context_.shown.drawingOfPhase();
    for (std::size_t phase = 0; phase < count_; ++phase)
        wanted->push_back(
            {.phase = phase + 1,
             .volume = phase == open_ ? context_.session.study().volume : loader_.phase(phase)->volume,
             .drawing = phase == open_ ? ofOpen : ofOthers});
    if (!phases_ || *phases_ != *wanted) phases_ = std::move(wanted);
    return phases_;
}

void PhasesIn3d::onRendered(const live::RenderEvent& event) {
    if (std::holds_alternative<live::RenderFailure>(event)) hasFailed_ = true;
    if (std::holds_alternative<live::FrameShown>(event)) hasFailed_ = false;
    const auto* models = std::get_if<live::PhaseModelsChanged>(&event);
    if (models == nullptr || models->study != context_.viewport.study()) return;
    models_ = *models;
    Q_EMIT noteChanged();
}

bool PhasesIn3d::isSeen() const {
    if (!isOn_ || hasFailed_ || !context_.viewport.isVisible()) return true;
    const live::FrameShown* frame = context_.viewport.frameOnScreen();
    return frame != nullptr && frame->phase == shown_ + 1;
}

QString PhasesIn3d::note() const {
    if (!isOn_ || !models_ || models_->wanted == 0) return {};
    if (models_->learnt == models_->wanted) return tr("All phases are learnt for 3D");
    QString note = tr("%1 of %2 phases learnt for 3D").arg(models_->learnt).arg(models_->wanted);
    if (models_->noRoom) return tr("%1; the device has no memory for more").arg(note);
    if (models_->learning > 0)
        note = tr("%1; phase %2, step %3").arg(note).arg(models_->learning).arg(models_->steps);
    return note;
}

}  // namespace macula::viewer
