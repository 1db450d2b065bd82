// Fills the strip of series of the selected study: which they are, and how they look.
#pragma once

#include <QCache>
#include <QImage>
#include <QObject>
#include <QSet>
#include <QString>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "net/archive/picture_source.h"
#include "net/sources/source_list.h"
#include "study/archive/study_search.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

class SeriesStrip;

// Asks only archives that draw pictures, and only for series in view, few at once; another selection cancels
// it. What came is kept in memory alone. Lives on the UI thread.
class SeriesPictures : public QObject {
    Q_OBJECT

  public:
    // The strip lives until the window's destructor.
    SeriesPictures(SeriesStrip& strip, QObject* parent);

    // The study that is selected now; nothing without one.
    void select(const std::optional<study::ListedStudy>& study, const net::SourceList& sources);
    // Archives have been set up anew: what they do not offer is asked again.
    void forgetArchives();

  private:
    struct Drawn {
        QString key;
        QImage picture;  // null: there is none
    };
    using Job = BackgroundJob<Drawn>;

    void begin();
    void show(const Result<std::vector<net::FoundSeries>>& series);
    void askForPictures();
    void take(const Result<Drawn>& drawn);
    void clear();
    std::shared_ptr<net::PictureSource> picturesOf(const std::string& archive);
    QString keyOf(const net::FoundSeries& series) const;

    SeriesStrip& strip_;
    std::optional<study::ListedStudy> selected_;
    std::optional<net::SourceList> sources_;
    // By the name of the archive; null: it has none.
    std::map<std::string, std::shared_ptr<net::PictureSource>> archives_;
    std::shared_ptr<net::PictureSource> source_;  // of the selected study
    QTimer begins_;
    QSet<QString> asked_;               // of the selected study
    QCache<QString, QImage> pictures_;  // the cost is in bytes
    BackgroundJob<std::vector<net::FoundSeries>> finding_;
    std::vector<std::unique_ptr<Job>> drawing_;
};

}  // namespace macula::viewer
