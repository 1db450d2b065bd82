#include "viewer/status/status_texts.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <string_view>

#include "pipeline/trace/look.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

// The translation context of the status line, whose texts belong to no class.
struct FidelityWords {
    Q_DECLARE_TR_FUNCTIONS(Fidelity)
};
struct ModelWords {
    Q_DECLARE_TR_FUNCTIONS(Model)
};
struct PresetWords {
    Q_DECLARE_TR_FUNCTIONS(Preset)
};

// How a picture was made, in the status line.
QString lookText(trace::Look look) {
    if (look == trace::Look::cinematic) return QCoreApplication::translate("Look", "Path traced");
    if (look == trace::Look::clear) return QCoreApplication::translate("Look", "Path traced, clear");
    const std::string_view title = trace::kLooks.at(std::size_t(look)).title;
    return titleInWindowsLanguage(std::string(title));
}

bool isAwaited(const hybrid::ModelNews& model) {
    return model.stage == hybrid::ModelStage::searching ||
           (model.stage == hybrid::ModelStage::learning && !hybrid::isFitToBeShown(model));
}

}  // namespace

QString titleOr(const std::string& title, const std::string& name) {
    return titleInWindowsLanguage(title.empty() ? name : title);
}

std::vector<std::string> linesToShow(const study::Identity& identity) {
    std::vector<std::string> lines;
    for (const Text& line : linesOf(identity)) lines.push_back(inWindowsLanguage(line).toStdString());
    return lines;
}

LinesOver linesOver(std::vector<std::string> names, const scene::Drawing& drawing) {
    LinesOver lines{.names = std::move(names)};
    // Projections show the study alone.
    if (!drawing.additions || trace::isProjection(drawing.settings.look)) return lines;
    QString remark = inWindowsLanguage(drawing.additions->remark);
    if (remark.isEmpty()) return lines;
    remark[0] = remark[0].toUpper();
    lines.notes.push_back(remark.toStdString());
    return lines;
}

QString fidelityText(const live::FrameShown& frame) {
    const QString remarks =
        frame.remarks.empty() ? QString() : QStringLiteral(", ") + inWindowsLanguage(frame.remarks);
    if (isOfSplats(frame.picture)) {
        const QString centre = frame.foveaAgeMs ? FidelityWords::tr(", sharp centre traced %L1 s ago")
                                                      .arg(*frame.foveaAgeMs / 1000.0, 0, 'f', 1)
                                                : QString();
        const QString preview =
            frame.picture == live::OnScreen::estimate
                ? FidelityWords::tr("Preview, estimated from the values")
                : FidelityWords::tr("Preview, sharpened in %n steps", nullptr, int(frame.model.steps));
        return preview + (isParallel(frame.camera) ? FidelityWords::tr(", parallel rays") : QString()) +
               centre + remarks +
               (frame.greyFacesAreCoarse ? FidelityWords::tr(", values on cut faces only coarsely")
                                         : QString());
    }
    QString text = lookText(frame.look) + remarks;
    const bool isPreview = frame.picture == live::OnScreen::preview;
    if (isParallel(frame.camera)) text += FidelityWords::tr(", parallel rays");
    if (isPreview) {
        text += FidelityWords::tr(", coarse preview");
        if (trace::isPathTraced(frame.look))
            text += frame.denoised ? FidelityWords::tr(", denoised") : FidelityWords::tr(", smoothed");
        if (frame.scale > 1) text += FidelityWords::tr(", 1/%1 of the pixels each way").arg(frame.scale);
        return text;
    }
    const bool isComplete = frame.stage == live::Stage::converged;
    text += isComplete
                ? FidelityWords::tr(", %n samples", nullptr, int(frame.samplesPerPixel))
                : FidelityWords::tr(", %1 of %2 samples").arg(frame.samplesPerPixel).arg(frame.sampleLimit);
    if (frame.denoised) text += FidelityWords::tr(", denoised");
    if (frame.mixesModel) text += FidelityWords::tr(", preview where it is less noisy");
    return text + (isComplete ? FidelityWords::tr(", complete") : FidelityWords::tr(", converging"));
}

