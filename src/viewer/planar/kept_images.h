// What is kept between runs of how a person left a series of images.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "session/store_values.h"
#include "study/planar/images_state.h"
#include "study/planar/planar_images.h"

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

// One series at a time. Lives on the UI thread.
class KeptImages : public QObject {
    Q_OBJECT

  public:
    explicit KeptImages(QObject* parent = nullptr);
    ~KeptImages() override;  // stores what waits

    void setKeeper(std::shared_ptr<live::StudyKeeper> keeper);  // null: nothing is kept
    // `found` follows later if something is kept of that series. Stores what waits of the one before.
    void open(const study::PlanarSeries& series);
    void close();
    // Stores it soon, if it differs from what is stored.
    void keep(const study::ImagesState& state);
    void keepNow();

  Q_SIGNALS:
    void found(const macula::study::ImagesState& state);

  private:
    void answer(const std::string& text);

    std::shared_ptr<live::StudyKeeper> keeper_;
    std::optional<session::OpenedVolume> opened_;  // nothing: no series that could be kept
    std::string name_;                             // of the document
    std::string stored_;                           // text
    std::optional<std::string> waiting_;           // text
    bool isAnswered_ = false;                      // the store said what was left the last time
    int openings_ = 0;  // counts, so that a late answer is not taken for another series
    QTimer timer_;
};

}  // namespace macula::viewer
