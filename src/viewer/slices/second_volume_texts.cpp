#include "viewer/slices/second_volume_texts.h"

#include <QCoreApplication>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/volume/window.h"
#include "scene/drawing/projection_windows.h"
#include "scene/second/second_study.h"
#include "viewer/language/harmless_text.h"
#include "viewer/language/window_language.h"

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(SecondVolumeTexts)
};

QString tagOf(study::Age age, const QString& plain) {
    switch (age) {
        case study::Age::earlier:
            return Words::tr("Prior: %1").arg(plain);
        case study::Age::later:
            return Words::tr("Later: %1").arg(plain);
        case study::Age::sameDay:
            return Words::tr("Second, same day: %1").arg(plain);
        case study::Age::unknown:
            break;
    }
    return Words::tr("Second: %1").arg(plain);
}

QString shownTag(const study::OpenedStudy& study) {
    return harmless(inWindowsLanguage(scene::plainTag(study)));
}

QString patientNote(const study::Identity& study, const study::Identity& second) {
    switch (study::samePatient(study, second)) {
        case study::SamePatient::no:
            return Words::tr("ANOTHER PATIENT than the study");
        case study::SamePatient::unknown:
            return Words::tr("The images do not tell whether both are of one patient");
        case study::SamePatient::yes:
            break;
    }
    return {};
}

}  // namespace

SecondVolumeTexts secondSeries(const study::OpenedStudy& study, study::OpenedStudy second, std::string pair) {
    SecondVolumeTexts made;
    made.pair = std::move(pair);
    made.usualWindow = seriesWindow(*second.measured());
    made.tag = tagOf(study::ageOf(study.identity, second.identity), shownTag(second));
    made.studyTag = Words::tr("Current: %1").arg(shownTag(study));
    for (const Text& line : study::linesOf(second.identity)) {
        const QString shown = harmless(inWindowsLanguage(line));
        if (!shown.isEmpty()) made.lines.push_back(shown);
    }
    made.patientNote = patientNote(study.identity, second.identity);
    made.study = std::move(second);
    return made;
}

QString linkText(const scene::SecondVolumeState& state, bool isDose) {
    switch (state.link) {
        case scene::SecondVolumeLink::sameFrame:
            if (isDose)
                return Words::tr("Dose in the frame of reference of the images: nothing is registered");
            return Words::tr("Same frame, not registered: the patient may have moved");
        case scene::SecondVolumeLink::registered:
            if (state.isDoubtful && state.rivalMm > 0.0)
                return Words::tr("Registration is doubtful: nearly as good %1 mm away; check landmarks")
                    .arg(withLocalNumbers(QString::number(state.rivalMm, 'f', 0)));
            return state.isDoubtful ? Words::tr("Registration is doubtful (%1 mm): check landmarks")
                                          .arg(withLocalNumbers(QString::number(state.boundMm, 'f', 1)))
                                    : Words::tr("Registered, rigid; searches agree to %1 mm")
                                          .arg(withLocalNumbers(QString::number(state.boundMm, 'f', 1)));
        case scene::SecondVolumeLink::byHand:
            break;
    }
    return Words::tr("Not registered: positions cannot be compared");
}

QString secondWindowText(const Volume& second, const DisplayWindow& window) {
    if (!isActivity(second) || second.unitName().empty() || !second.valueRange() ||
        !(second.valueRange()->high > 0.0))
        return harmless(
            withLocalNumbers(QString::fromStdString(scene::windowText(window, second.unitName()))));
    const double low = window.center - 0.5 * window.width;
    const double high = window.center + 0.5 * window.width;
    return Words::tr("%1 to %2 %3, %4 % of the highest")
        .arg(withLocalNumbers(QString::number(low, 'g', 3)), withLocalNumbers(QString::number(high, 'g', 3)),
             harmless(QString::fromStdString(second.unitName())),
             QString::number(std::lround(100.0 * high / second.valueRange()->high)));
}

}  // namespace macula::viewer
