#include "study/manifest/manifest_source.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "net/archive/file_meta.h"
#include "net/web/web_address.h"

namespace macula::study {

namespace {

// The path of an address that was taken apart; empty, or it begins with a slash.
std::string_view pathOf(const net::WebAddress& address) {
    const std::string_view url = address.url;
    const std::size_t host = url.find("://");
    const std::size_t slash = host == std::string_view::npos ? host : url.find('/', host + 3);
    return slash == std::string_view::npos ? std::string_view() : url.substr(slash);
}

// Takes /NAME/UID from the beginning of the path; nothing where it does not begin so.
std::optional<std::string_view> takeLevel(std::string_view& path, std::string_view name) {
    if (!path.starts_with('/') || !path.substr(1).starts_with(name)) return {};
    std::string_view rest = path.substr(1 + name.size());
    if (!rest.starts_with('/')) return {};
    rest.remove_prefix(1);
    const std::size_t end = std::min(rest.find('/'), rest.size());
    const std::string_view uid = rest.substr(0, end);
    if (!net::isUid(uid)) return {};
    path = rest.substr(end);
    return uid;
}

// "", /studies/UID, /studies/UID/series/UID, and that with /instances/UID (PS3.18 10.4.1).
bool isOfStudy(std::string_view path, std::string_view studyInstanceUid) {
    if (path.empty() || path == "/studies") return true;
    if (takeLevel(path, "studies") != studyInstanceUid) return false;
    if (!path.empty() && !takeLevel(path, "series")) return false;
    if (!path.empty() && !takeLevel(path, "instances")) return false;
    return path.empty();
}

template <class IsOfPlace>
std::optional<net::Source> sourceOfAll(const dicom::ManifestStudy& study, const net::SourceList& sources,
                                       IsOfPlace isOfPlace) {
    for (const net::Source& source : sources.all()) {
        const bool hasAll = std::ranges::all_of(study.series, [&](const dicom::ManifestSeries& series) {
            return isOfPlace(source, series.place);
        });
        if (hasAll) return source;
    }
    return {};
}

// Without what stands behind the service, as a person would set it up; never a user name or a query.
std::string serviceOf(std::string url) {
    url = url.substr(0, url.find_first_of("?#"));
    const std::size_t host = url.find("://");
    const std::size_t begin = host == std::string::npos ? 0 : host + 3;
    url = url.substr(0, url.find("/studies", begin));
    const std::size_t at = url.substr(0, url.find('/', begin)).rfind('@');
    return at == std::string::npos || at < begin ? url : url.substr(0, begin) + url.substr(at + 1);
}

bool isOfWeb(const net::Source& source, const dicom::RetrievePlace& place, const std::string& study) {
    const auto* web = std::get_if<net::WebPeer>(&source.peer);
    return web != nullptr && std::ranges::any_of(place.urls, [&](const std::string& url) {
               return isOfService(url, *web, study);
           });
}

bool isOfTitle(const net::Source& source, const dicom::RetrievePlace& place) {
    const auto* dimse = std::get_if<net::DimsePeer>(&source.peer);
    return dimse != nullptr && std::ranges::find(place.aeTitles, dimse->calledAe) != place.aeTitles.end();
}

// A series that lies in no archive that is set up, or null.
const dicom::ManifestSeries* strangersSeries(const dicom::ManifestStudy& study,
                                             const net::SourceList& sources) {
    const auto found = std::ranges::find_if(study.series, [&](const dicom::ManifestSeries& series) {
        return std::ranges::none_of(sources.all(), [&](const net::Source& source) {
            return isOfWeb(source, series.place, study.studyInstanceUid) || isOfTitle(source, series.place);
        });
    });
    return found == study.series.end() ? nullptr : &*found;
}

// What the manifest says of the place is the error's `where`: a name could hide in it.
Error noSource(const dicom::ManifestStudy& study, const net::SourceList& sources) {
    const Text orName("Or say which archive has the study: macula fetch ARCHIVE --manifest FILE.");
    const Text name("Say which archive has the study: macula fetch ARCHIVE --manifest FILE.");
    const dicom::ManifestSeries* series = strangersSeries(study, sources);
    if (series == nullptr)
        return {ErrorCode::usage,
                Text("The manifest says that the series of a study lie in different archives."),
                {},
                name};
    const dicom::RetrievePlace& place = series->place;
    if (!place.urls.empty())
        return {
            ErrorCode::usage,
            Text("The manifest says that images lie at an address of which no archive is set up."),
            serviceOf(place.urls.front()),
            Text::joined({Text("If you trust this address, set it up as an archive, and open the manifest "
                               "again."),
                          orName},
                         " ")};
    if (!place.aeTitles.empty())
        return {
            ErrorCode::usage,
            Text("The manifest says that images lie in an archive whose AE title is not set up."),
            place.aeTitles.front(),
            Text::joined({Text("Set up the archive of this AE title, and open the manifest again."), orName},
                         " ")};
    return {ErrorCode::usage, Text("The manifest does not say where its images lie."), {}, name};
}

}  // namespace

bool isOfService(const std::string& url, const net::WebPeer& service, const std::string& studyInstanceUid) {
    const auto asked = net::webAddressOf(url);
    const auto known = net::webAddressOf(service.url);
    if (!asked || !known || asked->isSecure != known->isSecure || asked->host != known->host ||
        asked->port != known->port)
        return false;
    const std::string_view path = pathOf(*asked);
    const std::string_view base = pathOf(*known);
    return path.starts_with(base) && isOfStudy(path.substr(base.size()), studyInstanceUid);
}

Result<net::Source> sourceOf(const dicom::ManifestStudy& study, const net::SourceList& sources) {
    const auto byAddress =
        sourceOfAll(study, sources, [&](const net::Source& source, const dicom::RetrievePlace& place) {
            return isOfWeb(source, place, study.studyInstanceUid);
        });
    if (byAddress) return *byAddress;
    if (const auto byTitle = sourceOfAll(study, sources, isOfTitle)) return *byTitle;
    return noSource(study, sources);
}

}  // namespace macula::study
