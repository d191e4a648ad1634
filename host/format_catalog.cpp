#include "format_catalog.h"

#include <algorithm>
#include <set>

#include <lumen/exporter.h>

#include "modules/registry.h"

namespace lumenshop {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string join(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text.empty() ? "none" : text;
}

}  // namespace

FormatCatalog::FormatCatalog(Registry& registry) : scratch_(registry) {
  for (const TypeInfo& type : registry.types()) {
    if (type.kind != lumen::Kind::importer && type.kind != lumen::Kind::exporter) continue;
    Instance& instance = scratch_.add(type.id);
    if (const auto* importer = instance.as<lumen::Importer>(lumen::Kind::importer))
      for (lumen::FileFormat& format : importer->formats()) importers_.push_back({&instance, std::move(format)});
    else if (const auto* exporter = instance.as<lumen::Exporter>(lumen::Kind::exporter))
      for (lumen::FileFormat& format : exporter->formats()) exporters_.push_back({&instance, std::move(format)});
  }
}

std::string FormatCatalog::importer_of(const std::filesystem::path& file) const {
  const std::string name = lower(file.filename().string());
  const Entry* best = nullptr;
  for (const Entry& entry : importers_)  // ".nii.gz" before ".gz"
    if (name.ends_with(entry.format.extension) && (!best || entry.format.extension.size() > best->format.extension.size())) best = &entry;
  if (best) return best->instance->type();
  const auto extensions = readable();
  throw lumen::Error(file.string(), "no importer reads this kind of file",
                     "these are read: " + join({extensions.begin(), extensions.end()}));
}

Instance& FormatCatalog::exporter_of(const std::filesystem::path& file, lumen::DataKind kind) const {
  const std::string name = lower(file.filename().string());
  const Entry* best = nullptr;
  std::set<std::string> writable;
  for (const Entry& entry : exporters_) {
    if (entry.format.data != kind) continue;
    writable.insert(entry.format.extension);
    if (name.ends_with(entry.format.extension) && (!best || entry.format.extension.size() > best->format.extension.size())) best = &entry;
  }
  if (best) return *best->instance;
  throw lumen::Error(file.string(), "no exporter writes this kind of file for " + std::string(lumen::name_of(kind)) + " data",
                     "these are written: " + join(writable));
}

std::vector<std::string> FormatCatalog::readable() const {
  std::set<std::string> extensions;
  for (const Entry& entry : importers_) extensions.insert(entry.format.extension);
  return {extensions.begin(), extensions.end()};
}

}  // namespace lumenshop
