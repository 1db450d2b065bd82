#include "viewer/planar/planar_texts.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PlanarTexts)
};

// "FR" becomes "HL".
QString opposite(const QString& letters) {
    const QString from = QStringLiteral("LRAPHF");
    const QString to = QStringLiteral("RLPAFH");
    QString turned;
    for (const QChar letter : letters) {
        const auto at = from.indexOf(letter);
        turned += at < 0 ? letter : to[at];
    }
    return turned;
}

// With three digits, and all of those before the point.
QString number(double value) {
    constexpr double kThreeDigits = 100.0;
    const bool isLong = std::abs(value) >= kThreeDigits;
    return withLocalNumbers(isLong ? QString::number(value, 'f', 0) : QString::number(value, 'g', 3));
}

}  // namespace

std::array<QString, 4> edgeLetters(const std::array<std::string, 2>& towards, const PlanarTurn& turn) {
    const QString right = QString::fromStdString(towards[0]);  // rows run to the right
    const QString bottom = QString::fromStdString(towards[1]);
    std::array<QString, 4> edges{opposite(right), opposite(bottom), right, bottom};
    // A quarter clockwise brings the left edge to the top.
    std::ranges::rotate(edges, edges.end() - turn.quarters);
    if (turn.isMirrored) std::swap(edges[0], edges[2]);
    return edges;
}

QString placeText(int image, int images, int frame, int frames) {
    const QString place = Words::tr("image %1 of %2").arg(image).arg(images);
    return frames > 1 ? place + Words::tr(", frame %1 of %2").arg(frame).arg(frames) : place;
}

QString viewText(const dicom::PlanarHeader& header) {
    QStringList view;
    for (const std::string* word : {&header.laterality, &header.viewPosition})
        if (!word->empty()) view += QString::fromStdString(*word).simplified();
    return view.join(QLatin1Char(' '));
}

QString displayText(const dicom::PlanarHeader& header, const study::PlanarDisplay& display, bool isColour) {
    if (isColour) return {};
    if (display.presented) return Words::tr("Table of the presentation state");
    if (display.table) {
        const QString name = QString::fromStdString(header.tables.at(*display.table).explanation);
        return name.isEmpty() ? Words::tr("Table %1 of the file").arg(*display.table + 1)
                              : Words::tr("Table: %1").arg(name.simplified());
    }
    return QStringLiteral("W %1 L %2").arg(number(display.window.width), number(display.window.center));
}

QStringList changesOf(const PlanarTurn& turn, const study::PlanarDisplay& display) {
    constexpr int kDegrees = 90;
    QStringList changes;
    if (turn.quarters != 0) changes += Words::tr("turned by %1°").arg(kDegrees * turn.quarters);
    if (turn.isMirrored) changes += Words::tr("mirrored");
    if (display.isInverted) changes += Words::tr("inverted");
    return changes;
}

QString pixelSizeText(const dicom::PlanarHeader& header) {
    if (!header.pixelSize) return {};
    const dicom::PixelSize& size = *header.pixelSize;
    const bool isSquare = std::abs(size.columnMm - size.rowMm) <= 1e-6 * size.columnMm;
    const QString mm = isSquare
                           ? Words::tr("%1 mm per pixel").arg(number(size.columnMm))
                           : Words::tr("%1 × %2 mm per pixel").arg(number(size.columnMm), number(size.rowMm));
    switch (size.of) {
        case dicom::PixelSize::Of::object:
            return mm;
        case dicom::PixelSize::Of::regions:
            return Words::tr("%1, only in the regions of ultrasound that have lengths").arg(mm);
        case dicom::PixelSize::Of::detector:
            return Words::tr("%1, at the detector: the patient is smaller").arg(mm);
        case dicom::PixelSize::Of::estimate:
            return Words::tr("%1, estimated by a magnification of %2").arg(mm, number(size.magnification));
        case dicom::PixelSize::Of::film:
            return Words::tr("%1 of the scanned film: the patient's size is not known").arg(mm);
    }
    return mm;
}

}  // namespace macula::viewer
