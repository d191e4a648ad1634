/// A binding that records what a plugin declares: no session, no links, every read gives the default or what was written.
#pragma once

#include <string>
#include <vector>

#include <lumen/plugin.h>

namespace lumenshop {

class ProbeBinding final : public lumen::Binding {
 public:
  explicit ProbeBinding(std::string id) : id_(std::move(id)) {}

  struct Entry {
    lumen::PropertySpec spec;
    lumen::Value value;
    bool set = false, retracted = false;
    std::uint64_t revision = 1;
  };
  const std::vector<Entry>& entries() const { return entries_; }
  /// What is wrong with the declarations, but not so wrong that a session could not use them: "radius: it has no doc".
  std::vector<std::string> complaints() const;

  const std::string& id() const override { return id_; }
  int declare(lumen::PropertySpec spec) override;
  void retract(int slot) override;
  const lumen::PropertySpec& spec(int slot) const override { return at(slot).spec; }
  const lumen::Value& read(int slot) const override { return at(slot).value; }
  void write(int slot, lumen::Value value) override;
  void write_default(int slot, lumen::Value value) override;
  bool is_set(int slot) const override { return at(slot).set; }
  std::uint64_t revision(int slot) const override { return at(slot).revision; }
  void link(int, const std::string&, const std::string&) override {}
  void unlink(int) override {}
  void observe(const std::string&, int) override {}
  void report(lumen::Severity, const std::string&) override {}

 private:
  const Entry& at(int slot) const { return entries_.at(static_cast<std::size_t>(slot)); }
  Entry& at(int slot) { return entries_.at(static_cast<std::size_t>(slot)); }

  std::string id_;
  std::vector<Entry> entries_;
};

}  // namespace lumenshop
