#include "tests/server/wire/certificate.h"

#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>

namespace selvage::test {
namespace {

constexpr long kDay = 86400;

template <class Thing, class Free>
std::unique_ptr<Thing, Free> own(Thing* thing, Free free) {
  if (thing == nullptr) throw std::runtime_error{"no certificate"};
  return {thing, free};
}

}  // namespace

server::transport::access::TlsFiles write_certificate(const std::filesystem::path& folder) {
  const auto key = own(::EVP_EC_gen("P-256"), &::EVP_PKEY_free);
  const auto certificate = own(::X509_new(), &::X509_free);
  ::ASN1_INTEGER_set(::X509_get_serialNumber(certificate.get()), 1);
  ::X509_gmtime_adj(::X509_getm_notBefore(certificate.get()), -kDay);
  ::X509_gmtime_adj(::X509_getm_notAfter(certificate.get()), kDay);
  ::X509_set_pubkey(certificate.get(), key.get());
  X509_NAME* name = ::X509_get_subject_name(certificate.get());
  const std::string host = "localhost";
  ::X509_NAME_add_entry_by_txt(name, "CN", MBSTRING_UTF8, reinterpret_cast<const unsigned char*>(host.c_str()), -1, -1,
                               0);
  ::X509_set_issuer_name(certificate.get(), name);
  ::X509_sign(certificate.get(), key.get(), ::EVP_sha256());

  server::transport::access::TlsFiles files{(folder / "certificate.pem").string(), (folder / "key.pem").string()};
  const auto certificate_file = own(std::fopen(files.certificate.c_str(), "w"), &std::fclose);
  ::PEM_write_X509(certificate_file.get(), certificate.get());
  const auto key_file = own(std::fopen(files.key.c_str(), "w"), &std::fclose);
  ::PEM_write_PrivateKey(key_file.get(), key.get(), nullptr, nullptr, 0, nullptr, nullptr);
  return files;
}

}  // namespace selvage::test
