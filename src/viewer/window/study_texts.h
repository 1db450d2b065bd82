// What the window says of the study that is open, outside of its panes.
#pragma once

#include <QString>
#include <QStringList>

#include "scene/state/study_state.h"
#include "study/open/opened_study.h"

namespace macula::viewer {

struct StudyTexts {
    QString title;              // of the window, and so in the task bar
    QString voxels;             // in the status line
    QString description;        // of the series, in the tool bar
    QString whyThisOne;         // was chosen
    bool listsVolumes = false;  // whether the list of volumes, which may name patients, is shown

    bool operator==(const StudyTexts&) const = default;
};

// The one place where these come from: they are of the study that is open, whichever panes show it and
// whatever of it is drawn already. A study without a volume: none is open. Without names nothing is said that
// the files say of a person: neither name, nor date, nor description.
StudyTexts textsOf(const app::OpenedStudy& study, bool names);

// Each sentence once: what is said of a series is often said of its volume too.
QStringList withoutRepeats(const QStringList& notes);

// In place of what is told of the picture in 3D, in a layout that does not show it.
QString withoutVolumeText(app::Layout layout);

}  // namespace macula::viewer
