// The window's texts about the open study, outside its panes.
#pragma once

#include <QString>
#include <QStringList>

#include "scene/state/study_state.h"
#include "study/open/opened_study.h"

namespace macula::viewer {

struct StudyTexts {
    QString title;              // in the title bar and the task bar
    QString voxels;             // in the status line
    QString description;        // the series, in the tool bar
    QString whyThisOne;         // why this volume was opened
    bool listsVolumes = false;  // whether the list of volumes, which may name patients, is shown

    bool operator==(const StudyTexts&) const = default;
};

// The only source of these texts, whichever panes show the study. A study without a volume counts as no
// study. With `names` false they hold no patient name, date or description from the files.
StudyTexts textsOf(const study::OpenedStudy& study, bool names);

// While images are shown instead of the open study (planar_controller.h).
StudyTexts textsOfImages(const study::Identity& identity, bool names);

// Removes repeated sentences: those of a series often recur for its volume.
QStringList withoutRepeats(const QStringList& notes);

// Replaces the text about the 3D picture in layouts without it; empty in others.
QString withoutVolumeText(scene::Layout layout);

}  // namespace macula::viewer