QString modelText(const hybrid::ModelNews& model, bool isFirstStart) {
    using hybrid::ModelStage;
    const int steps = int(model.steps);
    if (isFirstStart && isAwaited(model))
        return ModelWords::tr("Preparing the preview, longer at the first start");
    switch (model.stage) {
        case ModelStage::none:
        case ModelStage::nothingToSee:
            return {};
        case ModelStage::searching:
            return ModelWords::tr("Preparing the preview");
        case ModelStage::resuming:
            return ModelWords::tr("Preview of an earlier session, %n steps", nullptr, steps);
        case ModelStage::learning:
            return hybrid::isFitToBeShown(model)
                       ? ModelWords::tr("Preview sharpening, %n steps", nullptr, steps)
                       : ModelWords::tr("Preview not sharp yet, %n steps", nullptr, steps);
        case ModelStage::resting:
            return hybrid::isFitToBeShown(model) ? ModelWords::tr("Preview sharp, %n steps", nullptr, steps)
                                                 : ModelWords::tr("Preview not sharp enough to be shown");
        case ModelStage::noRoom:
            return ModelWords::tr("No memory for a sharp preview");
        case ModelStage::failed:
            return ModelWords::tr("No sharp preview");
    }
    return {};
}

QString aboutModel(const hybrid::ModelNews& model, bool isFirstStart) {
    using hybrid::ModelOrigin;
    if (isFirstStart && isAwaited(model))
        return ModelWords::tr(
            "At its first start Macula compiles its programs for the graphics device. Later starts find "
            "them.");
    if (model.origin == ModelOrigin::stored)
        return ModelWords::tr("It goes on from where an earlier session left it.");
    if (model.origin == ModelOrigin::otherLights)
        return ModelWords::tr("It began with the stored preview of other lights.");
    if (model.origin == ModelOrigin::otherTrainer)
        return ModelWords::tr("It began with a preview that another version of Macula stored.");
    if (model.origin == ModelOrigin::neighbour)
        return ModelWords::tr("It began with the preview of a neighbouring phase.");
    if (model.origin == ModelOrigin::damagedPoints)
        return ModelWords::tr("The stored preview of this was damaged; it began anew.");
    if (model.stage == hybrid::ModelStage::noRoom)
        return ModelWords::tr(
            "The graphics device has no room for it beside the volume: while a hand moves, small traced "
            "pictures are shown.");
    if (model.stage == hybrid::ModelStage::failed)
        return ModelWords::tr(
            "It could not be made on this graphics device: while a hand moves, small traced pictures are "
            "shown.");
    return {};
}

QString presetWarning(const TransferFunction& preset, const Volume& volume) {
    const auto words = [](const std::string& text) { return QString::fromStdString(text); };
    const QString title = titleOr(preset.title, preset.name);
    if (!suits(preset, volume.unit())) {
        const QString wanted = words(std::string(unitSymbol(preset.unit)));
        const QString is = words(volume.unitName());
        return PresetWords::tr(
                   "The preset %1 is made for values in %2; those of this volume are %3. What it shows here, "
                   "and in which colours, means nothing.")
            .arg(title, wanted.isEmpty() ? PresetWords::tr("another unit") : wanted,
                 is.isEmpty() ? PresetWords::tr("raw numbers of the scanner")
                              : PresetWords::tr("in %1").arg(is));
    }
    const auto& made = preset.modalities;
    if (made.empty() || volume.modality().empty() ||
        std::find(made.begin(), made.end(), volume.modality()) != made.end())
        return {};
    QStringList modalities;
    for (const std::string& modality : made) modalities << words(modality);
    return PresetWords::tr(
               "The preset %1 is made for %2; this volume is %3. Its colours may mean something else here.")
        .arg(title, modalities.join(QStringLiteral(", ")), words(volume.modality()));
}

}  // namespace macula::viewer
