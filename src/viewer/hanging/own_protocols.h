// The hanging protocols of a person, kept in the study store between runs.
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/hanging/hanging_protocol.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// Each change is applied to the store's present content, which another window of the program may have
// changed. Without a store they last for the run. Lives on the UI thread.
class OwnProtocols : public QObject {
    Q_OBJECT

  public:
    // `folder` of the store; nothing: no store. Protocols arrive later, with `changed`.
    explicit OwnProtocols(std::optional<std::filesystem::path> folder, QObject* parent = nullptr);
    ~OwnProtocols() override;  // writes what waits

    const std::vector<study::HangingProtocol>& all() const { return all_; }
    // Fails as study::withHangingProtocol.
    Result<void> add(const study::HangingProtocol& protocol);
    void remove(const std::string& name);

  Q_SIGNALS:
    void changed();
    void failed(const macula::Error& error);  // they could not be read or stored

  private:
    using Protocols = std::vector<study::HangingProtocol>;
    struct Edit {
        std::string name;
        std::optional<study::HangingProtocol> added;  // nothing: removed
    };
    static Protocols edited(Protocols all, const std::vector<Edit>& edits);
    static Result<Protocols> keepIn(const std::filesystem::path& folder, const std::vector<Edit>& edits);
    void edit(Edit made);
    void keep();
    void onKept(const Result<Protocols>& kept);

    std::optional<std::filesystem::path> folder_;
    Protocols all_;
    std::vector<Edit> waiting_;
    std::vector<Edit> writing_;
    bool isBusy_ = false;
    std::optional<BackgroundJob<Protocols>> job_;
};

}  // namespace macula::viewer
