#include "viewer/slices/second_series.h"

#include <QCoreApplication>
#include <cmath>
#include <utility>

#include "app/frame/projection_windows.h"
#include "app/study/second_study.h"
#include "viewer/harmless_text.h"

namespace macula::viewer {

namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("SecondSeries", text);
}

QString tagOf(app::Age age, const QString& plain) {
    switch (age) {
        case app::Age::earlier:
            return tr("Prior: %1").arg(plain);
        case app::Age::later:
            return tr("Later: %1").arg(plain);
        case app::Age::sameDay:
            return tr("Second, same day: %1").arg(plain);
        case app::Age::unknown:
            break;
    }
    return tr("Second: %1").arg(plain);
}

QString shownTag(const app::OpenedStudy& study) {
    return harmless(QString::fromStdString(app::plainTag(study)));
}

QString patientNote(const app::Identity& study, const app::Identity& second) {
    switch (app::samePatient(study, second)) {
        case app::SamePatient::no:
            return tr("ANOTHER PATIENT than the study");
        case app::SamePatient::unknown:
            return tr("The images do not tell whether both are of one patient");
        case app::SamePatient::yes:
            break;
    }
    return {};
}

bool isActivity(const Volume& volume) {
    return volume.unit() == Unit::becquerelsPerMillilitre || volume.unit() == Unit::suvBodyWeight;
}

}  // namespace

SecondSeries secondSeries(const app::OpenedStudy& study, app::OpenedStudy second) {
    SecondSeries made;
    made.usualWindow = app::secondWindow(*second.volume);
    made.tag = tagOf(app::ageOf(study.identity, second.identity), shownTag(second));
    made.studyTag = tr("Current: %1").arg(shownTag(study));
    for (const std::string& line : app::linesOf(second.identity)) {
        const QString shown = harmless(QString::fromStdString(line));
        if (!shown.isEmpty()) made.lines.push_back(shown);
    }
    made.patientNote = patientNote(study.identity, second.identity);
    made.study = std::move(second);
    return made;
}

QString linkText(const app::BesideState& state) {
    switch (state.link) {
        case app::BesideLink::sameFrame:
            return tr("Same frame of reference");
        case app::BesideLink::registered:
            return state.isDoubtful ? tr("Registration is doubtful (%1 mm): check landmarks")
                                          .arg(QString::number(state.boundMm, 'f', 1))
                                    : tr("Registered, rigid; searches agree to %1 mm")
                                          .arg(QString::number(state.boundMm, 'f', 1));
        case app::BesideLink::byHand:
            break;
    }
    return tr("Not registered: positions cannot be compared");
}

QString secondWindowText(const Volume& second, const DisplayWindow& window) {
    if (!isActivity(second) || !second.valueRange() || !(second.valueRange()->high > 0.0))
        return harmless(QString::fromStdString(app::windowText(window, second.unitName())));
    const double low = window.center - 0.5 * window.width;
    const double high = window.center + 0.5 * window.width;
    return tr("%1 to %2 %3, %4 % of the highest")
        .arg(QString::number(low, 'g', 3), QString::number(high, 'g', 3),
             harmless(QString::fromStdString(second.unitName())),
             QString::number(std::lround(100.0 * high / second.valueRange()->high)));
}

}  // namespace macula::viewer
