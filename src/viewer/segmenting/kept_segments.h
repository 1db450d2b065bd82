// Own segments between runs of the program: stored with the study, or at least not lost unasked.
#pragma once

#include <QObject>
#include <QTimer>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "base/result.h"
#include "base/volume.h"
#include "study/segmentation/loaded_segmentation.h"
#include "viewer/editor/study_editor.h"
#include "viewer/segmentation/segmentation_keeper.h"

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

// Stores each revision soon after it was made, in the study store, as a document of the volume: it is purged
// with the study. Where there is no store, or the segments are too large for it, it keeps them in memory
// until the program ends, and says so. Lives on the UI thread; what it refers to outlives it.
class KeptSegments : public QObject {
    Q_OBJECT

  public:
    // `store` null: nothing is kept between runs.
    KeptSegments(StudyEditor& session, SegmentationKeeper& keeper, live::StudyKeeper* store,
                 QObject* parent = nullptr);

    void flush();            // hands over what waits to be stored
    bool isAllKept() const;  // false: some segments would be lost at the end of the program
    // The segments of the open volume, as they are now.
    struct Mark {
        std::string volume;
        std::shared_ptr<const study::LoadedSegmentation> revision;
    };
    Mark mark() const;
    void wereSaved(const Mark& mark);  // as a file: they may be lost, unless they changed since
    void giveUp();                     // all may be lost

  Q_SIGNALS:
    void looked();  // for the segments of the open study
    void failed(const macula::Error& error);

  private:
    using Revision = std::shared_ptr<const study::LoadedSegmentation>;
    struct Left {
        glm::ivec3 size{0};  // of the volume
        Revision revision;
        bool isKept = true;
    };

    void onStudyShown();
    void onOwnChanged();
    void look();
    void onFound(const Result<Revision>& found);
    void store(const std::string& series, const Revision& revision);
    static bool hasVoxels(const Revision& revision);

    StudyEditor& session_;
    SegmentationKeeper& keeper_;
    live::StudyKeeper* store_;
    std::map<std::string, Left> left_;  // by series and volume, of this run
    std::string series_;                // and volume that is open
    std::set<std::string> unread_;      // those whose stored segments could not be read: they stay stored
    bool isTaking_ = false;
    std::shared_ptr<const Volume> waiting_;  // its segments wait to be stored; null: none do
    QTimer soon_;
};

}  // namespace macula::viewer
