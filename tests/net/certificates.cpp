#include "net/certificates.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/rsa.h>
#include <openssl/x509v3.h>

#include <atomic>
#include <cstdio>
#include <memory>

namespace macula::net::test {

namespace {

using Key = std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)>;
using X509Certificate = std::unique_ptr<X509, decltype(&X509_free)>;
using OpenFile = std::unique_ptr<std::FILE, decltype(&std::fclose)>;

constexpr long kDay = 24L * 60 * 60;

void addExtension(X509& certificate, X509& issuer, int kind, const std::string& value) {
    X509V3_CTX context{};
    X509V3_set_ctx(&context, &issuer, &certificate, nullptr, nullptr, 0);
    X509_EXTENSION* extension = X509V3_EXT_conf_nid(nullptr, &context, kind, value.c_str());
    EXPECT_NE(extension, nullptr) << value;
    EXPECT_EQ(X509_add_ext(&certificate, extension, -1), 1);
    X509_EXTENSION_free(extension);
}

X509Certificate newCertificate(EVP_PKEY& key, const std::string& name, bool isExpired) {
    static std::atomic<long> serial{1};
    X509Certificate certificate(X509_new(), &X509_free);
    X509_set_version(certificate.get(), 2);
    ASN1_INTEGER_set(X509_get_serialNumber(certificate.get()), serial++);
    X509_gmtime_adj(X509_getm_notBefore(certificate.get()), -2 * kDay);
    X509_gmtime_adj(X509_getm_notAfter(certificate.get()), isExpired ? -kDay : kDay);
    X509_set_pubkey(certificate.get(), &key);
    X509_NAME_add_entry_by_txt(X509_get_subject_name(certificate.get()), "CN", MBSTRING_UTF8,
                               reinterpret_cast<const unsigned char*>(name.c_str()), -1, -1, 0);
    return certificate;
}

void signAndWrite(X509& certificate, EVP_PKEY& signedBy, EVP_PKEY& key, const Certificate& files,
                  const std::string& passphrase = {}) {
    ASSERT_GT(X509_sign(&certificate, &signedBy, EVP_sha256()), 0);
    const OpenFile certificateFile(std::fopen(files.certificate.c_str(), "w"), &std::fclose);
    ASSERT_EQ(PEM_write_X509(certificateFile.get(), &certificate), 1);
    const OpenFile keyFile(std::fopen(files.key.c_str(), "w"), &std::fclose);
    ASSERT_EQ(
        PEM_write_PKCS8PrivateKey(keyFile.get(), &key, passphrase.empty() ? nullptr : EVP_aes_128_cbc(),
                                  passphrase.data(), static_cast<int>(passphrase.size()), nullptr, nullptr),
        1);
}

}  // namespace

Authority::Authority(const std::filesystem::path& folder)
    : folder_(folder), own_{folder / "authority.pem", folder / "authority.key"} {
    const Key key(EVP_RSA_gen(2048), &EVP_PKEY_free);
    const X509Certificate certificate = newCertificate(*key, "Authority of a test", false);
    X509_set_issuer_name(certificate.get(), X509_get_subject_name(certificate.get()));
    addExtension(*certificate, *certificate, NID_basic_constraints, "critical,CA:TRUE");
    addExtension(*certificate, *certificate, NID_key_usage, "critical,keyCertSign,cRLSign");
    signAndWrite(*certificate, *key, *key, own_);
}

Certificate Authority::sign(const std::string& name, const CertificateOptions& options) const {
    const OpenFile authorityFile(std::fopen(own_.certificate.c_str(), "r"), &std::fclose);
    const OpenFile authorityKeyFile(std::fopen(own_.key.c_str(), "r"), &std::fclose);
    const X509Certificate authority(PEM_read_X509(authorityFile.get(), nullptr, nullptr, nullptr),
                                    &X509_free);
    const Key authorityKey(PEM_read_PrivateKey(authorityKeyFile.get(), nullptr, nullptr, nullptr),
                           &EVP_PKEY_free);
    const Key key(EVP_RSA_gen(2048), &EVP_PKEY_free);
    const X509Certificate certificate = newCertificate(*key, name, options.isExpired);
    X509_set_issuer_name(certificate.get(), X509_get_subject_name(authority.get()));
    in_addr address{};
    const bool isAddress = inet_pton(AF_INET, options.host.c_str(), &address) == 1;
    addExtension(*certificate, *authority, NID_basic_constraints, "critical,CA:FALSE");
    addExtension(*certificate, *authority, NID_subject_alt_name, (isAddress ? "IP:" : "DNS:") + options.host);
    const Certificate files{folder_ / (name + ".pem"), folder_ / (name + ".key")};
    signAndWrite(*certificate, *authorityKey, *key, files, options.keyPassphrase);
    return files;
}

}  // namespace macula::net::test
