#include "viewer/presets/preset_naming.h"

#include <QDialogButtonBox>
#include <QVBoxLayout>
#include <QWidget>
#include <utility>

#include "viewer/menus/controls.h"
#include "viewer/status/status_texts.h"

namespace macula::viewer {

PresetNameDialog::PresetNameDialog(const QString& title, const QString& what, const QString& proposed,
                                   WhyRefused whyRefused, QWidget* parent)
    : QDialog(parent), whyRefused_(std::move(whyRefused)), name_(new QLineEdit), trouble_(new QLabel) {
    setWindowTitle(title);
    auto* about = new QLabel(what);
    about->setTextFormat(Qt::PlainText);
    about->setWordWrap(true);
    describe(*name_, "preset-name", tr("Name of the preset"),
             tr("For all studies, so without anything of a patient"));
    name_->setText(proposed);
    name_->selectAll();
    makePlain(*trouble_, "preset-name-trouble");
    // So that the buttons do not move while a person types.
    trouble_->setMinimumHeight(2 * trouble_->fontMetrics().lineSpacing());
    trouble_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    auto* column = new QVBoxLayout(this);
    column->addWidget(about);
    column->addWidget(name_);
    column->addWidget(trouble_);
    column->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(name_, &QLineEdit::textChanged, this, &PresetNameDialog::check);
    check();
}

void PresetNameDialog::check() {
    const QString why = whyRefused_(name_->text());
    trouble_->setText(why);
    ok_->setEnabled(why.isEmpty());
}

PresetNaming::PresetNaming(QWidget& widget, const StudyEditor& session, PresetLibrary& library,
                           StateNow stateNow)
    : widget_(widget), session_(session), library_(library), stateNow_(std::move(stateNow)) {}

void PresetNaming::ask(const QString& title, const QString& what, const QString& proposed,
                       const live::PresetRef& own, Then then) {
    auto* dialog = new PresetNameDialog(
        title, what, proposed,
        [this, own](const QString& name) { return library_.whyNameIsRefused(name, own); }, widget_.window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, then = std::move(then)] {
        Q_EMIT named();
        const Result<void> kept = then(dialog->name());
        if (!kept) return Q_EMIT failed(kept.error());
        Q_EMIT done();
    });
    dialog->open();
}

void PresetNaming::askToSaveCurve() {
    if (!session_.hasStudy())
        return Q_EMIT failed(
            {ErrorCode::usage, Text("There is no preset to save yet."), {}, Text("Open a study first.")});
    const scene::StudyState state = stateNow_();
    const QString shown = state.preset ? titleOr(state.preset->title, state.preset->name) : tr("Preset");
    ask(tr("Keep the curve"), tr("The transfer function that is shown, as a preset of your own."),
        library_.freeTitle(shown), {}, [this, state](const QString& name) -> Result<void> {
            const auto saved = library_.saveCurve(name, state);
            return saved ? Result<void>() : Result<void>(saved.error());
        });
}

void PresetNaming::askToSaveSeen() {
    if (!session_.hasStudy())
        return Q_EMIT failed(
            {ErrorCode::usage, Text("There is nothing to be seen yet."), {}, Text("Open a study first.")});
    const scene::StudyState state = stateNow_();
    const QString shown = state.preset ? titleOr(state.preset->title, state.preset->name) : tr("Preset");
    ask(tr("Keep all that is seen"),
        tr("Curve, look, lights, window, clip and camera, as a preset of your own. It is for all "
           "studies: clip and camera go with the size of the volume."),
        library_.freeTitle(tr("%1, as seen").arg(shown)), {},
        [this, state](const QString& name) -> Result<void> {
            const auto saved = library_.saveSeen(name, state);
            return saved ? Result<void>() : Result<void>(saved.error());
        });
}

void PresetNaming::askToCopy(const LibraryPreset& preset) {
    ask(tr("Save as copy"), tr("A preset of your own, like “%1”.").arg(shownTitle(preset)),
        library_.freeTitle(shownTitle(preset)), {},
        [this, ref = preset.ref](const QString& name) -> Result<void> {
            const auto saved = library_.saveCopy(name, ref);
            return saved ? Result<void>() : Result<void>(saved.error());
        });
}

void PresetNaming::askToRename(const LibraryPreset& preset) {
    ask(tr("Rename the preset"), tr("Another name for “%1”.").arg(shownTitle(preset)), shownTitle(preset),
        preset.ref, [this, ref = preset.ref](const QString& name) { return library_.rename(ref, name); });
}

}  // namespace macula::viewer
