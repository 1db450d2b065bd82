// Compares lesions of the open study with those of other studies of the patient.
#pragma once

#include <QObject>
#include <string>
#include <vector>

#include "live/store/kept_measurements.h"
#include "viewer/context/window_context.h"

class QMenu;

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

class SecondVolumeLoader;

// Knows the studies of the same patient in the folders of the study and of the second volume; what was
// measured on them comes from the states that are kept. Lives on the UI thread.
class FollowUpController : public QObject {
    Q_OBJECT

  public:
    // Both outlive it; no keeper: only the open study is known.
    FollowUpController(const WindowContext& context, const SecondVolumeLoader& second,
                       live::StudyKeeper* keeper);

    void addAction(QMenu& edit);

  private:
    // A study of the patient.
    struct Known {
        std::string date;  // YYYYMMDD
        live::StudyToRead read;
    };

    void ask();
    std::vector<Known> studies() const;  // the open one first
    void keepGone(const std::string& study, const std::vector<std::string>& lesions);
    void show(const std::vector<Known>& studies, const std::vector<live::KeptMeasurements>& kept);

    WindowContext context_;
    const SecondVolumeLoader& second_;
    live::StudyKeeper* keeper_;
};

}  // namespace macula::viewer
