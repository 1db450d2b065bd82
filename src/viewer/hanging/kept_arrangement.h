// What is kept between runs of the boxes that a person arranged for a study.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <string>

#include "session/store_values.h"
#include "study/hanging/kept_boxes.h"
#include "viewer/planar/image_boxes.h"

namespace macula::viewer {

// Boxes by digests of their series, and back; missing series leave empty boxes.
study::KeptBoxes keptOf(const BoxArrangement& arrangement);
BoxArrangement arrangementOf(const study::KeptBoxes& kept,
                             const std::shared_ptr<const study::FoundVolumes>& found, int patient);

// One study at a time. Lives on the UI thread.
class KeptArrangement : public QObject {
    Q_OBJECT

  public:
    explicit KeptArrangement(QObject* parent = nullptr);
    ~KeptArrangement() override;  // stores what waits

    void setKeeper(std::shared_ptr<live::StudyKeeper> keeper);  // null: nothing is kept
    void open(const dicom::Study& study);                       // `answered` follows, later or at once
    void close();
    void keep(const study::KeptBoxes& boxes);  // soon
    void keepNow();

  Q_SIGNALS:
    void answered(const std::optional<macula::study::KeptBoxes>& kept);

  private:
    std::shared_ptr<live::StudyKeeper> keeper_;
    std::optional<session::DocumentId> id_;
    std::string stored_;
    std::optional<std::string> waiting_;
    int openings_ = 0;  // counts, so that a late answer is not taken for another study
    QTimer timer_;
};

}  // namespace macula::viewer
