// Counts a volume's values for its transfer function, in the background.
#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "base/volume.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/transfer/histogram.h"
#include "scene/transfer/value_axis.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// The histogram, and the foreground that some presets are fitted to, which needs a pass over every voxel.
// Lives on the UI thread.
class CountedValues : public QObject {
    Q_OBJECT

  public:
    CountedValues();

    void begin(std::shared_ptr<const Volume> volume);  // drops all counts; null: no volume
    // Replaces a count that is running; earlier results stay.
    void count(bool withForeground);
    bool isCounting() const { return job_.running(); }

    const std::optional<scene::Histogram>& histogram() const;  // nothing: not counted, or only padding
    // The map of preset values to the volume's; nothing until it is known. Needs a volume.
    std::optional<scene::ValueMap> mapFor(const TransferFunction& function) const;

  Q_SIGNALS:
    void counted();
    void failed(const macula::Error& error);

  private:
    struct Seen {
        std::optional<scene::Histogram> histogram;
        std::optional<ValueRange> foreground;  // the volume's range for a fit; nothing: not asked for
    };
    using SeenResult = std::shared_ptr<const Seen>;
    void take(const Result<SeenResult>& outcome);

    std::shared_ptr<const Volume> volume_;
    SeenResult seen_;
    BackgroundJob<SeenResult> job_;
};

}  // namespace macula::viewer
