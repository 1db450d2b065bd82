// The picture of a slice that a pane has on screen, and the one it has asked for.
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>

#include "viewer/slices/slice_sampler.h"

namespace macula::viewer {

// Another thread makes the pictures: the old one stays until the next. Lives on the UI thread.
class PanePicture : public QObject {
    Q_OBJECT

  public:
    PanePicture();
    ~PanePicture() override;

    // Takes the picture away and keeps no volume; what was asked for before no longer arrives.
    void forget();
    // Makes no picture twice that differs in its cross-hair alone, which lies over it. Sets `study` itself.
    void ask(SliceRequest request);

    // The picture on screen; null: none.
    const SlicePicture* shown() const { return shown_ ? &*shown_ : nullptr; }
    // The request of that picture; likewise.
    const SliceRequest* shownRequest() const { return shown_ ? &shown_->of : nullptr; }
    const SliceRequest* wanted() const { return wanted_ ? &*wanted_ : nullptr; }
    bool isUpToDate() const;

  Q_SIGNALS:
    void arrived();  // shown() is another one

  private:
    void take(SlicePicture picture);

    std::uint64_t study_ = 0;  // counts forget(): pictures of an earlier count are dropped
    std::optional<SliceRequest> wanted_;
    std::optional<SlicePicture> shown_;
    std::unique_ptr<SliceSampler> sampler_;
};

}  // namespace macula::viewer
