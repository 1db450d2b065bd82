// Decodes the phases of the open study in the background, and keeps those that fit.
#pragma once

#include <QObject>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "study/open/opened_study.h"
#include "study/open/phases.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// One phase at a time, nearest to the one that is asked for first. Numbers are places in the list of phases.
// Lives on the UI thread.
class PhaseLoader : public QObject {
    Q_OBJECT

  public:
    explicit PhaseLoader(QObject* parent = nullptr);

    // `volumes`: of each phase, in `source`. Keeps what it has of the same source.
    void setPhases(study::PhaseSource source, std::vector<std::size_t> volumes);
    bool isOf(const study::PhaseSource& source) const { return source_ == source; }
    // The open study is one of them: it need not be decoded again, and never makes room for others.
    void keepOpen(std::size_t phase, std::shared_ptr<const study::OpenedStudy> study);
    // `loaded` or `failed` follows, and `loaded` for further ones while they fit.
    void ask(std::size_t phase);
    // Null: not decoded yet.
    std::shared_ptr<const study::OpenedStudy> phase(std::size_t phase) const;
    std::size_t count() const { return volumes_.size(); }
    std::size_t loadedCount() const { return loaded_.size(); }
    bool hasAll() const { return loaded_.size() == volumes_.size(); }
    bool fits() const { return fits_; }  // false: memory is not enough for all phases
    // Why not all can be there at once; nothing while they may.
    std::optional<Error> whyNotAll() const;

  Q_SIGNALS:
    void loaded(std::size_t phase);
    void failed(std::size_t phase, const macula::Error& error);

  private:
    void startNext();
    bool makeRoom();
    std::optional<std::size_t> next() const;
    void take(const Result<study::OpenedStudy>& study);

    study::PhaseSource source_;
    std::vector<std::size_t> volumes_;
    std::map<std::size_t, std::shared_ptr<const study::OpenedStudy>> loaded_;  // by phase
    std::map<std::size_t, Error> failed_;
    std::size_t open_ = 0;
    std::size_t asked_ = 0;
    std::optional<std::size_t> loading_;
    bool fits_ = true;
    BackgroundJob<study::OpenedStudy> job_;
};

}  // namespace macula::viewer
