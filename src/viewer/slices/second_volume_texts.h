// A second volume as panes show it: its voxels, and texts that identify it.
#pragma once

#include <QString>
#include <QStringList>
#include <string>

#include "base/volume.h"
#include "scene/second/second_volume_state.h"
#include "study/open/opened_study.h"

namespace macula::viewer {

// Immutable; made once for a study and a second volume.
struct SecondVolumeTexts {
    study::OpenedStudy study;   // the study of the second volume
    DisplayWindow usualWindow;  // seriesWindow
    QString tag;                // "Prior: CT, 2020-03-04, series 3"; without names
    QString studyTag;           // "Current: …", of the open study
    QStringList lines;          // as study::linesOf; may name a patient
    QString patientNote;        // empty: the same patient
    std::string pair;           // scene::pairDigest of the study and the second
};

SecondVolumeTexts secondSeries(const study::OpenedStudy& study, study::OpenedStudy second, std::string pair);

// How the second volume is linked, as a note over its pictures. A dose was computed in its frame of
// reference.
QString linkText(const scene::SecondVolumeState& state, bool isDose);

// "0 to 6.1 SUV, 75 % of the highest" for activity, else as scene::windowText.
QString secondWindowText(const Volume& second, const DisplayWindow& window);

}  // namespace macula::viewer
