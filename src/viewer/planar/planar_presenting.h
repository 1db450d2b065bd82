// The presentation states of a series of images: which there are, and which one is chosen.
#pragma once

#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "study/planar/planar_presentation.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// Reads in the background. Lives on the UI thread.
class PlanarPresenting : public QObject {
    Q_OBJECT

  public:
    explicit PlanarPresenting(QObject* parent = nullptr);

    // Forgets the choice. Null: no images are shown.
    void setSeries(const study::FoundVolumes* found, const study::PlanarSeries& series);
    // "As stored", then each by label, creator and day; without names by number and day. Empty: there is
    // none to choose.
    QStringList names(bool withNames) const;
    int chosen() const { return chosen_; }           // in names()
    bool isWanted() const { return wanted_ != 0; }   // another than "As stored" is chosen, or is being read
    void choose(int index);                          // `chosenChanged` or `failed` follows, later or at once
    void choose(const std::filesystem::path& file);  // does nothing for a file that is not listed
    const dicom::SoftcopyState* state() const { return state_ ? &*state_ : nullptr; }  // null: as stored

  Q_SIGNALS:
    void chosenChanged();
    void failed(const macula::Error& error);

  private:
    void take(const Result<dicom::SoftcopyState>& read);

    std::vector<study::ListedPresentation> listed_;
    int chosen_ = 0;
    int wanted_ = 0;
    std::optional<dicom::SoftcopyState> state_;
    BackgroundJob<dicom::SoftcopyState> reading_;
};

}  // namespace macula::viewer
