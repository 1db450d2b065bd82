// Which archive a manifest means: never one that only the manifest knows.
#include "study/manifest/manifest_source.h"

#include <gtest/gtest.h>

#include "dicom/support.h"

namespace macula::study {
namespace {

net::WebPeer serviceAt(std::string url) {
    net::WebPeer peer;
    peer.url = std::move(url);
    return peer;
}

class ManifestSourceTest : public ::testing::Test {
  protected:
    ManifestSourceTest() {
        net::Source web;
        web.name = "Cloud";
        web.peer = serviceAt("https://pacs.example.org/dicom-web");
        net::Source dimse;
        dimse.name = "Hospital";
        dimse.peer = net::DimsePeer{.host = "pacs.example.org", .calledAe = "ARCHIVE"};
        for (const net::Source& source : {web, dimse}) {
            const auto put = list_.put(source);
            EXPECT_TRUE(put) << put.error().message;
        }
    }
    static dicom::ManifestStudy studyAt(std::vector<dicom::RetrievePlace> places) {
        dicom::ManifestStudy study{"1.2", {}};
        for (dicom::RetrievePlace& place : places)
            study.series.push_back({"1.2.1", std::move(place), {{"1.3", "1.2.1.1"}}});
        return study;
    }
    std::string nameOf(const std::vector<dicom::RetrievePlace>& places) {
        const auto source = sourceOf(studyAt(places), list_);
        return source ? source->name : source.error().message.english() + " " + source.error().where;
    }

    dicom::test::TemporaryFolder folder_;
    net::SourceList list_ = *net::SourceList::read(
        {.managed = folder_ / "none", .own = folder_ / "own.json", .secrets = folder_ / "secrets.json"});
};

TEST_F(ManifestSourceTest, AnAddressIsOfAServiceOnlyIfAllOfItIs) {
    const net::WebPeer service = serviceAt("https://pacs.example.org/dicom-web");
    for (const char* url :
         {"https://pacs.example.org/dicom-web", "https://pacs.example.org/dicom-web/",
          "https://PACS.example.org:443/dicom-web/studies", "https://pacs.example.org/dicom-web/studies/1.2",
          "https://pacs.example.org/dicom-web/studies/1.2/series/1.3/",
          "https://pacs.example.org/dicom-web/studies/1.2/series/1.3/instances/1.4"})
        EXPECT_TRUE(isOfService(url, service, "1.2")) << url;
    for (const char* url :
         {"http://pacs.example.org/dicom-web/studies/1.2", "https://evil.example.org/dicom-web/studies/1.2",
          "https://pacs.example.org.evil.org/dicom-web",
          "https://pacs.example.org:8443/dicom-web/studies/1.2", "https://pacs.example.org/other/studies/1.2",
          "https://pacs.example.org/dicom-webs/studies/1.2", "https://pacs.example.org/dicom-web/../admin",
          "https://pacs.example.org/dicom-web/studies/a",
          "https://pacs.example.org/dicom-web/studies/1.2/%2e%2e/admin",
          "https://pacs.example.org/dicom-web/studies/9.9", "https://user:p@pacs.example.org/dicom-web",
          "https://pacs.example.org@evil.org/dicom-web/studies/1.2",
          "https://pacs.example.org/dicom-web/studies/1.2?x=1", "https://pacs.example.org/dicom-web#a",
          "https://pacs.example.org/dicom-web/studies/1.2/series/1.3/instances/1.4/frames/1",
          "file:///dicom-web/studies/1.2", "pacs.example.org/dicom-web", "", "https://"})
        EXPECT_FALSE(isOfService(url, service, "1.2")) << url;
    EXPECT_TRUE(isOfService("http://pacs:8042/studies/1.2", serviceAt("http://pacs:8042"), "1.2"));
}

TEST_F(ManifestSourceTest, AnArchiveThatIsSetUpIsFoundByAddressElseByAeTitle) {
    const std::string ours = "https://pacs.example.org/dicom-web/studies/1.2";
    EXPECT_EQ(nameOf({{.urls = {ours}}}), "Cloud");
    EXPECT_EQ(nameOf({{.urls = {"https://other.org/x", ours}}}), "Cloud") << "one of them is enough";
    EXPECT_EQ(nameOf({{.urls = {"https://other.org/x"}, .aeTitles = {"ARCHIVE"}}}), "Hospital");
    EXPECT_EQ(nameOf({{.urls = {ours}, .aeTitles = {"ARCHIVE"}}}), "Cloud") << "WADO-RS first";
}

TEST_F(ManifestSourceTest, AStrangersAddressIsToldAndNotFollowed) {
    const std::string told =
        nameOf({{.urls = {"https://studies.evil.org:8443/rs/studies/1.2/series/1.3?token=SECRET"}}});
    EXPECT_NE(told.find("no archive is set up. https://studies.evil.org:8443/rs"), std::string::npos) << told;
    EXPECT_TRUE(told.ends_with("/rs")) << told;
    EXPECT_EQ(nameOf({{.urls = {"https://user:SECRET@evil.org/rs"}}}).find("SECRET"), std::string::npos);
    EXPECT_NE(nameOf({{.aeTitles = {"STRANGER"}}}).find("STRANGER"), std::string::npos);
    EXPECT_NE(nameOf({{}}).find("does not say where"), std::string::npos);
    EXPECT_NE(nameOf({{.urls = {"https://pacs.example.org/dicom-web/studies/1.2"}},
                      {.urls = {"https://evil.org/rs/studies/1.2"}}})
                  .find("evil.org"),
              std::string::npos)
        << "one series elsewhere";
}

}  // namespace
}  // namespace macula::study
