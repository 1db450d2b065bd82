// Saves what is seen of an image as a picture, and measurements on images as a table.
#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <memory>
#include <vector>

#include "study/planar/image_measurement.h"
#include "study/planar/planar_images.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// The bytes of a file in a format of QImageWriter, "PNG" say, without anything but pixels. Fails with
// outputNotWritable.
Result<void> writePicture(const std::filesystem::path& path, const QImage& picture);

// Lives on the UI thread.
class PlanarSaving : public QObject {
    Q_OBJECT

  public:
    explicit PlanarSaving(const WindowContext& context);

    // Asks where to. Takes what is given now: while a person looks for a folder, other images may be shown.
    void savePicture(const QImage& picture);
    void saveMeasurements(std::shared_ptr<const study::FoundVolumes> found, const dicom::Stack* stack,
                          std::vector<study::ImageMeasurement> measurements);

  private:
    WindowContext context_;
    QString path_;  // of the table that is being written
    BackgroundJob<bool> writing_;
};

}  // namespace macula::viewer
