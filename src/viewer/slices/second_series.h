// A second volume as panes show it: whose it is, in words, with its voxels.
#pragma once

#include <QString>
#include <QStringList>
#include <string>

#include "base/volume.h"
#include "scene/second/beside_state.h"
#include "study/open/opened_study.h"

namespace macula::viewer {

// Made once for a study and a second volume, and never changed.
struct SecondSeries {
    app::OpenedStudy study;     // the second
    DisplayWindow usualWindow;  // seriesWindow
    QString tag;                // "Prior: CT, 2020-03-04, series 3"; names nobody
    QString studyTag;           // "Current: …", of the study that is open
    QStringList lines;          // as app::linesOf; may name a patient
    QString patientNote;        // empty: both are of one patient
    std::string pair;           // app::pairDigest of the study and the second
};

SecondSeries secondSeries(const app::OpenedStudy& study, app::OpenedStudy second, std::string pair);

// How it is linked, in a sentence that is written over pictures of it.
QString linkText(const app::BesideState& state);

// "0 to 6.1 SUV, 75 % of the highest" of activity, else as app::windowText.
QString secondWindowText(const Volume& second, const DisplayWindow& window);

}  // namespace macula::viewer
