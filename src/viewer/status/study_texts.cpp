#include "viewer/status/study_texts.h"

#include <QCoreApplication>
#include <algorithm>

#include "viewer/language/window_language.h"
#include "viewer/overlay/slice_texts.h"

namespace macula::viewer {

namespace {

struct PictureWords {
    Q_DECLARE_TR_FUNCTIONS(Picture)
};

const QString kProgram = QStringLiteral("Macula");

QString titleText(const study::Identity& identity) {
    QString title = inWindowsLanguage(titleOf(identity)).simplified();
    title.replace(QLatin1String("[*]"), QLatin1String("[*][*]"));  // escapes Qt's mark for unsaved documents
    return title.isEmpty() ? kProgram : title + QStringLiteral(" \u2013 ") + kProgram;
}

QString voxelsText(const Volume& volume) {
    const glm::ivec3 size = volume.size();
    const glm::dvec3 spacing = volume.spacingMm();
    const auto mm = [](double length) { return withLocalNumbers(QString::number(length, 'f', 2)); };
    const QString text = QStringLiteral("%1 %2×%3×%4, %5×%6×%7 mm")
                             .arg(QString::fromStdString(volume.modality()))
                             .arg(size.x)
                             .arg(size.y)
                             .arg(size.z)
                             .arg(mm(spacing.x), mm(spacing.y), mm(spacing.z));
    return volume.provenance().isCalibrated ? text : notCalibrated(text);
}

}  // namespace

StudyTexts textsOf(const study::OpenedStudy& study, bool names) {
    StudyTexts texts{.title = kProgram};
    if (!study.volume) return texts;
    texts.voxels = voxelsText(*study.volume);
    texts.whyThisOne = inWindowsLanguage(study.whyThisSeries);
    if (!names) return texts;
    texts.title = titleText(study.identity);
    texts.description = inWindowsLanguage(study.description);
    texts.listsVolumes = study.volumeTitles.size() > 1;
    return texts;
}

StudyTexts textsOfImages(const study::Identity& identity, bool names) {
    StudyTexts texts{.title = kProgram};
    if (!names) return texts;
    texts.title = titleText(identity);
    texts.description = inWindowsLanguage(identity.series);
    return texts;
}

QStringList withoutRepeats(const QStringList& notes) {
    QStringList once;
    for (const QString& note : notes) {
        const QString sentence = note.trimmed();
        const bool isSaid = std::ranges::any_of(once, [&](const QString& said) {
            return said == sentence || said.startsWith(sentence + QLatin1Char(' '));
        });
        if (!sentence.isEmpty() && !isSaid) once << sentence;
    }
    return once;
}

QString withoutVolumeText(scene::Layout layout) {
    switch (layout) {
        case scene::Layout::axial:
            return PictureWords::tr("Axial slices; 3D is not shown");
        case scene::Layout::coronal:
            return PictureWords::tr("Coronal slices; 3D is not shown");
        case scene::Layout::sagittal:
            return PictureWords::tr("Sagittal slices; 3D is not shown");
        case scene::Layout::volume:
        case scene::Layout::fourPanes:
            break;
    }
    return {};
}

}  // namespace macula::viewer
